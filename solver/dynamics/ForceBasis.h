#pragma once
// The force densities that a vesicle's nodal numbers stand for at one shape, seen from outside:
// what is reported of them.

#include "solver/membrane/MembraneTerm.h"

namespace vesicle
{

class ForceBasis
{
public:
  virtual ~ForceBasis() = default;
  /// Vector densities at the vertices: N by 3.
  virtual Points at_vertices(const NodalForce& force) const = 0;
  virtual Points tension_at_vertices(const Eigen::VectorXd& gamma) const = 0;
  /// ∮ f·v dS, v given at the vertices: 3N.
  virtual double power(const NodalForce& force, const Eigen::VectorXd& velocity) const = 0;
  virtual double tension_power(
    const Eigen::VectorXd& gamma, const Eigen::VectorXd& velocity) const = 0;
};

}
