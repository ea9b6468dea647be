#pragma once
// No step could be made from a state.

#include "solver/Errors.h"
#include "solver/dynamics/State.h"

#include <memory>

namespace vesicle
{

struct StepFailure : NumericalError
{
  StepFailure(const std::string& message, std::shared_ptr<const State> last_attempt)
    : NumericalError(message), attempted(std::move(last_attempt))
  {
  }
  /// What the last attempt came to, not solved, or null where none came so far.
  std::shared_ptr<const State> attempted;
};

}
