#pragma once
// The linear problem of one stage of a time step on smooth surfaces: at a frozen shape, the
// velocities u of the control points that the loads make, with tension, volume and the stiff terms'
// change over a time τ. With A = P⁻¹ S M⁻¹, S the single layer at the vertices (VesicleLoads.h):

// clang-format off
//
//   u = u∞ + A l + c n̂
//   l = l₀ − τ Qᵀ K Q (u − reference) − V u − EᵀT E u − B̂ᵀγ − p Qᵀv
//   B̂ u − F γ = 0,   Qᵀv·u = 0,   n̂·l = 0
//
// clang-format on

// so that, for no flow and no tangential motion, dE/dt = g·Qu = −l·A l − u·V u − γ·Fγ can't be positive.
// (V only of a viscous membrane, T of a taut sphere.)

// Between fluids of viscosity ratio λ the double layer K joins in (C. Pozrikidis, Boundary Integral and
// Singularity Methods, 1992, 5.3):

// clang-format off
//
//   u = 2/(1 + λ) A l + w + c n̂,   w = 2/(1 + λ) (u∞ − Σ (1 − λ) K u)
//
// clang-format on

// with w at the vertices one more unknown. K n ≈ −n/2 makes that nearly singular as λ → 0: there
// (1 − λ) n̂ (Qᵀv·u)/2A is added, which is zero. Rigid motions, K u = u/2, do so as λ → ∞, which the
// preconditioner takes care of. Unknowns, of each vesicle: ν = E u (VesicleLoads::deformation), which is
// all that K, V and T feel, the tension γ, the pressure p and c; parts that it doesn't need aren't there.

#include "solver/dynamics/LayerMaps.h"
#include "solver/dynamics/StageSolution.h"
#include "solver/dynamics/State.h"
#include "solver/dynamics/SystemShape.h"

namespace vesicle
{

class LocalPreconditioner;
class RigidMotions;

/// Of one vesicle; as a residual: of the rows that belong to them.
struct LoadUnknowns
{
  Eigen::VectorXd parameters, tension; ///< ν, γ; empty: none
  double pressure = 0, volume_speed = 0;
  Eigen::VectorXd contrast; ///< w; empty: none
};

class LoadStage
{
public:
  /// All arguments must outlive the stage. `tau`: implicit time; 0: stiff loads are those of the
  /// shape. `reference`: velocities of all vertices, or empty. `guess`: what has velocities and tensions
  /// near the solution, which is found from there with fewer iterations; or without any.
  LoadStage(const SystemShape& shape, LayerMaps layers, double tau,
    const Eigen::VectorXd& reference, const State& guess);

  Eigen::Index unknowns() const { return first_.back(); }
  /// Solves to the velocity's relative error `tolerance`, about.
  StageSolution solve(const std::vector<LocalPreconditioner>& preconditioners, double tolerance,
    int max_iterations) const;

private:
  std::vector<LoadUnknowns> split(const Eigen::VectorXd& x) const;
  Eigen::VectorXd join(const std::vector<LoadUnknowns>& x) const;
  const VesicleLoads& loads(std::size_t vesicle) const { return *shape_.vesicles[vesicle].loads; }
  std::size_t count() const { return shape_.vesicles.size(); }
  bool implicit(std::size_t vesicle) const;
  bool has_parameters(std::size_t vesicle) const;
  bool has_contrast() const { return layers_.contrast != nullptr; }
  /// 2/(1 + λ).
  double share_of_layer(std::size_t vesicle) const;
  Eigen::VectorXd imposed_share(std::size_t vesicle) const;
  /// `control`: of each vesicle's nodes, what `velocity` is at all vertices.
  Eigen::VectorXd contrast_of(const std::vector<Eigen::VectorXd>& control,
    const Eigen::VectorXd& velocity, double allowed) const;
  void start_contrast(std::vector<LoadUnknowns>& x, const Eigen::VectorXd& without) const;
  std::vector<LoadUnknowns> precondition(const std::vector<LocalPreconditioner>& preconditioners,
    const std::vector<RigidMotions>& rigid, std::vector<LoadUnknowns> residual) const;
  LoadUnknowns unknowns_of(std::size_t vesicle, const State& guess) const;
  Eigen::VectorXd load_of(std::size_t vesicle, const LoadUnknowns& x) const;
  /// Rows of loads and the velocities that they, c and w make, without the flow.
  std::vector<LoadUnknowns> rows(const std::vector<Eigen::VectorXd>& loads,
    const std::vector<LoadUnknowns>& x, const Eigen::VectorXd& velocity, double allowed = 0) const;
  Eigen::VectorXd velocity_of(const std::vector<Eigen::VectorXd>& loads,
    const std::vector<LoadUnknowns>& x, double allowed = 0) const;

  StageSolution solution_of(const std::vector<LoadUnknowns>& x) const;

  const SystemShape& shape_;
  LayerMaps layers_;
  double tau_;
  std::vector<Eigen::Index> first_{ 0 };
  std::vector<Eigen::VectorXd> reference_load_; ///< τ Qᵀ K Q reference, or empty
  std::vector<Eigen::VectorXd> known_load_;
  std::vector<LoadUnknowns> guess_;
  std::vector<Eigen::VectorXd> guessed_velocity_; ///< of each vesicle, or empty
  Eigen::VectorXd scale_;
};

}
