#pragma once
// Stages on smooth surfaces: loads are applied, with a local preconditioner for each vesicle.

#include "solver/dynamics/LoadStage.h"
#include "solver/dynamics/LocalPreconditioner.h"
#include "solver/dynamics/StageSolver.h"

namespace vesicle
{

class LoadStages final : public StageSolver
{
public:
  LoadStages(const System& system, const LayerSettings& layer)
    : system_(system), layer_(layer), preconditioners_(system.vesicles.size())
  {
  }
  StageSolution solve(const SystemShape& shape, const Stage& stage, State& state) override;

private:
  // The part of the preconditioner that depends on the shape alone is made anew where a vertex has
  // moved that far in its vesicle, in r0, or more iterations were needed.
  static constexpr double stale_displacement = 0.05;
  static constexpr int stale_iterations = 40, max_iterations = 200;

  void build(const SystemShape& shape, const std::vector<Points>& points);
  void build_stiff(const SystemShape& shape, double tau);
  LayerMaps maps_of(const SystemShape& shape) const;

  const System& system_;
  LayerSettings layer_;
  std::vector<LocalPreconditioner> preconditioners_;
  std::vector<Points> made_for_;
};

}
