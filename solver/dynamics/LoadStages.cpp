#include "solver/dynamics/LoadStages.h"

#include "solver/Errors.h"
#include "solver/ParallelFor.h"
#include "solver/dynamics/LoadStage.h"

namespace vesicle
{

namespace
{

// Of a vertex in its vesicle: a translation changes nothing.
double largest_move(const Points& from, const Points& to)
{
  const Points move = to - from;
  const Eigen::RowVector3d translation = move.colwise().mean();
  return (move.rowwise() - translation).rowwise().norm().maxCoeff();
}

}

// Of the vesicles that have none for these points. After a restart they are made where the
// uninterrupted run made them.
void LoadStages::build(const SystemShape& shape, const std::vector<Points>& points)
{
  made_for_.resize(points.size());
  parallel_for(points.size(),
    [&](std::size_t v)
    {
      if (made_for_[v].rows() == points[v].rows() && made_for_[v] == points[v])
        return;
      if (points[v] == shape.points[v])
        preconditioners_[v].build(*shape.vesicles[v].loads);
      else
      {
        const Vesicle& vesicle = system_.vesicles[v];
        preconditioners_[v].build(*VesicleShape(
          vesicle, std::make_unique<const Surface>(*vesicle.space, points[v]), system_.rate())
                                     .loads);
      }
      made_for_[v] = points[v];
    });
}

void LoadStages::build_stiff(const SystemShape& shape, double tau)
{
  parallel_for(preconditioners_.size(),
    [&](std::size_t v)
    {
      if (const VesicleLoads& loads = *shape.vesicles[v].loads;
          loads.taut() || (loads.stiff() && tau > 0))
        preconditioners_[v].build_stiff(loads, tau);
    });
}

LayerMaps LoadStages::maps_of(const SystemShape& shape) const
{
  std::vector<double> contrasts;
  for (const Vesicle& vesicle : system_.vesicles)
    contrasts.push_back(1 - vesicle.viscosity_ratio);
  return layer_maps(layer_surfaces(shape), contrasts, layer_, system_.wall);
}

StageSolution LoadStages::solve(const SystemShape& shape, const Stage& stage, State& state)
{
  PreconditionerState& kept = state.preconditioner;
  const bool none = kept.step == 0;
  if (none)
    kept.points = shape.points;
  for (std::size_t v = 0; v < kept.points.size(); ++v)
    if (none || largest_move(kept.points[v], shape.points[v]) > stale_displacement)
    {
      kept.points[v] = shape.points[v];
      kept.step = stage.step > 0 ? stage.step : 1;
    }
  build(shape, kept.points);
  LayerMaps layers;
  run_together({ [&] { layers = maps_of(shape); }, [&] { build_stiff(shape, stage.tau); } });
  StageSolution solution = LoadStage(shape, layers, stage.tau, stage.reference, state)
                             .solve(preconditioners_, stage.tolerance, max_iterations);
  state.iterations += solution.iterations;
  if (solution.iterations > stale_iterations)
    kept.step = 0; // the next solve makes a new one
  return solution;
}

}
