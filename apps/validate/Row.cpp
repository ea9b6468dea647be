#include "apps/validate/Row.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vesicle::validation
{
namespace
{

double error_of(Row::Kind kind, double reference, double computed)
{
  switch (kind)
  {
    case Row::Kind::relative:
      return std::abs(computed / reference - 1);
    case Row::Kind::absolute:
      return std::abs(computed - reference);
    case Row::Kind::at_most:
      return computed > reference ? computed - reference : 0;
    default:
      return computed < reference ? reference - computed : 0;
  }
}

}

Row judge(Row::Kind kind, const std::string& name, double reference, double computed,
  double tolerance, const std::string& note)
{
  const double error = error_of(kind, reference, computed);
  const bool passed = std::isfinite(computed) && std::isfinite(error) && error <= tolerance;
  return { name, kind, reference, computed, error, tolerance, passed, 0, note };
}

Row relative(const std::string& name, double reference, double computed, double tolerance,
  const std::string& note)
{
  return judge(Row::Kind::relative, name, reference, computed, tolerance, note);
}

Row absolute(const std::string& name, double reference, double computed, double tolerance,
  const std::string& note)
{
  return judge(Row::Kind::absolute, name, reference, computed, tolerance, note);
}

Row at_most(const std::string& name, double limit, double computed, const std::string& note)
{
  return judge(Row::Kind::at_most, name, limit, computed, 0, note);
}

Row at_least(const std::string& name, double limit, double computed, const std::string& note)
{
  return judge(Row::Kind::at_least, name, limit, computed, 0, note);
}

Row stopped(const std::string& name, const std::string& why)
{
  const double none = std::numeric_limits<double>::quiet_NaN();
  return judge(Row::Kind::absolute, name, none, none, 0, why);
}

}
