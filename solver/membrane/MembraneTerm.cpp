#include "solver/membrane/MembraneTerm.h"

#include "solver/Errors.h"

#include <stdexcept>

namespace vesicle
{

namespace
{

void add(Eigen::VectorXd& sum, const Eigen::VectorXd& part)
{
  if (sum.size() == 0)
    sum = part;
  else if (part.size() > 0)
    sum += part;
}

}

NodalForce& NodalForce::operator+=(const NodalForce& other)
{
  add(normal, other.normal);
  add(vector, other.vector);
  return *this;
}

TermForce MembraneTerm::force(const Surface&) const
{
  throw std::logic_error(name() + " has no force on flat triangles");
}

Variation MembraneTerm::variation(const Surface&) const
{
  throw std::logic_error(name() + " has no variation on smooth surfaces");
}

void MembraneTerm::add_curvature_energy(const CurvedPoints&, CurvatureEnergy&) const
{
  throw InputError(name() + " has no equilibrium that is a minimum of the energy: leave it out");
}

}
