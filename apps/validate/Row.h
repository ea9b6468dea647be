#pragma once
// One line of the validation: what is known, what this build computes, and whether they agree.

#include <optional>
#include <string>

namespace vesicle::validation
{

struct Row
{
  enum class Kind
  {
    relative, ///< error = |computed/reference − 1|
    absolute, ///< error = |computed − reference|
    at_most,  ///< computed may not exceed the reference; error = what it exceeds it by
    at_least  ///< computed may not fall below the reference; error = what it falls short by
  };
  std::string name; ///< case/what
  Kind kind = Kind::relative;
  double reference = 0;
  double computed = 0;
  double error = 0;
  double tolerance = 0; ///< of the error; 0 for bounds
  bool passed = false;
  double seconds = 0; ///< since the row before
  std::string note;   ///< where the tolerance comes from, or why there is no number
};

/// `computed` judged; whatever isn't finite fails.
Row judge(Row::Kind kind, const std::string& name, double reference, double computed,
  double tolerance, const std::string& note = {});

Row relative(const std::string& name, double reference, double computed, double tolerance,
  const std::string& note = {});
Row absolute(const std::string& name, double reference, double computed, double tolerance,
  const std::string& note = {});
Row at_most(const std::string& name, double limit, double computed, const std::string& note = {});
Row at_least(const std::string& name, double limit, double computed, const std::string& note = {});
/// A row that has no number because its computation stopped.
Row stopped(const std::string& name, const std::string& why);

}
