#include "solver/dynamics/Model.h"

#include "solver/stokes/AmbientFlow.h"

namespace vesicle
{

namespace
{

// A relative deviation of the nodes' distance to the centre below this counts as a sphere: the area
// in excess of a sphere's, its square, is then below 1e-6 and far below what the mesh resolves.
constexpr double sphere_deviation = 1e-3;

bool nearly_sphere(const Points& points, const Vector3& center)
{
  const Eigen::VectorXd radius = (points.rowwise() - center.transpose()).rowwise().norm();
  return radius.maxCoeff() - radius.minCoeff() < sphere_deviation * radius.mean();
}

// Nodal forces to force density by the lumped mass, the nodes' areas.
SparseMatrix density_of(const SparseMatrix& nodal, const Eigen::VectorXd& vertex_area)
{
  SparseMatrix density = nodal;
  for (int row = 0; row < density.rows(); ++row)
    density.row(row) /= vertex_area[row / 3];
  return density;
}

Eigen::VectorXd density_of(const Eigen::VectorXd& nodal, const Eigen::VectorXd& vertex_area)
{
  Eigen::VectorXd density = nodal;
  for (int i = 0; i < vertex_area.size(); ++i)
    density.segment<3>(3 * i) /= vertex_area[i];
  return density;
}

}

ShapeOperators::ShapeOperators(const Model& model, const StokesletMatrix& stokeslets,
  const Points& points, const Triangles& triangles)
  : surface(evaluate(stokeslets.table(), points)), cotan(points, triangles),
    curvature(cotan_curvature(
      cotan, points, model.robust() ? NormalScheme::area_weighted : NormalScheme::curvature)),
    vertex_area(vertex_areas(stokeslets.table(), surface)),
    volume_gradient(vesicle::volume_gradient(stokeslets.table(), surface)),
    area_rate(area_rate_matrix(stokeslets.table(), surface)), area(vesicle::area(surface)),
    volume(vesicle::volume(stokeslets.table(), surface)),
    center(centroid(stokeslets.table(), surface)), outward(area_weighted_normals(volume_gradient)),
    centroid_velocity(centroid_velocity_matrix(stokeslets.table(), surface)),
    normal(curvature.normal)
{
  if (model.bending)
  {
    bending = bending_density(curvature);
    bending_response = bending_matrix(cotan, curvature);
    if (model.robust())
      bending_response = normal_part(bending_response, normal);
  }
  if (model.incompressible)
  {
    gauge_pinned = nearly_sphere(points, center);
    divergence = model.robust() ? area_rate : surface_divergence_matrix(cotan, area_rate);
    tension_force = model.robust() ? density_of(SparseMatrix(-area_rate.transpose()), vertex_area)
                                   : tension_force_matrix(cotan, points, triangles, normal);
  }
  if (model.bond != 0)
  {
    // Robust: ∮ N_k z n dS, with z from the centroid. A constant added to z is a pressure, which
    // does nothing; nodal forces that sum the load exactly keep net force and torque exact.
    if (model.robust())
      load = model.bond *
        density_of(normal_load(stokeslets.table(), surface,
                     (surface.position.col(2).array() - center.z()).matrix()),
          vertex_area);
    else
      load = model.bond * flat((normal.array().colwise() * points.col(2).array()).matrix().eval());
  }
  if (model.flow)
    ambient = flat(ambient_velocity(*model.flow, points));
}

}
