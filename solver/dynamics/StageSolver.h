#pragma once
// Poses and solves the linear problem of a stage, and keeps what preconditions it from one stage to
// the next: work that is saved and never changes a result.

#include "solver/dynamics/Method.h"
#include "solver/dynamics/StageSolution.h"
#include "solver/dynamics/State.h"
#include "solver/dynamics/SystemShape.h"

namespace vesicle
{

struct Stage
{
  double step = 0;           ///< dt of the time step that it belongs to
  double tau = 0;            ///< implicit time; 0: stiff forces are those of the shape
  Eigen::VectorXd reference; ///< velocities that the implicit response is measured from, or empty
  double tolerance = 1e-10;
};

class StageSolver
{
public:
  virtual ~StageSolver() = default;
  /// What the state remembers of the preconditioner is used, made again after a restart, and brought
  /// up to date; iterations are added to the state's. Throws NumericalError.
  virtual StageSolution solve(const SystemShape& shape, const Stage& stage, State& state) = 0;
};

/// On flat triangles densities have dense columns (StageSystem.h), on smooth surfaces loads are
/// applied (LoadStage.h) as `layer` says. The system must outlive the solver.
std::unique_ptr<StageSolver> make_stage_solver(const System& system, const LayerSettings& layer);

}
