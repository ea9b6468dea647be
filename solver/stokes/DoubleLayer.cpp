#include "solver/stokes/DoubleLayer.h"

#include "solver/stokes/kernels/StokesletKernel.h"
#include "solver/surface/Collocation.h"

namespace vesicle
{

std::unique_ptr<const PointSum> DoubleLayer::direct_sum(const PointPlaces& places)
{
  return std::make_unique<DirectPointSum<PointKind::stresslet>>(places.sources, places.targets);
}

DoubleLayer::DoubleLayer(
  const StokesOperator& layer, const std::vector<double>& factors, const MakePointSum& make_sum)
  : sum_(make_sum(layer.places())), vertices_(layer.vertices())
{
  for (int s = 0; s < layer.surfaces(); ++s)
  {
    const LayerPoints& at = layer.regular_points(s);
    const LayerSurface& surface = layer.surface(s);
    Source source{ &surface.rules->regular().table,
      double_layer_factor * at.weight.asDiagonal() * at.surface.cross.rowwise().normalized(),
      layer.first_vertex(s), points_, layer.corrections(s, PointKind::stresslet), factors[s], {} };
    const int own = surface.rules->vertices();
    source.own = layer.surfaces() == 1
      ? own_blocks(source, *sum_, own)
      : own_blocks(source, *make_sum({ at.surface.position, surface.vertices }), own);
    points_ += static_cast<int>(at.weight.size());
    sources_.push_back(std::move(source));
  }
}

Eigen::Matrix<double, Eigen::Dynamic, 6> DoubleLayer::stresslets(
  const Source& source, const Points& nodal)
{
  return symmetric_products(interpolate(*source.table, nodal), source.normal);
}

// `sum` is from the source's points to its own vertices alone.
RowVectors DoubleLayer::own_blocks(const Source& source, const PointSum& sum, int vertices)
{
  RowVectors own(3L * vertices, 3);
  for (int c = 0; c < 3; ++c)
  {
    const Points constant = Vector3::Unit(c).transpose().replicate(vertices, 1);
    Points made = Points::Zero(vertices, 3);
    sum.add(stresslets(source, constant), 0, made);
    source.corrections.own.add(double_layer_factor * flat(constant), 0, made);
    own.col(c) = flat(Points(constant / 2 - made));
  }
  return own;
}

Eigen::VectorXd DoubleLayer::apply(const std::vector<Eigen::VectorXd>& nodal,
  const Eigen::VectorXd& at_vertices, double allowed) const
{
  Eigen::MatrixXd strengths(points_, 6);
  for (std::size_t s = 0; s < sources_.size(); ++s)
    strengths.middleRows(sources_[s].first_point, sources_[s].normal.rows()) =
      sources_[s].factor * stresslets(sources_[s], rows_of_three(nodal[s]));
  Points result = Points::Zero(vertices_, 3);
  sum_->add(strengths, allowed, result);
  for (std::size_t s = 0; s < sources_.size(); ++s)
  {
    const Source& source = sources_[s];
    const Eigen::VectorXd scaled = double_layer_factor * source.factor * nodal[s];
    source.corrections.add(scaled, source.first_vertex, result);
    for (Eigen::Index i = 0; i < source.own.rows() / 3; ++i)
      result.row(source.first_vertex + i) += source.factor *
        (source.own.middleRows<3>(3 * i) * at_vertices.segment<3>(3 * (source.first_vertex + i)))
          .transpose();
  }
  return result.reshaped<Eigen::RowMajor>();
}

}
