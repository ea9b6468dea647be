#include "solver/dynamics/Stepper.h"

#include "solver/Errors.h"
#include "solver/dynamics/Projection.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vesicle
{

namespace
{

constexpr double sdirk_gamma = 1 - 1 / std::numbers::sqrt2;
// Above this many iterations a new factorisation pays for itself in the following solves.
constexpr int stale_iterations = 12;
// A factorisation helps only near the step it was made for.
constexpr double stale_step_ratio = 2;
constexpr int max_iterations = 60;
// Nodes relax towards equal areas by less than half the way in a step, and pass less than a quarter
// of an edge of membrane flow.
constexpr double longest_relaxation = 0.5;
constexpr double longest_passage = 0.25;

double mean_edge(const Points& points, const AdjacencyList& neighbours)
{
  double sum = 0;
  for (int i = 0; i < points.rows(); ++i)
    for (const int* j = neighbours.begin(i); j != neighbours.end(i); ++j)
      sum += (points.row(*j) - points.row(i)).norm();
  return sum / static_cast<double>(neighbours.item.size());
}

double largest_normal(const ShapeOperators& shape, const Eigen::VectorXd& vector)
{
  return (shape.outward.cwiseProduct(rows_of_three(vector))).rowwise().sum().cwiseAbs().maxCoeff();
}

}

Stepper::Stepper(
  const Model& model, const Triangles& triangles, int nodes, const StepperSettings& settings)
  : model_(model), settings_(settings),
    discretization_((settings.basis == Scene::Basis::loop
        ? make_loop_discretization
        : make_linear_discretization)(model, triangles, nodes, settings.quadrature)),
    neighbours_(Connectivity(triangles, nodes).vertex_neighbours)
{
}

double Stepper::scene_rate() const
{
  const double settling = 2. / 9 * std::abs(model_.bond); // of a sphere, in r0 a time unit
  return std::max(
    { model_.bending ? 1. : 0., model_.flow ? model_.flow->imposed_rate() : 0., settling });
}

double Stepper::implicit_fraction() const
{
  return settings_.integrator == Scene::Integrator::imex_midpoint ? sdirk_gamma : 1;
}

std::shared_ptr<const ShapeOperators> Stepper::shape(const Points& vertices) const
{
  if (!shape_ || shape_->vertices != vertices)
    shape_ = std::make_shared<const ShapeOperators>(discretization_->shape(vertices));
  return shape_;
}

bool Stepper::only_relaxes() const
{
  return model_.bending && model_.robust() && model_.bond == 0 && !model_.flow;
}

double Stepper::longest_step(const State& state) const
{
  if (settings_.mesh_motion == Scene::MeshMotion::material)
    return INFINITY;
  const auto now = shape(state.points);
  const double speed = tangential_speed(*now, state.velocity);
  const double relaxation = relaxation_rate(*now, state.velocity, scene_rate());
  return std::min(longest_relaxation / relaxation,
    speed > 0 ? longest_passage * mean_edge(state.points, neighbours_) / speed : INFINITY);
}

void Stepper::factorize(
  const StageProblem& problem, State& state, const Points& points, double dt) const
{
  factorization_.compute(problem.dense());
  factorized_points_ = state.preconditioner_points = points;
  factorized_step_ = state.preconditioner_step = dt;
}

// After a restart the factorisation is made again where the uninterrupted run made it.
void Stepper::restore_preconditioner(const State& state) const
{
  if (state.preconditioner_step == 0 ||
    (factorized_step_ == state.preconditioner_step &&
      factorized_points_ == state.preconditioner_points))
    return;
  const auto there = shape(state.preconditioner_points);
  discretization_->respond(*there, response_);
  State unused;
  factorize(StageProblem(model_, *discretization_, *there, response_,
              implicit_fraction() * state.preconditioner_step),
    unused, state.preconditioner_points, state.preconditioner_step);
}

Stepper::Stage Stepper::solve_stage(
  State& state, const Points& points, double dt, const Eigen::VectorXd& reference) const
{
  restore_preconditioner(state);
  Stage stage{ shape(points), {} };
  discretization_->respond(*stage.shape, response_);
  const StageProblem problem(
    model_, *discretization_, *stage.shape, response_, implicit_fraction() * dt);
  const double ratio = state.preconditioner_step > 0 ? dt / state.preconditioner_step : 0;
  const bool fresh = !(ratio < stale_step_ratio && ratio > 1 / stale_step_ratio) ||
    factorization_.size() != problem.unknowns();
  if (problem.unknowns() > 0 && fresh)
    factorize(problem, state, points, dt);
  try
  {
    stage.solution =
      problem.solve(factorization_, settings_.linear_tolerance, max_iterations, reference);
  }
  catch (const NumericalError&)
  {
    if (fresh)
      throw;
    factorize(problem, state, points, dt);
    stage.solution =
      problem.solve(factorization_, settings_.linear_tolerance, max_iterations, reference);
  }
  state.iterations += stage.solution.iterations;
  if (stage.solution.iterations > stale_iterations)
    state.preconditioner_step = 0; // the next solve makes a new one
  return stage;
}

Points Stepper::node_velocity(
  const ShapeOperators& shape, const Points& points, const Points& velocity) const
{
  return settings_.mesh_motion == Scene::MeshMotion::material
    ? velocity
    : equidistributing_velocity(shape, neighbours_, points, velocity, scene_rate());
}

void Stepper::solve(State& state) const
{
  const Stage stage = solve_stage(state, state.points, state.next_step, {});
  state.velocity = rows_of_three(stage.solution.velocity);
  state.tension = stage.solution.tension;
  state.bending = stage.solution.bending;
  state.volume_speed = Eigen::VectorXd::Constant(1, stage.solution.volume_speed);
  state.node_velocity = node_velocity(*stage.shape, state.points, state.velocity);
}

double Stepper::euler_error(const State& before, const State& after) const
{
  return after.last_step / 2 *
    largest_normal(*shape(after.points), flat(after.velocity) - flat(before.velocity));
}

State Stepper::attempt(const State& before, StepReport& report) const
{
  const double dt = before.next_step;
  State after = before;
  after.iterations = 0;
  after.last_step = dt;
  after.step = before.step + 1;
  report = {};
  const auto start = shape(before.points);
  const Eigen::VectorXd first = StageProblem::relative_to_centroid(*start, flat(before.velocity));
  report.displacement = dt * largest_normal(*start, first) / mean_edge(before.points, neighbours_);

  if (settings_.integrator == Scene::Integrator::imex_euler)
    after.points = before.points + dt * before.node_velocity;
  else
  {
    const Points halfway = before.points + dt / 2 * before.node_velocity;
    const Stage middle = solve_stage(after, halfway, dt, first);
    const Points u = rows_of_three(middle.solution.velocity);
    after.points = before.points + dt * node_velocity(*middle.shape, halfway, u);
    report.error =
      dt * largest_normal(*middle.shape, middle.solution.velocity - flat(before.velocity));
  }
  report.finite = after.points.allFinite();
  if (!report.finite)
    return after;

  const Constraints reached = discretization_->constraints(after.points);
  report.area_change = model_.incompressible ? std::abs(reached.area / start->area - 1) : 0;
  report.volume_change = std::abs(reached.volume / start->volume - 1);
  if (model_.robust() && reason_to_reject(report, settings_.limits).empty())
  {
    const ProjectionResult removed = project_area_and_volume(after.points, *discretization_,
      before.target_area, before.target_volume, !model_.incompressible || start->gauge_pinned);
    after.area_correction += removed.area_removed;
    after.volume_correction += removed.volume_removed;
    report.finite = after.points.allFinite();
    if (only_relaxes())
      report.energy_rise =
        discretization_->bending_energy(after.points) / start->bending_energy - 1;
  }
  return after;
}

}
