#include "solver/dynamics/Discretization.h"

#include "solver/surface/FittedCurvature.h"
#include "solver/membrane/Bending.h"

namespace vesicle
{

namespace
{

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
  return scaled_rows(rows_of_three(nodal), vertex_area.cwiseInverse());
}

class LinearDiscretization final : public Discretization
{
public:
  LinearDiscretization(const Model& model, const Triangles& triangles, int nodes, int quadrature)
    : model_(model), basis_(triangles, nodes),
      layer_(basis_, LayerQuadrature{ quadrature, 0, 0, 1, 4 })
  {
  }

  const BasisTable& table() const override { return layer_.table(); }

  ShapeOperators shape(const Points& points) const override
  {
    const BasisTable& table = layer_.table();
    const SurfacePoints surface = evaluate(table, points);
    const CotanGeometry cotan(points, basis_.elements());
    ShapeOperators s;
    s.vertices = s.control = points;
    s.area = vesicle::area(surface);
    s.volume = vesicle::volume(table, surface);
    s.center = centroid(table, surface);
    s.vertex_area = vertex_areas(table, surface);
    s.volume_gradient = volume_gradient(table, surface);
    s.outward = area_weighted_normals(s.volume_gradient);
    s.centroid_velocity = centroid_velocity_matrix(table, surface);
    s.area_rate = area_rate_matrix(table, surface);
    s.curvature = cotan_curvature(cotan, points, normals());
    s.bending_energy = vesicle::bending_energy(cotan, s.curvature);
    if (model_.fitted_bending)
      s.curvature = fitted_curvature({ points, basis_.elements() }).curvature;
    s.force_normal = s.curvature.normal;
    if (model_.bending)
    {
      s.bending = bending_density(s.curvature);
      s.bending_response = bending_matrix(cotan, s.curvature);
      if (model_.robust())
        s.bending_response = normal_part(s.bending_response, s.force_normal);
    }
    if (model_.incompressible)
    {
      s.gauge_pinned = nearly_sphere(points, s.center);
      s.divergence = model_.robust() ? s.area_rate : surface_divergence_matrix(cotan, s.area_rate);
      s.tension_force = model_.robust()
        ? density_of(SparseMatrix(-s.area_rate.transpose()), s.vertex_area)
        : tension_force_matrix(cotan, points, basis_.elements(), s.force_normal);
    }
    if (model_.bond != 0)
    {
      // Robust: ∮ N_k z n dS, with z from the centroid. A constant added to z is a pressure, which
      // does nothing; nodal forces that sum the load exactly keep net force and torque exact.
      const Eigen::VectorXd height = surface.position.col(2).array() - s.center.z();
      s.load = model_.robust()
        ? density_of(
            Eigen::VectorXd(model_.bond * normal_load(table, surface, height)), s.vertex_area)
        : scaled_rows(s.force_normal, model_.bond * points.col(2));
    }
    if (model_.flow)
      s.ambient = flat(model_.flow->velocities(points));
    return s;
  }

  Constraints constraints(const Points& points) const override
  {
    const BasisTable& table = layer_.table();
    const SurfacePoints surface = evaluate(table, points);
    const Eigen::VectorXd mass = vertex_areas(table, surface);
    Constraints c{ vesicle::area(surface), vesicle::volume(table, surface),
      area_rate_matrix(table, surface).transpose() * Eigen::VectorXd::Ones(points.rows()),
      volume_gradient(table, surface), {}, {} };
    c.area_direction = density_of(c.area_gradient, mass);
    c.volume_direction = density_of(c.volume_gradient, mass);
    return c;
  }

  double bending_energy(const Points& points) const override
  {
    const CotanGeometry geometry(points, basis_.elements());
    return vesicle::bending_energy(geometry, cotan_curvature(geometry, points, normals()));
  }

  void respond(const ShapeOperators& s, VelocityResponse& response) const override
  {
    layer_.respond(s.vertices, s.force_normal, model_.bending, s.tension_force, s.load, response);
  }

  Eigen::VectorXd to_control(const Eigen::VectorXd& velocity) const override { return velocity; }
  void to_control(RowsF&) const override {}

  Eigen::VectorXd bending_force(const ShapeOperators& s, const Eigen::VectorXd& phi) const override
  {
    return scaled_rows(s.force_normal, phi);
  }
  Eigen::VectorXd tension_force(
    const ShapeOperators& s, const Eigen::VectorXd& gamma) const override
  {
    return s.tension_force * gamma;
  }
  Eigen::VectorXd load_force(const ShapeOperators& s) const override { return s.load; }
  double membrane_power(const ShapeOperators& s, const Eigen::VectorXd& phi,
    const Eigen::VectorXd& gamma, const Eigen::VectorXd& velocity) const override
  {
    double power = 0;
    if (phi.size() > 0)
      power += nodal_power(s, bending_force(s, phi), velocity);
    if (gamma.size() > 0)
      power += nodal_power(s, tension_force(s, gamma), velocity);
    return power;
  }
  double load_power(const ShapeOperators& s, const Eigen::VectorXd& velocity) const override
  {
    return nodal_power(s, s.load, velocity);
  }
  FlatSample sample_around(double, const ShapeOperators& s, const Points& field) const override
  {
    return { { s.vertices, basis_.elements() }, field };
  }
  Eigen::VectorXd at_vertices(const Eigen::VectorXd& nodal) const override { return nodal; }

private:
  // Densities are nodal forces over the nodes' areas.
  static double nodal_power(
    const ShapeOperators& s, const Eigen::VectorXd& density, const Eigen::VectorXd& velocity)
  {
    return scaled_rows(rows_of_three(density), s.vertex_area).dot(velocity);
  }

  NormalScheme normals() const
  {
    return model_.robust() ? NormalScheme::area_weighted : NormalScheme::curvature;
  }

  Model model_;
  LinearBasis basis_;
  SingleLayer layer_;
};

}

std::unique_ptr<Discretization> make_linear_discretization(
  const Model& model, const Triangles& triangles, int nodes, int quadrature)
{
  return std::make_unique<LinearDiscretization>(model, triangles, nodes, quadrature);
}

bool nearly_sphere(const Points& points, const Vector3& center)
{
  constexpr double deviation = 1e-3;
  const Eigen::VectorXd radius = (points.rowwise() - center.transpose()).rowwise().norm();
  return radius.maxCoeff() - radius.minCoeff() < deviation * radius.mean();
}

}
