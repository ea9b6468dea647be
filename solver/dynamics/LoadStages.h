#pragma once
// Stages on smooth surfaces: loads are applied, with a local preconditioner for each vesicle.

#include "solver/dynamics/LocalPreconditioner.h"
#include "solver/dynamics/StageSolver.h"

namespace vesicle
{

/// Up to that many vertices the layer is a dense matrix, which costs less than its sums.
inline constexpr Eigen::Index most_dense_vertices = 3000;

class LoadStages final : public StageSolver
{
public:
  explicit LoadStages(const System& system)
    : system_(system), preconditioners_(system.vesicles.size())
  {
  }
  StageSolution solve(const SystemShape& shape, const Stage& stage, State& state) override;

private:
  void build(const SystemShape& shape);

  const System& system_;
  std::vector<LocalPreconditioner> preconditioners_;
  std::vector<Points> made_for_;
};

}
