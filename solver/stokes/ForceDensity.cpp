#include "solver/stokes/ForceDensity.h"

namespace vesicle
{

ForceDensity nodal_density(const Points& nodal)
{
  return [nodal](const BasisTable& table, const SurfacePoints&)
  { return interpolate(table, nodal); };
}

ForceDensity normal_density(const Eigen::VectorXd& nodal)
{
  return [nodal](const BasisTable& table, const SurfacePoints& s) -> RowVectors
  { return s.cross.rowwise().normalized().array().colwise() * interpolate(table, nodal).array(); };
}

}
