#pragma once
// The plans of all patterns that were met: matrices of one mesh have a few, shape after shape.

#include "solver/linear/EliminationPlan.h"

#include <memory>
#include <mutex>

namespace vesicle
{

/// May be used by several threads.
class EliminationPlans
{
public:
  /// Made where none fits.
  std::shared_ptr<const EliminationPlan> of(const SymmetricMatrix& A) const;

private:
  mutable std::mutex mutex_;
  mutable std::vector<std::shared_ptr<const EliminationPlan>> known_;
};

}
