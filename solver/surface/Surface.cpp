#include "solver/surface/Surface.h"

#include "solver/ParallelFor.h"
#include "solver/surface/FittedCurvature.h"
#include "solver/surface/LoopBasis.h"
#include "solver/linear/SparseCholesky.h"
#include "solver/linear/Symmetric.h"

namespace vesicle
{

namespace
{

std::unique_ptr<const Basis> make_basis(SurfaceBasis kind, const Triangles& triangles, int nodes)
{
  if (kind == SurfaceBasis::loop)
    return std::make_unique<LoopBasis>(triangles, nodes);
  return std::make_unique<LinearBasis>(triangles, nodes);
}

BasisTable make_table(const Basis& basis, int flat_points)
{
  BasisTable table = basis.smooth()
    ? tabulate_rule(basis, triangle_rule(LoopBasis::rule_points), LoopBasis::rule_grading)
    : tabulate_rule(basis, triangle_rule(flat_points));
  table.pattern = pattern_of(table);
  return table;
}

}

SurfaceSpace::SurfaceSpace(SurfaceBasis kind, const Triangles& triangles, int nodes, int points)
  : SurfaceSpace(kind, kind == SurfaceBasis::loop ? VertexCurvature::weak : VertexCurvature::cotan,
      triangles, nodes, points)
{
}

SurfaceSpace::SurfaceSpace(
  SurfaceBasis kind, VertexCurvature curvature, const Triangles& triangles, int nodes, int points)
  : basis_(make_basis(kind, triangles, nodes)), curvature_(curvature),
    table_(make_table(*basis_, points)), collocation_(*basis_),
    plans_(std::make_unique<const EliminationPlans>())
{
}

Surface::Surface(const SurfaceSpace& s, const Points& at)
  : space(&s), vertices(at), control(rows_of_three(s.collocation().to_control(flat(at)))),
    points(evaluate(s.table(), control)), area(vesicle::area(points)),
    volume(vesicle::volume(s.table(), points)), center(centroid(s.table(), points))
{
  run_together({ [&]
    {
      const auto W = centroid_velocity_matrix(s.table(), points);
      centroid_velocity.resize(3, W.cols());
      for (int d = 0; d < 3; ++d)
        centroid_velocity.row(d) = s.collocation().from_control(W.row(d).transpose()).transpose();
    },
    [&]
    {
      vertex_area = vertex_areas(s.table(), points);
      normals = s.basis().vertex_normals(control);
      volume_gradient = s.collocation().from_control(vesicle::volume_gradient(s.table(), points));
      if (s.smooth())
        curvature = point_curvature(s.table(), points, control);
      else
        cotan.emplace(vertices, s.triangles());
    },
    [&] { area_rate = area_rate_matrix(s.table(), points); } });
}

Eigen::VectorXd Surface::divergence(const Eigen::VectorXd& velocity) const
{
  return (area_rate * to_control(velocity)).cwiseQuotient(vertex_area);
}

Vector3 Surface::mean_velocity(const Eigen::VectorXd& velocity) const
{
  return centroid_velocity * velocity;
}

Eigen::VectorXd Surface::relative_to_centroid(const Eigen::VectorXd& velocity) const
{
  return velocity - mean_velocity(velocity).replicate(velocity.size() / 3, 1);
}

namespace
{

// ⟨H⟩ and ⟨K⟩ by projection, Δ_s H from that of the bending force 2 Δ_s H + 4 H (H² − K), whose
// weak form needs no derivative beyond the second.
Curvature weak_curvature(const Surface& surface)
{
  const BasisTable& table = surface.space->table();
  const SparseCholesky mass(by_columns(mass_matrix(table, surface.points)), surface.space->plans());
  const auto projected = [&](const Eigen::VectorXd& load) -> Eigen::VectorXd
  { return surface.collocation().at_vertices(mass.solve(load)); };
  Curvature c;
  c.normal = surface.normals;
  c.mean = projected(moments(table, surface.points, surface.curvature->mean));
  c.gauss = projected(moments(table, surface.points, surface.curvature->gauss));
  const Eigen::VectorXd force =
    projected(bending_moments(table, surface.points, *surface.curvature));
  c.laplacian_mean = laplacian_of_mean(force, c.mean, c.gauss);
  return c;
}

}

Curvature vertex_curvature(const Surface& surface)
{
  switch (surface.space->curvature())
  {
    case VertexCurvature::paper:
      return cotan_curvature(*surface.cotan, surface.vertices, NormalScheme::curvature);
    case VertexCurvature::cotan:
      return cotan_curvature(*surface.cotan, surface.vertices, NormalScheme::area_weighted);
    case VertexCurvature::weak:
      return weak_curvature(surface);
    case VertexCurvature::fitted:
      break;
  }
  return fitted_curvature({ surface.vertices, surface.space->triangles() }).curvature;
}

Eigen::VectorXd squared_curvature(const Surface& surface)
{
  const auto sum_of_squares = [](const auto& mean, const auto& gauss) -> Eigen::VectorXd
  { return (4 * mean.cwiseAbs2() - 2 * gauss).cwiseMax(0); };
  if (!surface.curvature)
  {
    const Curvature c = vertex_curvature(surface);
    return sum_of_squares(c.mean, c.gauss);
  }
  return moments(surface.space->table(), surface.points,
    sum_of_squares(surface.curvature->mean, surface.curvature->gauss))
    .cwiseQuotient(surface.vertex_area);
}

bool nearly_sphere(const Surface& surface)
{
  constexpr double deviation = 1e-3;
  const Eigen::VectorXd radius =
    (surface.vertices.rowwise() - surface.center.transpose()).rowwise().norm();
  return radius.maxCoeff() - radius.minCoeff() < deviation * radius.mean();
}

AreaAndVolume::AreaAndVolume(const SurfaceSpace& space, const Points& vertices)
  : space_(space), control_(rows_of_three(space.collocation().to_control(flat(vertices)))),
    surface_(evaluate(space.table(), control_)), area_(vesicle::area(surface_)),
    volume_(vesicle::volume(space.table(), surface_))
{
}

AreaAndVolume::Changes AreaAndVolume::changes() const
{
  const BasisTable& table = space_.table();
  const Collocation& collocation = space_.collocation();
  const Eigen::VectorXd mass = vertex_areas(table, surface_);
  Changes c{ collocation.from_control(area_gradient(table, surface_)),
    collocation.from_control(volume_gradient(table, surface_)), {}, {} };
  if (space_.smooth())
  {
    const Points normal = space_.basis().vertex_normals(control_);
    const Eigen::VectorXd mean =
      moments(table, surface_, mean_curvature(table, surface_, control_)).cwiseQuotient(mass);
    c.area_direction = scaled_rows(normal, 2 * mean);
    c.volume_direction = flat(normal);
  }
  else
  {
    c.area_direction = scaled_rows(rows_of_three(c.area_gradient), mass.cwiseInverse());
    c.volume_direction = scaled_rows(rows_of_three(c.volume_gradient), mass.cwiseInverse());
  }
  return c;
}

}
