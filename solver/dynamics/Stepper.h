#pragma once
// One time step of a dimensionless vesicle.

#include "solver/dynamics/MeshMotion.h"
#include "solver/dynamics/StageProblem.h"
#include "solver/dynamics/StepControl.h"
#include "solver/mesh/Connectivity.h"
#include "solver/state/State.h"

namespace vesicle
{

struct StepperSettings
{
  Scene::Basis basis = Scene::Basis::linear;
  Scene::Integrator integrator = Scene::Integrator::imex_midpoint;
  Scene::MeshMotion mesh_motion = Scene::MeshMotion::equidistribute;
  int quadrature = 3;
  double linear_tolerance = 1e-10;
  bool adaptive = true;
  StepLimits limits;
};

/// IMEX midpoint, second order and L-stable:
///   x_h = x + (dt/2) w₁,  u₁ solved at x with bending implicit over γ dt,  γ = 1 − 1/√2
///   x'  = x + dt w₂,      u₂ solved at x_h with φ = φ(x_h) + γ dt R [(u₂ − U₂) − (u₁ − U₁)]
/// On ẋ = −λx this is the two-stage SDIRK method (Alexander, SIAM J. Numer. Anal. 14 (1977) 1006);
/// the correction in φ is O(dt²) for any R, so that a frozen, normal-only R keeps the order. The
/// velocity is divergence-free at the midpoint shape, which leaves an area error of third order
/// only, and both stages have the same matrix. Node velocities w follow from u (MeshMotion.h). The
/// difference u₂ − u₁ is a free error estimate. IMEX Euler: x' = x + dt w₁, bending implicit over
/// dt, paper (40).
class Stepper
{
public:
  Stepper(
    const Model& model, const Triangles& triangles, int nodes, const StepperSettings& settings);

  const Discretization& discretization() const { return *discretization_; }
  /// The operators at a shape; those of the last shapes asked for are kept.
  std::shared_ptr<const ShapeOperators> shape(const Points& vertices) const;
  /// The rate that sets the pace: the largest of bending's 1, the flow's and buoyancy's.
  double scene_rate() const;
  /// The longest step that mesh motion allows at this state.
  double longest_step(const State& state) const;

  /// Fills velocity, tension, bending, node velocity of `state` for its points and next_step.
  void solve(State& state) const;

  /// Error of an Euler step from `before` to `after`, known once `after` is solved: (dt/2)
  /// max|n·Δu|.
  double euler_error(const State& before, const State& after) const;

  /// The state after an attempted step of `state.next_step`, not yet solved (velocity and forces
  /// are the midpoint's), with what there is to say about it. NumericalError of a linear solve is
  /// passed on.
  State attempt(const State& state, StepReport& report) const;

private:
  struct Stage
  {
    std::shared_ptr<const ShapeOperators> shape;
    StageSolution solution;
  };
  Stage solve_stage(
    State& state, const Points& points, double dt, const Eigen::VectorXd& reference) const;
  void factorize(const StageProblem& problem, State& state, const Points& points, double dt) const;
  void restore_preconditioner(const State& state) const;
  double implicit_fraction() const;
  bool only_relaxes() const; ///< nothing but bending moves the vesicle: its energy can't rise
  Points node_velocity(
    const ShapeOperators& shape, const Points& points, const Points& velocity) const;

  Model model_;
  StepperSettings settings_;
  std::unique_ptr<Discretization> discretization_;
  AdjacencyList neighbours_;
  // Buffers and the factorisation that the state's preconditioner_points stand for.
  mutable VelocityResponse response_;
  mutable std::shared_ptr<const ShapeOperators> shape_;
  mutable DenseFactorization factorization_;
  mutable Points factorized_points_;
  mutable double factorized_step_ = 0;
};

}
