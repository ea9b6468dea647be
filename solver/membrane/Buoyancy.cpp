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

TermForce SmoothBuoyancy::force(const Surface& surface) const
{
  return { { bond_ * (surface.control.col(2).array() - surface.center.z()), {} }, {} };
}

TermForce GalerkinBuoyancy::force(const Surface& surface) const
{
  const Eigen::VectorXd height = surface.points.position.col(2).array() - surface.center.z();
  const Eigen::VectorXd nodal = bond_ * normal_load(surface.space->table(), surface.points, height);
  return { { {}, scaled_rows(rows_of_three(nodal), surface.vertex_area.cwiseInverse()) }, {} };
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
