#include "solver/dynamics/LoadStages.h"

#include "solver/Errors.h"
#include "solver/dynamics/LoadStage.h"

namespace vesicle
{

namespace
{

// The part of the preconditioner that depends on the shape alone is made anew where a vertex has
// moved that far in its vesicle, in r0, or more iterations were needed.
constexpr double stale_displacement = 0.05;
constexpr int stale_iterations = 40;
constexpr int max_iterations = 200;

LayerMap layer_of(const SystemShape& shape)
{
  std::vector<LayerSurface> surfaces;
  for (const VesicleShape& v : shape.vesicles)
    surfaces.push_back({ v.vesicle->layer.get(), v.surface->vertices, v.surface->control });
  const auto layer = std::make_shared<const StokesOperator>(std::move(surfaces));
  if (shape.vertices() > most_dense_vertices)
    return [layer](const std::vector<Eigen::VectorXd>& densities)
    {
      std::vector<ForceDensity> at_points;
      for (const Eigen::VectorXd& density : densities)
        at_points.push_back(nodal_density(rows_of_three(density)));
      return layer->apply(at_points);
    };
  auto matrices = std::make_shared<std::vector<DenseMatrix>>();
  for (std::size_t v = 0; v < shape.vesicles.size(); ++v)
    matrices->push_back(layer->matrix(static_cast<int>(v)));
  return [matrices](const std::vector<Eigen::VectorXd>& densities)
  {
    Eigen::VectorXd velocity = multiply(matrices->front(), densities.front());
    for (std::size_t v = 1; v < densities.size(); ++v)
      velocity += multiply((*matrices)[v], densities[v]);
    return velocity;
  };
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
  const StageSolution solution = LoadStage(shape, layer_of(shape), stage.tau, stage.reference)
                                   .solve(preconditioners_, stage.tolerance, max_iterations);
  state.iterations += solution.iterations;
  if (solution.iterations > stale_iterations)
    kept.step = 0; // the next solve makes a new one
  return solution;
}

}
