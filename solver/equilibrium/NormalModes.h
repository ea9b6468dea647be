#pragma once
// The softest deformations of an equilibrium: the lowest eigenvalues of the energy's second
// variation under constant area and volume, over normal displacements, for along the membrane the
// energy knows none, and without rigid motions.

#include "solver/equilibrium/EnergyProblem.h"

namespace vesicle
{

/// ψ n with the second variation λ ∮ ψ² dS: λ in units of EB/r0⁴, lowest first.
struct NormalModes
{
  Eigen::VectorXd eigenvalues;
  Eigen::MatrixXd displacement; ///< of the control points along the vertices' normals; ∮ ψ² dS = 1
};

/// `hessian`: the Lagrangian's, of 3N by its lower triangle. Throws NumericalError.
NormalModes lowest_normal_modes(const EnergyPoint& point, const BasisTable& table,
  const Eigen::SparseMatrix<double>& hessian, int count);

/// The normal directions' part of a lower triangle of 3N: N by N, its lower triangle.
Eigen::SparseMatrix<double> normal_part(const Eigen::SparseMatrix<double>& hessian);
/// Columns of constraints and rigid motions for normal displacements, without those that normal
/// displacements don't have, and the column of what the hessian leaves out, with its D.
struct NormalBorder
{
  Eigen::MatrixXd columns; ///< of the area, of the volume, …
  Eigen::VectorXd D;
};
NormalBorder normal_border(const EnergyPoint& point);

}
