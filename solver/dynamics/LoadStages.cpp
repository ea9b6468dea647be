#include "solver/dynamics/LoadStages.h"

#include "solver/Errors.h"
#include "solver/ParallelFor.h"
#include "solver/dynamics/LoadStage.h"
#include "solver/stokes/DoubleLayer.h"
#include "solver/stokes/TreeSum.h"
#include "solver/stokes/WallImages.h"

#include <algorithm>

namespace vesicle
{

namespace
{

// Above, a tree is faster (docs/performance.md).
constexpr double most_direct_pairs = 1e8;

// Of a vertex in its vesicle: a translation changes nothing.
double largest_move(const Points& from, const Points& to)
{
  const Points move = to - from;
  const Eigen::RowVector3d translation = move.colwise().mean();
  return (move.rowwise() - translation).rowwise().norm().maxCoeff();
}

template<PointKind kind>
std::unique_ptr<const PointSum> far_sum(
  const RowVectors& points, const Points& vertices, const LayerSettings& layer)
{
  const double pairs = static_cast<double>(points.rows()) * static_cast<double>(vertices.rows());
  if (layer.method == LayerMethod::tree ||
    (layer.method == LayerMethod::automatic && pairs > most_direct_pairs))
    return std::make_unique<TreePointSum<kind>>(points, vertices, layer.tree_tolerance);
  return std::make_unique<DirectPointSum<kind>>(points, vertices);
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
  const StokesOperator layer(layer_surfaces(shape));
  LayerMaps maps{ single_layer(layer), contrast(layer) };
  if (system_.wall)
    add_images(layer, maps);
  return maps;
}

Precision LoadStages::allowed(Precision precision) const
{
  return layer_.precision == LayerPrecision::mixed ? precision : Precision::full;
}

static std::vector<double> contrasts(const System& system)
{
  std::vector<double> factors;
  for (const Vesicle& vesicle : system.vesicles)
    factors.push_back(1 - vesicle.viscosity_ratio);
  return factors;
}

// The wall's, whatever applies the layers themselves.
void LoadStages::add_images(const StokesOperator& surfaces, LayerMaps& maps) const
{
  const auto images = std::make_shared<const WallImages>(surfaces, *system_.wall, PointKind::force,
    std::vector<double>(system_.vesicles.size(), 1),
    [&](const RowVectors& points, const Points& vertices)
    { return far_sum<PointKind::force_image>(points, vertices, layer_); });
  maps.single = [images, alone = std::move(maps.single), this](
                  const std::vector<Eigen::VectorXd>& densities, Precision precision)
  {
    Eigen::VectorXd velocity = alone(densities, precision);
    images->add(densities, allowed(precision), velocity);
    return velocity;
  };
  if (!maps.contrast)
    return;
  const auto of_contrast = std::make_shared<const WallImages>(surfaces, *system_.wall,
    PointKind::stresslet, contrasts(system_),
    [&](const RowVectors& points, const Points& vertices)
    { return far_sum<PointKind::stresslet_image>(points, vertices, layer_); });
  maps.contrast = [of_contrast, alone = std::move(maps.contrast), this](
                    const std::vector<Eigen::VectorXd>& nodal, const Eigen::VectorXd& at_vertices,
                    Precision precision)
  {
    Eigen::VectorXd velocity = alone(nodal, at_vertices, precision);
    of_contrast->add(nodal, allowed(precision), velocity);
    return velocity;
  };
}

ContrastMap LoadStages::contrast(const StokesOperator& surfaces) const
{
  const std::vector<double> factors = contrasts(system_);
  if (std::all_of(factors.begin(), factors.end(), [](double factor) { return factor == 0; }))
    return {};
  const auto layer = std::make_shared<const DoubleLayer>(surfaces, factors,
    [&](const RowVectors& points, const Points& vertices)
    { return far_sum<PointKind::stresslet>(points, vertices, layer_); });
  return [layer, this](const std::vector<Eigen::VectorXd>& nodal,
           const Eigen::VectorXd& at_vertices, Precision precision)
  { return layer->apply(nodal, at_vertices, allowed(precision)); };
}

LayerMap LoadStages::single_layer(const StokesOperator& layer) const
{
  if (layer_.method != LayerMethod::dense)
  {
    const auto sum = std::make_shared<const LayerSum>(layer,
      [&](const RowVectors& points, const Points& vertices)
      { return far_sum<PointKind::force>(points, vertices, layer_); });
    return [sum, this](const std::vector<Eigen::VectorXd>& densities, Precision precision)
    { return sum->apply(densities, allowed(precision)); };
  }
  const auto matrices = std::make_shared<std::vector<DenseMatrix>>();
  for (int v = 0; v < layer.surfaces(); ++v)
    matrices->push_back(layer.matrix(v));
  return [matrices](const std::vector<Eigen::VectorXd>& densities, Precision)
  {
    Eigen::VectorXd velocity = multiply(matrices->front(), densities.front());
    for (std::size_t v = 1; v < densities.size(); ++v)
      velocity += multiply((*matrices)[v], densities[v]);
    return velocity;
  };
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
