#include "apps/Attempts.h"

#include "solver/Errors.h"

#include <fmt/format.h>

namespace vesicle
{

void Attempts::require_success() const
{
  if (!failures_.empty())
  {
    throw IoError(fmt::format("{}", fmt::join(failures_, "\n")));
  }
}

}
