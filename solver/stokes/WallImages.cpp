#include "solver/stokes/WallImages.h"

#include "solver/mesh/BoundingBox.h"
#include "solver/stokes/kernels/StokesletKernel.h"
#include "solver/surface/Collocation.h"

namespace vesicle
{

WallImages::WallImages(const StokesOperator& layer, const Wall& wall, PointKind kind,
  const std::vector<double>& factors, const MakePointSum& make_sum)
  : frame_(wall), kind_(kind)
{
  const PointKind of_images =
    kind == PointKind::force ? PointKind::force_image : PointKind::stresslet_image;
  PointPlaces places = layer.places();
  places.targets = frame_.positions(places.targets);
  const Points& targets = places.targets;
  const std::vector<VertexGroup> vertices{ { 0, &targets, bounding_box(targets) } };
  for (int s = 0; s < layer.surfaces(); ++s)
  {
    const LayerSurface& surface = layer.surface(s);
    const LayerRules& rules = *surface.rules;
    const Points control = frame_.mirrored_positions(surface.control);
    const LayerPoints regular(rules.regular().table, control);
    const double factor = factors[s] * (kind == PointKind::force ? 1 : double_layer_factor);
    Source& source = sources_.emplace_back(
      Source{ &rules.regular().table, factor, factor * regular.weight, {}, points_, {}, {} });
    places.sources.middleRows(points_, source.weight.size()) = regular.surface.position;
    points_ += static_cast<int>(source.weight.size());
    if (kind == PointKind::stresslet)
    {
      // A mirrored surface is inside out.
      source.normal = -(source.weight.asDiagonal() * regular.surface.cross.rowwise().normalized());
      source.rigid.emplace(surface.control, Eigen::VectorXd::Ones(surface.control.rows()));
    }
    const NearVertices near = near_vertices(rules, control, vertices);
    if (!near.vertex.empty())
      source.near.emplace(NearSurfaceCorrections(
        { rules, regular, LayerPoints(rules.near().table, control) }, targets, near, of_images));
  }
  sum_ = make_sum(places);
}

Points WallImages::mirrored(const Source& source, const Eigen::VectorXd& nodal) const
{
  return frame_.mirrored_vectors(
    rows_of_three(source.rigid ? Eigen::VectorXd(nodal - source.rigid->nearest(nodal)) : nodal));
}

Eigen::MatrixXd WallImages::strengths(const Source& source, const Points& mirrored) const
{
  const RowVectors at_points = interpolate(*source.table, mirrored);
  if (kind_ == PointKind::force)
    return source.weight.asDiagonal() * at_points;
  return symmetric_products(at_points, source.normal);
}

void WallImages::add(
  const std::vector<Eigen::VectorXd>& nodal, double allowed, Eigen::VectorXd& velocities) const
{
  Eigen::MatrixXd all(points_, components_of(kind_));
  std::vector<Points> of_sources;
  for (std::size_t s = 0; s < sources_.size(); ++s)
  {
    const Source& source = sources_[s];
    of_sources.push_back(mirrored(source, nodal[s]));
    all.middleRows(source.first_point, source.weight.size()) = strengths(source, of_sources.back());
  }
  Points made = Points::Zero(velocities.size() / 3, 3);
  sum_->add(all, allowed, made);
  for (std::size_t s = 0; s < sources_.size(); ++s)
    if (sources_[s].near)
      sources_[s].near->add(sources_[s].factor * flat(of_sources[s]), made);
  velocities += flat(frame_.vectors_outside(made));
}

}
