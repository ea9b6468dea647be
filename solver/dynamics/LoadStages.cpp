#include "solver/dynamics/LoadStages.h"

#include "solver/Errors.h"
#include "solver/dynamics/LoadStage.h"

namespace vesicle
{

namespace
{

StokesOperator layer_of(const SystemShape& shape)
{
  std::vector<LayerSurface> surfaces;
  for (const VesicleShape& v : shape.vesicles)
    surfaces.push_back({ v.vesicle->layer.get(), v.surface->vertices, v.surface->control });
  return StokesOperator(std::move(surfaces));
}

// Of a vertex in its vesicle: a translation changes nothing.
double largest_move(const std::vector<Points>& from, const std::vector<Points>& to)
{
  double largest = 0;
  for (std::size_t v = 0; v < to.size(); ++v)
  {
    const Points move = to[v] - from[v];
    const Eigen::RowVector3d translation = move.colwise().mean();
    largest = std::max(largest, (move.rowwise() - translation).rowwise().norm().maxCoeff());
  }
  return largest;
}

}

void LoadStages::build(const SystemShape& shape)
{
  for (std::size_t v = 0; v < preconditioners_.size(); ++v)
    preconditioners_[v].build(*shape.vesicles[v].loads);
  made_for_ = shape.points;
}

// Good until the next stage.
LayerMap LoadStages::map_of(const StokesOperator& layer)
{
  if (layer.vertices() > most_dense_vertices)
    return [&](const std::vector<Eigen::VectorXd>& densities)
    {
      std::vector<ForceDensity> at_points;
      for (const Eigen::VectorXd& density : densities)
        at_points.push_back(nodal_density(rows_of_three(density)));
      return layer.apply(at_points);
    };
  for (std::size_t v = 0; v < matrices_.size(); ++v)
    layer.fill(static_cast<int>(v), matrices_[v]);
  return [this](const std::vector<Eigen::VectorXd>& densities)
  {
    Eigen::VectorXd velocity = matrices_.front() * densities.front();
    for (std::size_t v = 1; v < densities.size(); ++v)
      velocity += matrices_[v] * densities[v];
    return velocity;
  };
}

StageSolution LoadStages::solve(const SystemShape& shape, const Stage& stage, State& state)
{
  PreconditionerState& kept = state.preconditioner;
  if (kept.step == 0 || largest_move(kept.points, shape.points) > stale_displacement)
    kept = { shape.points, stage.step > 0 ? stage.step : 1 };
  if (made_for_ != kept.points)
  {
    if (kept.points == shape.points)
      build(shape);
    else // after a restart: where the uninterrupted run made it
      build(SystemShape(system_, kept.points));
  }
  for (std::size_t v = 0; v < preconditioners_.size(); ++v)
    if (shape.vesicles[v].loads->taut() || (shape.vesicles[v].loads->stiff() && stage.tau > 0))
      preconditioners_[v].build_stiff(*shape.vesicles[v].loads, stage.tau);
  const StokesOperator layer = layer_of(shape);
  StageSolution solution = LoadStage(shape, map_of(layer), stage.tau, stage.reference)
                             .solve(preconditioners_, stage.tolerance, max_iterations);
  state.iterations += solution.iterations;
  if (solution.iterations > stale_iterations)
    kept.step = 0; // the next solve makes a new one
  return solution;
}

}
