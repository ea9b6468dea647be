#include "solver/membrane/Incompressibility.h"

#include "solver/membrane/PaperScheme.h"

#include <cmath>

namespace vesicle
{

namespace
{

// A tension that alternates from node to node does next to no work on a smooth velocity, so the
// constraint leaves it free (a checkerboard). −filter h³ Δ_s² γ in the constraint's rows takes it
// out: at the scale of the mesh that is as large as what a smooth tension does there, and on smooth
// tensions of third order. The total area doesn't feel it. At 320 triangles in shear 1e-3 brings
// the tension from [3.3, 6.9] to [4.0, 6.6]; a hundred times more changes the inclination by 0.06°.
constexpr double tension_filter = 1e-3;

// A membrane of viscosity η moves less at that scale: a tension that is a wave along it makes the
// velocity 1/(4k + η k²) instead of 1/4k.
double filter_strength(double h, double viscosity)
{
  const double strength = tension_filter * h * h * h;
  return viscosity > 0 ? strength / (1 + viscosity / h) : strength;
}

// Nodal forces to force density by the lumped mass, the nodes' areas.
SparseMatrix density_of(SparseMatrix nodal, const Eigen::VectorXd& vertex_area)
{
  for (int row = 0; row < nodal.rows(); ++row)
    nodal.row(row) /= vertex_area[row / 3];
  return nodal;
}

}

ConstraintRows SmoothIncompressibility::rows(const Surface& surface) const
{
  const double h = std::sqrt(surface.area / static_cast<double>(surface.space->triangles().rows()));
  return { surface.area_rate,
    -filter_strength(h, viscosity_) *
      bilaplacian(surface.space->table(), surface.points, *surface.curvature),
    nearly_sphere(surface) };
}

ConstraintRows AdjointIncompressibility::rows(const Surface& surface) const
{
  return { surface.area_rate, {}, nearly_sphere(surface) };
}

SparseMatrix AdjointIncompressibility::force(const Surface& surface) const
{
  return density_of(SparseMatrix(-surface.area_rate.transpose()), surface.vertex_area);
}

std::unique_ptr<const Incompressibility> make_incompressibility(
  const SurfaceSpace& space, double surface_viscosity)
{
  if (space.smooth())
    return std::make_unique<SmoothIncompressibility>(surface_viscosity);
  if (space.curvature() == VertexCurvature::paper)
    return std::make_unique<PaperIncompressibility>();
  return std::make_unique<AdjointIncompressibility>();
}

}
