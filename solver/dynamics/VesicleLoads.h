#pragma once
// What acts on a vesicle with a smooth surface, as functionals of its control points' velocities
// (loads, 3N): the adjoint of how the nodes move. Then the power of all loads is exactly what the
// energy loses, and the constraint's rows do no work. Density of a load l: M⁻¹ l at the nodes.

#include "solver/dynamics/ForceBasis.h"
#include "solver/dynamics/System.h"
#include "solver/surface/NodeMotion.h"
#include "solver/linear/SparseCholesky.h"

namespace vesicle
{

/// At one shape; vesicle and surface must outlive it. `rate`: the system's.
///
/// Close to a sphere the constraint leaves deformations free that only the total area forbids, at
/// second order. There the membrane is held taut: the normal speeds' gradients meet a resistance 1e4
/// times the fluid's, and a tension takes back within the system's own time what they leave, so that
/// the shape stays within 1e-4 of the sphere in any flow. That belongs to the constraint, not to the
/// energy; loads are then the adjoint of normal motion, whatever the nodes do.
class VesicleLoads final : public ForceBasis
{
public:
  /// `from_others`: the gradient, 3N, of the energy that the vesicle has with others, or empty.
  VesicleLoads(const Vesicle& vesicle, const Surface& surface,
    std::shared_ptr<const ConstraintRows> constraint, double rate,
    const Eigen::VectorXd& from_others = {});

  // Densities are Σ N_k f_k.
  Points at_vertices(const NodalForce& force) const override;
  Points tension_at_vertices(const Eigen::VectorXd& tension) const override;
  double power(const NodalForce& force, const Eigen::VectorXd& velocity) const override;
  double tension_power(
    const Eigen::VectorXd& tension, const Eigen::VectorXd& velocity) const override;

  const Surface& surface() const { return *surface_; }
  const NodeMotion& motion() const { return motion_; }
  double viscosity_ratio() const { return viscosity_ratio_; } ///< λ

  /// Of each term: −Qᵀg.
  const std::vector<Eigen::VectorXd>& loads() const { return loads_; }
  /// What other vesicles do by an energy with this one, or empty.
  const Eigen::VectorXd& load_from_others() const { return load_from_others_; }
  /// The sum of all.
  Eigen::VectorXd load() const;
  /// g of the membrane's own energy.
  const Eigen::VectorXd& gradient() const { return gradient_; }

  /// K, ∂²E/∂c² of all stiff terms but for its indefinite part: 3N by 3N, the nodes' blocks 3 by 3;
  /// empty if none is stiff.
  const SparseMatrix& stiffness() const { return stiffness_; }
  bool stiff() const { return stiffness_.rows() > 0; }
  /// K times a displacement of the control points.
  Eigen::VectorXd stiff_force(const Eigen::VectorXd& displacement) const;
  /// −τ Qᵀ K Q of velocities with that deformation().
  Eigen::VectorXd stiff_load(double tau, const Eigen::VectorXd& deformation) const;

  /// V of the membrane's own viscosity (SurfaceViscosity.h); empty: it has none.
  const SparseMatrix& viscosity() const { return viscosity_; }
  bool viscous() const { return viscosity_.rows() > 0; }
  /// −V u of velocities with that deformation().
  Eigen::VectorXd viscous_load(const Eigen::VectorXd& deformation) const;

  /// Whose parameters ν are all that loads feel of the velocities that they make: the nodes' motion, but
  /// where the membrane is viscous all that isn't rigid, material motion.
  const NodeMotion& deformation() const { return deformation_ ? *deformation_ : motion_; }
  /// K for motions of the nodes along m directions each, which their rows hold: m N by m N.
  using DirectionRows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  SparseMatrix stiffness_along(const Eigen::Ref<const DirectionRows>& directions) const;

  // The tension's part. Rows B̂ u + F γ = 0, B̂ = B + (m/Σm) (Qᵀa − a)ᵀ, a = Bᵀ1: B's with a rank-one
  // correction after which they add up to the rate of the real area, that of the nodes' motion.
  bool has_tension() const { return constraint_ != nullptr; }
  const ConstraintRows& constraint() const { return *constraint_; }
  /// B̂ u + F γ; `tension` may be empty.
  Eigen::VectorXd tension_rows(
    const Eigen::VectorXd& velocity, const Eigen::VectorXd& tension) const;
  Eigen::VectorXd area_rates(const Eigen::VectorXd& velocity) const;        ///< B̂ u
  Eigen::VectorXd area_rates_adjoint(const Eigen::VectorXd& tension) const; ///< B̂ᵀγ
  /// Close to a sphere, where a uniform tension is a pressure: there B̂ leaves the total area out, a
  /// row of −gauge (m·γ) m/Σm gives the tension a mean of 0, and the membrane is pulled taut.
  bool taut() const { return taut_load_.size() > 0; }
  /// The load of the resistance to the normal speeds of velocities with that deformation(), and its
  /// matrix as if those were the control points': the resistance times ∮ ∇N_j·∇N_k dS, the part of the second variation of the area that
  /// makes it grow.
  Eigen::VectorXd resisting_load(const Eigen::VectorXd& deformation) const;
  const SparseMatrix& resistance() const { return resistance_; }
  /// The load that holds the membrane taut where the vertices have these velocities.
  Eigen::VectorXd taut_load(const Eigen::VectorXd& at_vertices) const;
  /// −p (Qᵀv − v): the pressure's load less that of a uniform pressure, which moves nothing.
  Eigen::VectorXd pressure_load(double pressure) const
  {
    return -pressure * (volume_rate_ - volume_gradient_);
  }
  /// The volume's row Qᵀv, and what the volume is corrected by: n at the vertices.
  const Eigen::VectorXd& volume_rate() const { return volume_rate_; }
  const Eigen::VectorXd& area_gradient() const { return area_gradient_; }     ///< a
  const Eigen::VectorXd& volume_gradient() const { return volume_gradient_; } ///< v
  const Eigen::VectorXd& normal() const { return normal_; }                   ///< n̂ = P⁻¹ n

  static constexpr double gauge = 1; ///< in r0/μ

  const SparseMatrix& mass() const { return mass_; } ///< M
  /// The density of a load, M⁻¹ of each component, and the load of a density.
  Eigen::VectorXd density(const Eigen::VectorXd& load) const;
  Eigen::VectorXd load_of(const Eigen::VectorXd& density) const;

private:
  void make_mass();
  void add_terms(const MembraneTerms& terms);
  void add_constraints();
  void hold_taut(double rate);
  /// The motion's parameters of velocities with that deformation.
  Eigen::VectorXd motion_of(const Eigen::VectorXd& deformation) const;

  const Surface* surface_;
  double viscosity_ratio_;
  NodeMotion motion_;
  std::optional<NodeMotion> deformation_; ///< none: motion_
  std::vector<Eigen::VectorXd> loads_;
  Eigen::VectorXd load_from_others_; ///< or empty
  Eigen::VectorXd taut_load_;        ///< or empty
  Eigen::VectorXd gradient_;
  SparseMatrix stiffness_, viscosity_, resistance_;
  std::shared_ptr<const ConstraintRows> constraint_; ///< none: no tension
  Eigen::VectorXd area_gradient_, area_share_, volume_gradient_, volume_rate_, normal_;
  SparseMatrix mass_;
  SparseCholesky mass_factors_;
};

}
