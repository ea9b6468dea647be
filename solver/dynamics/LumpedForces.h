#pragma once
// Force densities on flat triangles: lumped at the nodes, nodal forces over the nodes' areas.

#include "solver/dynamics/ForceBasis.h"
#include "solver/membrane/Incompressibility.h"
#include "solver/stokes/StokesOperator.h"

namespace vesicle
{

/// Velocities that one vesicle's densities make at the vertices of all, as columns of a matrix.
struct Mobility
{
  /// What it has columns for; empty parts have none.
  struct Columns
  {
    bool normal = false, tension = false;
    Eigen::VectorXd vector; ///< one column, of this density: 3N or empty
    bool any() const { return normal || tension || vector.size() > 0; }
  };
  DenseMatrix matrix;
  Eigen::Index normal = -1, tension = -1, vector = -1; ///< the first column of each, −1: none

  /// Of a force whose parts have columns; the vector is the one of Columns.
  Eigen::VectorXd velocity(const NodalForce& force) const;
};

class LumpedForces final : public ForceBasis
{
public:
  /// `incompressibility`: the vesicle's, or nullptr. The surface must outlive the forces.
  LumpedForces(const Surface& surface, const Incompressibility* incompressibility);

  Points at_vertices(const NodalForce& force) const override;
  Points tension_at_vertices(const Eigen::VectorXd& gamma) const override;
  double power(const NodalForce& force, const Eigen::VectorXd& velocity) const override;
  double tension_power(
    const Eigen::VectorXd& gamma, const Eigen::VectorXd& velocity) const override;

  /// `source`: the vesicle's number in `layer`.
  Mobility mobility(
    const StokesOperator& layer, int source, const Mobility::Columns& columns) const;

private:
  int widest_row() const;
  Eigen::VectorXd nodal(const NodalForce& force) const;
  double power(const Eigen::VectorXd& density, const Eigen::VectorXd& velocity) const;

  const Surface& surface_;
  Points normal_;
  SparseMatrix tension_; ///< 3N by N, or empty
};

}
