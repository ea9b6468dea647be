#include "solver/dynamics/LayerMaps.h"

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

template<PointKind kind>
std::unique_ptr<const PointSum> far_sum(const PointPlaces& places, const LayerSettings& layer)
{
  const double pairs =
    static_cast<double>(places.sources.rows()) * static_cast<double>(places.targets.rows());
  if (layer.method == LayerMethod::tree ||
    (layer.method == LayerMethod::automatic && pairs > most_direct_pairs))
    return std::make_unique<TreePointSum<kind>>(places, layer.tree_tolerance);
  return std::make_unique<DirectPointSum<kind>>(places.sources, places.targets);
}

double error_of(LayerPrecision precision, double allowed)
{
  return precision == LayerPrecision::mixed ? allowed : 0;
}

ContrastMap contrast(const StokesOperator& surfaces, const std::vector<double>& contrasts,
  const LayerSettings& settings)
{
  if (std::all_of(contrasts.begin(), contrasts.end(), [](double factor) { return factor == 0; }))
    return {};
  const auto layer = std::make_shared<const DoubleLayer>(surfaces, contrasts,
    [&](const PointPlaces& places) { return far_sum<PointKind::stresslet>(places, settings); });
  return [layer, precision = settings.precision](const std::vector<Eigen::VectorXd>& nodal,
           const Eigen::VectorXd& at_vertices, double allowed)
  { return layer->apply(nodal, at_vertices, error_of(precision, allowed)); };
}

LayerMap single_layer(const StokesOperator& layer, const LayerSettings& settings)
{
  if (settings.method != LayerMethod::dense)
  {
    const auto sum = std::make_shared<const LayerSum>(layer,
      [&](const PointPlaces& places) { return far_sum<PointKind::force>(places, settings); });
    return [sum, precision = settings.precision](const std::vector<Eigen::VectorXd>& densities,
             double allowed) { return sum->apply(densities, error_of(precision, allowed)); };
  }
  const auto matrices = std::make_shared<std::vector<DenseMatrix>>();
  for (int v = 0; v < layer.surfaces(); ++v)
    matrices->push_back(layer.matrix(v));
  return [matrices](const std::vector<Eigen::VectorXd>& densities, double)
  {
    Eigen::VectorXd velocity = multiply(matrices->front(), densities.front());
    for (std::size_t v = 1; v < densities.size(); ++v)
      velocity += multiply((*matrices)[v], densities[v]);
    return velocity;
  };
}

// The wall's, whatever applies the layers themselves.
void add_images(const StokesOperator& surfaces, const std::vector<double>& contrasts,
  const LayerSettings& settings, const Wall& wall, LayerMaps& maps)
{
  const LayerPrecision precision = settings.precision;
  const auto images = std::make_shared<const WallImages>(surfaces, wall, PointKind::force,
    std::vector<double>(contrasts.size(), 1),
    [&](const PointPlaces& places) { return far_sum<PointKind::force_image>(places, settings); });
  maps.single = [images, precision, alone = std::move(maps.single)](
                  const std::vector<Eigen::VectorXd>& densities, double allowed)
  {
    Eigen::VectorXd velocity = alone(densities, allowed);
    images->add(densities, error_of(precision, allowed), velocity);
    return velocity;
  };
  if (!maps.contrast)
    return;
  const auto of_contrast =
    std::make_shared<const WallImages>(surfaces, wall, PointKind::stresslet, contrasts,
      [&](const PointPlaces& places)
      { return far_sum<PointKind::stresslet_image>(places, settings); });
  maps.contrast =
    [of_contrast, precision, alone = std::move(maps.contrast)](
      const std::vector<Eigen::VectorXd>& nodal, const Eigen::VectorXd& at_vertices, double allowed)
  {
    Eigen::VectorXd velocity = alone(nodal, at_vertices, allowed);
    of_contrast->add(nodal, error_of(precision, allowed), velocity);
    return velocity;
  };
}

}

LayerMaps layer_maps(std::vector<LayerSurface> surfaces, const std::vector<double>& contrasts,
  const LayerSettings& settings, const std::optional<Wall>& wall)
{
  const StokesOperator layer(std::move(surfaces));
  LayerMaps maps{ single_layer(layer, settings), contrast(layer, contrasts, settings) };
  if (wall)
    add_images(layer, contrasts, settings, *wall, maps);
  return maps;
}

}
