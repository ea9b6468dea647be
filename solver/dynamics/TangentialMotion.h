#pragma once
// The nodes' motion along the membrane, which no physics fixes: towards a better mesh, and downhill
// in the energy that the mesh has, without a change of area or volume.

#include "solver/dynamics/VesicleLoads.h"

#include <memory>

namespace vesicle
{

/// How implicit the motion along the surface is, s. K is the Gauss–Newton part of the energy's second
/// variation; along the surface the rest is as large or larger, and a step that is implicit in K alone
/// shakes the mesh, and the forces with it, as hard as the step control lets it. Nothing is lost by
/// more: that motion has no accuracy to keep.
inline constexpr double mesh_implicitness = 10;

class TangentialForm;

/// Tangential velocities t at the vertices, 3N, that minimise for an implicit time τ
///   ½ Σ_i m_i |t_i − wanted_i|²/β + (g + τ K P⁻¹otherwise)·P⁻¹t + ½ s τ P⁻¹t·K P⁻¹t
/// with a·P⁻¹t = v·P⁻¹t = 0: where the mesh may move freely it does as wanted, where that costs
/// energy it doesn't, and it slides down the energy's own gradient. β, a length over the viscosity, is
/// the mobility of the mesh.
class TangentialMotion
{
public:
  /// All that depends on the shape alone. `loads`: of nodes that move along the normals; they must
  /// outlive it. Throws NumericalError.
  TangentialMotion(const VesicleLoads& loads, double tau, double beta);
  TangentialMotion(TangentialMotion&&) noexcept;
  ~TangentialMotion();

  /// `otherwise`: how else the vertices move, less what g is known to follow already, 3N; a
  /// translation doesn't count. What is left of an energy that rises is cut to half of `released`,
  /// the rate at which the normal motion gives energy away.
  Eigen::VectorXd velocities(
    const Eigen::VectorXd& wanted, const Eigen::VectorXd& otherwise, double released) const;

private:
  std::unique_ptr<TangentialForm> form_;
  Eigen::VectorXd gradient_; ///< g, of d
};

}
