#include "solver/membrane/PaperScheme.h"

namespace vesicle
{

ConstraintRows PaperIncompressibility::rows(const Surface& surface) const
{
  return { surface_divergence_matrix(*surface.cotan, surface.area_rate), {},
    nearly_sphere(surface) };
}

SparseMatrix PaperIncompressibility::force(const Surface& surface) const
{
  return tension_force_matrix(
    *surface.cotan, surface.vertices, surface.space->triangles(), vertex_curvature(surface).normal);
}

TermForce PaperBuoyancy::force(const Surface& surface) const
{
  return { { bond_ * surface.vertices.col(2), {} }, {} };
}

}
