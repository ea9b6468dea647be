#include "apps/Attempts.h"

#include "solver/Errors.h"
#include "solver/Joined.h"

namespace vesicle
{

void Attempts::require_success() const
{
  if (!failures_.empty())
  {
    throw IoError(joined(failures_, "\n"));
  }
}

}
