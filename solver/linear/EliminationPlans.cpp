#include "solver/linear/EliminationPlans.h"

namespace vesicle
{

std::shared_ptr<const EliminationPlan> EliminationPlans::of(const SymmetricMatrix& A) const
{
  const std::lock_guard lock(mutex_);
  for (const auto& plan : known_)
    if (plan->fits(A))
      return plan;
  return known_.emplace_back(std::make_shared<const EliminationPlan>(A));
}

}
