#pragma once
// The problem whose solutions are equilibria: the membrane's energy at given area and volume, with
// the derivatives that Newton's method needs. Units of r0 and EB.

#include "solver/membrane/MembraneTerm.h"

namespace vesicle
{

struct EnergyProblem
{
  const SurfaceSpace& space; ///< smooth
  const MembraneTerms& terms;
  double area, volume;
};

/// What area and volume are held by: f_b·n − 2 tension H + pressure = 0 at rest, so that the
/// Lagrangian is E + tension (A − A0) − pressure (V − V0).
struct Multipliers
{
  double tension = 0, pressure = 0;
};

/// The problem at one shape. Vectors of 3 entries a node are in the nodes' frames: along the normal
/// at the vertex and along two tangents.
struct EnergyPoint
{
  EnergyPoint(const EnergyProblem& problem, const Points& control);

  Points control;
  CurvedPoints surface;
  CurvatureEnergy membrane;
  double area, volume;
  NodeFrames frames;
  Eigen::VectorXd gradient, area_gradient, volume_gradient; ///< 3N
  Eigen::VectorXd mean_gradient; ///< ∂M/∂c, M = ∮ H dS; empty without a mean_stiffness
  Eigen::VectorXd vertex_area;   ///< N

  /// Control points moved by a vector in frames.
  Points moved(const Eigen::VectorXd& displacement) const;
  Eigen::VectorXd in_frames(const Eigen::VectorXd& functional) const;
  /// Of the Lagrangian.
  Eigen::VectorXd lagrangian_gradient(const Multipliers& m) const
  {
    return gradient + m.tension * area_gradient - m.pressure * volume_gradient;
  }
  Eigen::SparseMatrix<double> lagrangian_hessian(
    const SecondVariation& second, const Multipliers& m) const;
  /// Those that leave the least of the gradient in the normal directions.
  Multipliers best_multipliers() const;
  /// The functionals of a displacement that a rigid motion changes and a mere deformation doesn't
  /// have to: mean translation and rotation, 3N by 6.
  Eigen::MatrixXd rigid_motion() const;
};

/// E, A and V alone.
struct EnergyMeasures
{
  double energy, area, volume;
};
EnergyMeasures measure(const EnergyProblem& problem, const Points& control);

}
