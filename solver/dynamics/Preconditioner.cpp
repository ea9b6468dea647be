#include "solver/dynamics/Preconditioner.h"

#include "solver/dynamics/StageSystem.h"

namespace vesicle
{

void DensePreconditioner::build(const StageSystem& system)
{
  factorization_.compute(system.dense());
}

}
