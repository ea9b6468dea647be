#include "solver/membrane/Buoyancy.h"

#include "solver/membrane/PaperScheme.h"

#include <cmath>

namespace vesicle
{

double Buoyancy::rate() const
{
  return 2. / 9 * std::abs(bond_);
}

double Buoyancy::energy(const Surface& surface) const
{
  return -bond_ * surface.volume * surface.center.z();
}

namespace
{

// ∮ N_k (z − z_c) n dS: N by 3, as 3N.
Eigen::VectorXd load_of_height(const Surface& surface)
{
  const Eigen::VectorXd height = surface.points.position.col(2).array() - surface.center.z();
  return normal_load(surface.space->table(), surface.points, height);
}

}

Variation SmoothBuoyancy::variation(const Surface& surface) const
{
  return { -bond_ * load_of_height(surface), {} };
}

TermForce GalerkinBuoyancy::force(const Surface& surface) const
{
  const Points nodal = rows_of_three(bond_ * load_of_height(surface));
  return { { {}, scaled_rows(nodal, surface.vertex_area.cwiseInverse()) }, {} };
}

std::unique_ptr<const MembraneTerm> make_buoyancy(const SurfaceSpace& space, double bond_number)
{
  if (space.smooth())
    return std::make_unique<SmoothBuoyancy>(bond_number);
  if (space.curvature() == VertexCurvature::paper)
    return std::make_unique<PaperBuoyancy>(bond_number);
  return std::make_unique<GalerkinBuoyancy>(bond_number);
}

}
