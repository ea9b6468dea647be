#include "solver/stokes/LayerSum.h"

#include "solver/surface/Collocation.h"

namespace vesicle
{

std::unique_ptr<const PointSum> LayerSum::direct_sum(
  const RowVectors& points, const Points& vertices)
{
  return std::make_unique<DirectSum>(points, vertices);
}

LayerSum::LayerSum(const std::vector<LayerSurface>& surfaces, const MakePointSum& make_sum)
{
  const StokesOperator layer(surfaces);
  for (int s = 0; s < static_cast<int>(surfaces.size()); ++s)
  {
    const LayerPoints& at = layer.regular_points(s);
    sources_.push_back(
      { &surfaces[s].rules->regular().table, at.weight, vertices_, points_, layer.corrections(s) });
    vertices_ += surfaces[s].rules->vertices();
    points_ += static_cast<int>(at.weight.size());
  }
  RowVectors positions(points_, 3);
  for (int s = 0; s < static_cast<int>(surfaces.size()); ++s)
    positions.middleRows(sources_[s].first_point, sources_[s].weight.size()) =
      layer.regular_points(s).surface.position;
  sum_ = make_sum(positions, layer.targets());
}

Eigen::VectorXd LayerSum::apply(
  const std::vector<Eigen::VectorXd>& densities, Precision precision) const
{
  RowVectors forces(points_, 3);
  for (std::size_t s = 0; s < sources_.size(); ++s)
    forces.middleRows(sources_[s].first_point, sources_[s].weight.size()) =
      sources_[s].weight.asDiagonal() *
      interpolate(*sources_[s].table, rows_of_three(densities[s]));
  Points velocity = Points::Zero(vertices_, 3);
  sum_->add(forces, precision, velocity);
  for (std::size_t s = 0; s < sources_.size(); ++s)
    sources_[s].corrections.add(densities[s], sources_[s].first_vertex, velocity);
  return velocity.reshaped<Eigen::RowMajor>();
}

}
