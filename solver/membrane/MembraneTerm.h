#pragma once
// What acts on a vesicle's membrane: bending, buoyancy, … Each term is an object of its own; one
// that the scene doesn't name doesn't exist. All in units of r0, EB and μ; densities are forces an
// area, the membrane's on the fluid.

#include "solver/membrane/CurvatureEnergy.h"
#include "solver/surface/Surface.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vesicle
{

/// A force density by numbers at the nodes; parts that a term doesn't have are empty.
struct NodalForce
{
  /// φ, N: the density is Σ N_k φ_k n_k with the normals n_k of vertex_curvature. Flat triangles
  /// only.
  Eigen::VectorXd normal;
  Eigen::VectorXd vector; ///< f, 3N: the density is Σ N_k f_k

  NodalForce& operator+=(const NodalForce& other);
};

/// A term at one shape of flat triangles.
struct TermForce
{
  NodalForce density;
  /// Of terms that are stiff: how density.normal follows a displacement, δφ = R δx, N by 3N.
  std::optional<SparseMatrix> linearisation;
};

/// A term at one shape of a smooth surface: how its energy follows the control points.
struct Variation
{
  Eigen::VectorXd gradient; ///< g = ∂E/∂c, 3N; of a term without an energy, minus its load
  /// Where the term is stiff: ∂²E/∂c² is about 2 Σ_q R_qᵀR_q over the quadrature points of the
  /// surface's table. Of each R the three numbers of every entry of the table; none: not stiff.
  std::vector<EntryVectors> rates;
};

class MembraneTerm
{
public:
  virtual ~MembraneTerm() = default;
  /// The first word of its field: "Bending" gives Bending_Force.
  virtual std::string name() const = 0;
  /// True where an outside body pulls (gravity): its power is put in, and its density isn't the
  /// membrane's own.
  virtual bool external() const { return false; }
  /// True where its force must follow the motion within a time step.
  virtual bool stiff() const { return false; }
  /// The rate that it sets, for a vesicle of radius 1.
  virtual double rate() const = 0;

  virtual double energy(const Surface& surface) const = 0;
  /// On flat triangles.
  virtual TermForce force(const Surface& surface) const;
  /// On smooth surfaces.
  virtual Variation variation(const Surface& surface) const;
  /// The same energy for a search of its minimum, with all that Newton's method asks for. Throws
  /// InputError for terms that have no equilibrium of their own.
  virtual void add_curvature_energy(const CurvedPoints& surface, CurvatureEnergy& sum) const;
};

using MembraneTerms = std::vector<std::unique_ptr<const MembraneTerm>>;

}
