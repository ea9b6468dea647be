#include "solver/stokes/LayerSum.h"

#include "solver/surface/Collocation.h"

namespace vesicle
{

std::unique_ptr<const PointSum> LayerSum::direct_sum(const PointPlaces& places)
{
  return std::make_unique<DirectSum>(places.sources, places.targets);
}

LayerSum::LayerSum(const StokesOperator& layer, const MakePointSum& make_sum)
  : sum_(make_sum(layer.places())), vertices_(layer.vertices())
{
  for (int s = 0; s < layer.surfaces(); ++s)
  {
    const Eigen::VectorXd& weight = layer.regular_points(s).weight;
    sources_.push_back({ &layer.surface(s).rules->regular().table, weight, layer.first_vertex(s),
      points_, layer.corrections(s, PointKind::force) });
    points_ += static_cast<int>(weight.size());
  }
}

Eigen::VectorXd LayerSum::apply(const std::vector<Eigen::VectorXd>& densities, double allowed) const
{
  RowVectors forces(points_, 3);
  for (std::size_t s = 0; s < sources_.size(); ++s)
    forces.middleRows(sources_[s].first_point, sources_[s].weight.size()) =
      sources_[s].weight.asDiagonal() *
      interpolate(*sources_[s].table, rows_of_three(densities[s]));
  Points velocity = Points::Zero(vertices_, 3);
  sum_->add(forces, allowed, velocity);
  for (std::size_t s = 0; s < sources_.size(); ++s)
  {
    sources_[s].corrections.add(densities[s], sources_[s].first_vertex, velocity);
  }
  return velocity.reshaped<Eigen::RowMajor>();
}

}
