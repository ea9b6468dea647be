#pragma once
// The force densities that a vesicle's nodal numbers stand for at one shape: φ along the normal, a
// tension γ, vectors at the nodes. Pointwise on smooth surfaces, lumped at the nodes on flat
// triangles.

#include "solver/membrane/Incompressibility.h"
#include "solver/membrane/MembraneTerm.h"
#include "solver/stokes/StokesOperator.h"

#include <memory>
#include <optional>

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
  /// `source`: the vesicle's number in `layer`.
  virtual Mobility mobility(
    const StokesOperator& layer, int source, const Mobility::Columns& columns) const = 0;
};

/// `incompressibility`: the vesicle's, or nullptr. The surface must outlive the basis.
std::unique_ptr<const ForceBasis> make_force_basis(
  const Surface& surface, const Incompressibility* incompressibility);

}
