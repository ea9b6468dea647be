#pragma once
// A system at one moment: the vesicles' surfaces and what their terms make of them.

#include "solver/dynamics/LumpedForces.h"
#include "solver/dynamics/System.h"
#include "solver/dynamics/VesicleLoads.h"

namespace vesicle
{

struct VesicleShape
{
  /// `rate`: the system's; `from_others`: the gradient of the energy that the vesicle has with others,
  /// of the control points, or empty.
  VesicleShape(const Vesicle& vesicle, std::unique_ptr<const Surface> surface, double rate,
    const Eigen::VectorXd& from_others = {});

  const Vesicle* vesicle;
  std::unique_ptr<const Surface> surface;
  std::unique_ptr<const VesicleLoads> loads;  ///< smooth surfaces only
  std::unique_ptr<const LumpedForces> lumped; ///< flat triangles only
  std::vector<NodalForce> forces;             ///< of each term
  /// The sum of the stiff terms, or empty: φ on flat triangles, vectors on smooth surfaces.
  Eigen::VectorXd stiff_force;
  NodalForce force_from_others;                     ///< of the repulsion; no parts: none
  NodalForce other_force;                           ///< the sum of all but the stiff ones
  std::optional<SparseMatrix> linearisation;        ///< of stiff_force; flat triangles only
  std::shared_ptr<const ConstraintRows> constraint; ///< of an incompressible membrane

  const ForceBasis& basis() const
  {
    return loads ? static_cast<const ForceBasis&>(*loads) : *lumped;
  }
  bool gauge_pinned() const { return constraint && constraint->gauge_pinned; }
  NodalForce force() const; ///< of all
  /// Columns for all that the shape has forces of; flat triangles only.
  Mobility::Columns columns() const;

private:
  void add_flat_forces(const Eigen::VectorXd& from_others);
  void add_loads(double rate, const Eigen::VectorXd& from_others);
};

struct SystemShape
{
  /// The system must outlive the shape. `time`, in t0, is the imposed flow's.
  SystemShape(const System& system, const std::vector<Points>& points, double time = 0);

  std::vector<Points> points;
  double time;
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

/// For the distances between vesicles.
std::vector<Proximity::Side> sides(const SystemShape& shape);
/// As the single layer wants them.
std::vector<LayerSurface> layer_surfaces(const SystemShape& shape);
/// Velocities that the vesicles' densities make, of each.
std::vector<Mobility> mobilities(const SystemShape& shape);

}
