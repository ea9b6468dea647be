#include "solver/flow/FourRollMill.h"

#include <algorithm>
#include <cmath>

namespace vesicle
{
namespace
{

FlowKind four_roll_description()
{
  FlowParameter type = flow_parameter("type", Dimension::number, &FourRollMill::type,
    "α: 1 planar extension, 0 shear along x = −z, −1 rotation");
  type.required = false;
  return { "four-roll", "", "", "four-roll mill",
    "u = (rate/2) [((1 + α) x + (1 − α) z) e_x − ((1 − α) x + (1 + α) z) e_z]",
    { flow_parameter("rate", Dimension::rate, &FourRollMill::rate, "of the mill, of any sign"),
      type },
    make_flow<FourRollMill> };
}

}

const FlowKind& FourRollMill::description()
{
  static const FlowKind kind = four_roll_description();
  return kind;
}

Vector3 FourRollMill::velocity_at(const Vector3& x) const
{
  const double strain = rate / 2 * (1 + type), spin = rate / 2 * (1 - type);
  return { strain * x.x() + spin * x.z(), 0, -spin * x.x() - strain * x.z() };
}

double FourRollMill::imposed_rate() const
{
  return std::abs(rate) * std::max(1., std::abs(type));
}

}
