#pragma once
// One time step of a dimensionless system.

#include "solver/dynamics/MeshMotion.h"
#include "solver/dynamics/StageSolver.h"
#include "solver/dynamics/State.h"
#include "solver/dynamics/StepControl.h"
#include "solver/dynamics/Method.h"
#include "solver/dynamics/WallGap.h"
#include "solver/mesh/Connectivity.h"

namespace vesicle
{

struct StepperSettings
{
  Integrator integrator = Integrator::imex_midpoint;
  LayerSettings layer;
  double linear_tolerance = 1e-10;
  StepLimits limits;
  double time_unit = 1; ///< t0 in the units of State::time
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
  Stepper(System system, const StepperSettings& settings);

  const System& system() const { return system_; }
  const StepperSettings& settings() const { return settings_; }
  /// The system at the shapes of a state; that of the last shapes asked for is kept.
  std::shared_ptr<const SystemShape> shape(const State& state);
  /// The longest step that mesh motion allows at this state, and vesicles that approach each other or
  /// a wall.
  double longest_step(const State& state);
  /// Throws NumericalError where vesicles are in contact with each other or a wall, or cross.
  void require_apart(const State& state);

  /// Fills velocities, tensions, stiff forces and node velocities of `state` for its points and its
  /// next step; what it has of them is the first guess.
  void solve(State& state);

  /// The state after an attempted step of `state`'s next step, not yet solved (velocities, tensions and
  /// multipliers are extrapolated, Euler's those before: solve()'s first guess), with what there is to say about it. NumericalError of a linear
  /// solve is passed on.
  State attempt(const State& state, StepReport& report);
  /// What is known of a step's error only once `after` is solved, into the report: Euler's,
  /// (dt/2) max|n·Δu|.
  void complete(const State& before, const State& after, StepReport& report);

private:
  struct Solved
  {
    std::shared_ptr<const SystemShape> shape;
    StageSolution solution;
    /// Of vesicles with loads whose nodes slide.
    std::vector<std::unique_ptr<const TangentialMotion>> sliding;
  };

  /// What is between the vesicles of a shape, and them and a wall.
  struct Neighbourhood
  {
    std::shared_ptr<const SystemShape> shape;
    Proximity proximity;
    std::optional<Gap> gap;
    std::vector<WallGap> walls; ///< of each vesicle; empty without a wall
    double edge;                ///< the mean edge, of all vesicles
    /// The vesicle that is nearest to the wall.
    std::size_t lowest() const;
  };

  /// In t0.
  double time_of(const State& state) const { return state.time / settings_.time_unit; }
  std::shared_ptr<const SystemShape> shape(const std::vector<Points>& points, double time);
  Solved solve_stage(State& state, const std::vector<Points>& points, double time, double dt,
    const Eigen::VectorXd& reference);
  double implicit_fraction() const;
  std::vector<Points> node_velocities(const Solved& stage, const State* reference) const;
  void advance_midpoint(
    const State& before, State& after, const Eigen::VectorXd& relative, StepReport& report);
  void restore_area_and_volume(State& after, const SystemShape& start, StepReport& report);
  bool has_neighbours() const { return system_.vesicles.size() > 1 || system_.wall; }
  double mean_edge(const SystemShape& shape) const;
  const Neighbourhood& neighbourhood(const std::shared_ptr<const SystemShape>& shape);
  double longest_approach(const State& state);
  double longest_fall(const State& state) const;
  std::string contact(const Neighbourhood& now) const;
  void look_for_contact(
    const State& after, const std::shared_ptr<const SystemShape>& start, StepReport& report);

  System system_;
  StepperSettings settings_;
  std::vector<AdjacencyList> neighbours_; ///< of each vesicle's vertices
  // What is kept between steps and never changes a result.
  std::shared_ptr<const SystemShape> shape_;           ///< of the last shapes and time asked for
  std::unique_ptr<const Neighbourhood> neighbourhood_; ///< of the last shape asked for
  std::unique_ptr<StageSolver> stages_;
};

/// Of all vesicles.
std::vector<Points> points_of(const State& state);
/// Velocities of all vertices, 3N.
Eigen::VectorXd velocity_of(const State& state);
/// u − U of all vertices, U the velocity of each vesicle's centroid.
Eigen::VectorXd relative_to_centroids(const SystemShape& shape, const Eigen::VectorXd& velocity);
/// max|n·u| over all vertices.
double largest_normal(const SystemShape& shape, const Eigen::VectorXd& velocity);

}
