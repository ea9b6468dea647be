// Stages on flat triangles: dense columns and a factorisation of the whole system.
#include "solver/dynamics/CollocatedStages.h"

#include "solver/Errors.h"
#include "solver/dynamics/StageSystem.h"

namespace vesicle
{

namespace
{

// Above this many iterations a new factorisation pays for itself in the following solves.
constexpr int stale_iterations = 12;
// A factorisation helps only near the step it was made for.
constexpr double stale_step_ratio = 2;
constexpr int max_iterations = 60;

}

void CollocatedStages::factorize(
  const StageSystem& stage, const SystemShape& shape, const Stage& of, State& state)
{
  preconditioner_.build(stage);
  made_for_ = { shape.points, of.step };
  state.preconditioner = made_for_;
}

// After a restart the factorisation is made again where the uninterrupted run made it.
void CollocatedStages::restore(const Stage& stage, const State& state)
{
  const PreconditionerState& wanted = state.preconditioner;
  if (wanted.step == 0 || (made_for_.step == wanted.step && made_for_.points == wanted.points))
    return;
  const SystemShape there(system_, wanted.points);
  const std::vector<Mobility> mobility = mobilities(there);
  State unused;
  const Stage made{ wanted.step, stage.tau / stage.step * wanted.step, {}, 0 };
  factorize(StageSystem(there, mobility, made.tau, {}), there, made, unused);
}

StageSolution CollocatedStages::solve(const SystemShape& shape, const Stage& stage, State& state)
{
  restore(stage, state);
  const std::vector<Mobility> mobility = mobilities(shape);
  const StageSystem system(shape, mobility, stage.tau, stage.reference);
  const auto solve = [&] { return system.solve(preconditioner_, stage.tolerance, max_iterations); };
  const double ratio = state.preconditioner.step > 0 ? stage.step / state.preconditioner.step : 0;
  const bool fresh = !(ratio < stale_step_ratio && ratio > 1 / stale_step_ratio) ||
    preconditioner_.size() != system.unknowns();
  if (system.unknowns() > 0 && fresh)
    factorize(system, shape, stage, state);
  StageSolution solution;
  try
  {
    solution = solve();
  }
  catch (const NumericalError&)
  {
    if (fresh)
      throw;
    factorize(system, shape, stage, state);
    solution = solve();
  }
  state.iterations += solution.iterations;
  if (solution.iterations > stale_iterations)
    state.preconditioner.step = 0; // the next solve makes a new one
  return solution;
}

}
