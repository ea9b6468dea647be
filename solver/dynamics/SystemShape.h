#pragma once
// A system at one moment: the vesicles' surfaces and what their terms make of them.

#include "solver/dynamics/ForceBasis.h"
#include "solver/dynamics/System.h"

namespace vesicle
{

struct VesicleShape
{
  VesicleShape(const Vesicle& vesicle, const Points& points);

  const Vesicle* vesicle;
  std::unique_ptr<const Surface> surface;
  std::unique_ptr<const ForceBasis> basis;
  std::vector<NodalForce> forces; ///< of each term
  Eigen::VectorXd stiff_force;    ///< φ: the sum of the stiff terms' normal parts, or empty
  NodalForce other_force;         ///< the sum of all the others
  std::optional<Linearisation> linearisation; ///< of stiff_force
  std::optional<ConstraintRows> constraint;   ///< of an incompressible membrane

  bool gauge_pinned() const { return constraint && constraint->gauge_pinned; }
  NodalForce force() const; ///< of all terms
  /// Columns for all that the shape has forces of.
  Mobility::Columns columns() const;
};

struct SystemShape
{
  /// The system must outlive the shape.
  SystemShape(const System& system, const std::vector<Points>& points);

  std::vector<Points> points;
  std::vector<VesicleShape> vesicles;
  std::vector<Eigen::Index> first; ///< first vertex of each vesicle, and the number of all
  Eigen::VectorXd imposed;         ///< u∞ at all vertices, 3N; zero at rest

  Eigen::Index vertices() const { return first.back(); }
  /// The part of a 3N vector that belongs to a vesicle.
  Eigen::VectorXd part(const Eigen::VectorXd& vector, std::size_t vesicle) const
  {
    return vector.segment(3 * first[vesicle], 3 * (first[vesicle + 1] - first[vesicle]));
  }
};

/// Velocities that the vesicles' densities make, of each.
std::vector<Mobility> mobilities(const SystemShape& shape);

}
