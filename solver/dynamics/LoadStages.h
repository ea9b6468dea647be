#pragma once
// Stages on smooth surfaces: loads are applied, with a local preconditioner for each vesicle.

#include "solver/dynamics/LoadStage.h"
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
    : system_(system), preconditioners_(system.vesicles.size()), matrices_(system.vesicles.size())
  {
  }
  StageSolution solve(const SystemShape& shape, const Stage& stage, State& state) override;

private:
  // The part of the preconditioner that depends on the shape alone is made anew where a vertex has
  // moved that far in its vesicle, in r0, or more iterations were needed.
  static constexpr double stale_displacement = 0.05;
  static constexpr int stale_iterations = 40, max_iterations = 200;

  void build(const SystemShape& shape);
  LayerMap map_of(const StokesOperator& layer);

  const System& system_;
  std::vector<LocalPreconditioner> preconditioners_;
  std::vector<Points> made_for_;
  std::vector<LayerMatrix> matrices_; ///< of the last stage
};

}
