#include "solver/dynamics/Stepper.h"

#include "solver/Errors.h"
#include "solver/ParallelFor.h"
#include "solver/dynamics/Projection.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vesicle
{

namespace
{

constexpr double sdirk_gamma = 1 - 1 / std::numbers::sqrt2;
// Nodes relax towards the wanted edge lengths by less than half the way in a step, and pass less than
// a quarter of an edge of membrane flow.
constexpr double longest_relaxation = 0.5;
constexpr double longest_passage = 0.25;
// Distances between vesicles are looked at where they are below so many mean edges.
constexpr double near_edges = 2;
// Of a step that takes the largest share of a gap that is allowed.
constexpr double approach_margin = 0.5;

// The largest normal displacement of a step, in the mean edges of each vesicle.
double largest_displacement(const SystemShape& shape, const Eigen::VectorXd& displacement,
  const std::vector<AdjacencyList>& neighbours)
{
  double largest = 0;
  for (std::size_t v = 0; v < shape.vesicles.size(); ++v)
  {
    const Surface& surface = *shape.vesicles[v].surface;
    const Points own = rows_of_three(shape.part(displacement, v));
    largest = std::max(largest,
      surface.normals.cwiseProduct(own).rowwise().sum().cwiseAbs().maxCoeff() /
        mean_edge(surface.vertices, neighbours[v]));
  }
  return largest;
}

double energy(const SystemShape& shape)
{
  double sum = 0;
  for (const VesicleShape& v : shape.vesicles)
    sum += v.vesicle->energy(*v.surface);
  return sum;
}

}

// By how much a membrane's energy rises, in its own or, if that is less, a sphere's bending energy.
static double largest_jump(const SystemShape& before, const SystemShape& after)
{
  constexpr double sphere = 8 * std::numbers::pi;
  double largest = 0;
  for (std::size_t v = 0; v < before.vesicles.size(); ++v)
  {
    const Vesicle& vesicle = *before.vesicles[v].vesicle;
    if (!vesicle.has_energy())
      continue;
    const double from = vesicle.energy(*before.vesicles[v].surface),
                 to = vesicle.energy(*after.vesicles[v].surface);
    largest = std::max(largest, (to - from) / std::max(from, sphere));
  }
  return largest;
}

std::vector<Points> points_of(const State& state)
{
  std::vector<Points> points;
  for (const VesicleState& v : state.vesicles)
    points.push_back(v.points);
  return points;
}

Eigen::VectorXd velocity_of(const State& state)
{
  Eigen::Index size = 0;
  for (const VesicleState& v : state.vesicles)
    size += v.velocity.size();
  Eigen::VectorXd velocity(size);
  Eigen::Index first = 0;
  for (const VesicleState& v : state.vesicles)
  {
    velocity.segment(first, v.velocity.size()) = flat(v.velocity);
    first += v.velocity.size();
  }
  return velocity;
}

Eigen::VectorXd relative_to_centroids(const SystemShape& shape, const Eigen::VectorXd& velocity)
{
  Eigen::VectorXd relative(velocity.size());
  for (std::size_t v = 0; v < shape.vesicles.size(); ++v)
  {
    const Eigen::VectorXd own = shape.part(velocity, v);
    relative.segment(3 * shape.first[v], own.size()) =
      shape.vesicles[v].surface->relative_to_centroid(own);
  }
  return relative;
}

double largest_normal(const SystemShape& shape, const Eigen::VectorXd& velocity)
{
  double largest = 0;
  for (std::size_t v = 0; v < shape.vesicles.size(); ++v)
    largest = std::max(largest,
      shape.vesicles[v]
        .surface->normals.cwiseProduct(rows_of_three(shape.part(velocity, v)))
        .rowwise()
        .sum()
        .cwiseAbs()
        .maxCoeff());
  return largest;
}

Stepper::Stepper(System system, const StepperSettings& settings)
  : system_(std::move(system)), settings_(settings)
{
  for (const Vesicle& vesicle : system_.vesicles)
    neighbours_.push_back(
      Connectivity(vesicle.space->triangles(), vesicle.space->nodes()).vertex_neighbours);
  stages_ = make_stage_solver(system_, settings_.layer);
}

double Stepper::implicit_fraction() const
{
  return settings_.integrator == Integrator::imex_midpoint ? sdirk_gamma : 1;
}

std::shared_ptr<const SystemShape> Stepper::shape(const std::vector<Points>& points, double time)
{
  const bool varies = system_.flow && system_.flow->at(time);
  if (!shape_ || shape_->points != points || (varies && shape_->time != time))
    shape_ = std::make_shared<const SystemShape>(system_, points, time);
  return shape_;
}

std::shared_ptr<const SystemShape> Stepper::shape(const State& state)
{
  return shape(points_of(state), time_of(state));
}

double Stepper::longest_step(const State& state)
{
  const auto now = shape(state);
  double longest = INFINITY;
  for (std::size_t v = 0; v < state.vesicles.size(); ++v)
  {
    if (system_.vesicles[v].motion == NodeMotionKind::material)
      continue;
    const Surface& surface = *now->vesicles[v].surface;
    const Points& velocity = state.vesicles[v].velocity;
    const double speed = tangential_speed(surface, velocity);
    longest =
      std::min(longest, longest_relaxation / relaxation_rate(surface, velocity, system_.rate()));
    if (speed > 0)
      longest = std::min(
        longest, longest_passage * vesicle::mean_edge(surface.vertices, neighbours_[v]) / speed);
  }
  return has_neighbours() ? std::min(longest, longest_approach(state)) : longest;
}

// Of all vesicles.
double Stepper::mean_edge(const SystemShape& shape) const
{
  double sum = 0;
  for (std::size_t v = 0; v < shape.vesicles.size(); ++v)
    sum += vesicle::mean_edge(shape.points[v], neighbours_[v]);
  return sum / static_cast<double>(shape.vesicles.size());
}

// A step's end is the next one's start: each shape is looked at once.
const Stepper::Neighbourhood& Stepper::neighbourhood(
  const std::shared_ptr<const SystemShape>& shape)
{
  if (!neighbourhood_ || neighbourhood_->shape != shape)
  {
    const double edge = mean_edge(*shape);
    Proximity proximity(sides(*shape), near_edges * edge);
    std::optional<Gap> gap = proximity.smallest();
    std::vector<WallGap> walls;
    if (system_.wall)
      walls = wall_gaps(*system_.wall, sides(*shape));
    neighbourhood_ = std::make_unique<const Neighbourhood>(
      Neighbourhood{ shape, std::move(proximity), gap, std::move(walls), edge });
  }
  return *neighbourhood_;
}

// A share of the gap over the speed at which vertices and the other surface approach each other.
double Stepper::longest_approach(const State& state)
{
  double longest = INFINITY;
  for (const Proximity::NearVertex& near : neighbourhood(shape(state)).proximity.near())
  {
    const auto& corners = system_.vesicles[near.other].space->triangles().row(near.place.triangle);
    Eigen::RowVector3d there = Eigen::RowVector3d::Zero();
    for (int k = 0; k < 3; ++k)
      there += near.place.weights[k] * state.vesicles[near.other].velocity.row(corners[k]);
    const double closing = (there - state.vesicles[near.vesicle].velocity.row(near.vertex))
                             .dot(near.place.normal.transpose());
    if (closing > 0 && near.place.distance > 0)
      longest = std::min(
        longest, approach_margin * settings_.limits.gap_share * near.place.distance / closing);
  }
  return std::min(longest, longest_fall(state));
}

// The same towards a wall.
double Stepper::longest_fall(const State& state) const
{
  double longest = INFINITY;
  if (!system_.wall)
    return longest;
  for (const VesicleState& vesicle : state.vesicles)
  {
    const Eigen::VectorXd height = system_.wall->heights(vesicle.points),
                          falling = -(vesicle.velocity * system_.wall->normal);
    for (Eigen::Index i = 0; i < height.size(); ++i)
      if (falling[i] > 0 && height[i] > 0)
        longest =
          std::min(longest, approach_margin * settings_.limits.gap_share * height[i] / falling[i]);
  }
  return longest;
}

std::size_t Stepper::Neighbourhood::lowest() const
{
  return std::min_element(walls.begin(), walls.end(),
           [](const WallGap& a, const WallGap& b) { return a.distance < b.distance; }) -
    walls.begin();
}

// Which surfaces are closer than their meshes tell, and what to try; empty: none.
std::string Stepper::contact(const Neighbourhood& now) const
{
  constexpr const char* closer = ", lengths in r0: closer than the meshes tell. Try more triangles";
  if (now.gap && now.gap->distance < settings_.limits.contact * now.edge)
    return to_text(*now.gap) + closer + ", or a repulsion between vesicles.";
  if (now.walls.empty())
    return {};
  const std::size_t lowest = now.lowest();
  if (now.walls[lowest].distance >= settings_.limits.wall_contact * now.edge)
    return {};
  const std::string which =
    now.walls.size() > 1 ? fmt::format("vesicle {} ", lowest) : "the vesicle ";
  return which + to_text(now.walls[lowest]) + closer + ".";
}

void Stepper::require_apart(const State& state)
{
  if (!has_neighbours())
    return;
  if (const std::string told = contact(neighbourhood(shape(state))); !told.empty())
    throw NumericalError(told);
}

void Stepper::look_for_contact(
  const State& after, const std::shared_ptr<const SystemShape>& start, StepReport& report)
{
  const std::optional<Gap> before = neighbourhood(start).gap;
  const std::vector<WallGap> walls_before = neighbourhood(start).walls;
  const Neighbourhood& now = neighbourhood(shape(after));
  if (now.gap)
  {
    report.gap_before = before ? before->distance / now.edge : near_edges;
    report.gap = now.gap->distance / now.edge;
  }
  if (!now.walls.empty())
  {
    const std::size_t lowest = now.lowest();
    report.wall_gap_before = walls_before[lowest].distance / now.edge;
    report.wall_gap = now.walls[lowest].distance / now.edge;
  }
  report.contact = contact(now);
}

Stepper::Solved Stepper::solve_stage(State& state, const std::vector<Points>& points, double time,
  double dt, const Eigen::VectorXd& reference)
{
  const auto there = shape(points, time);
  const double tau = implicit_fraction() * dt;
  Solved solved{ there, {}, {} };
  solved.sliding.resize(there->vesicles.size());
  run_together({ [&]
    {
      solved.solution =
        stages_->solve(*there, { dt, tau, reference, settings_.linear_tolerance }, state);
    },
    [&]
    {
      parallel_for(there->vesicles.size(),
        [&](std::size_t v)
        {
          if (there->vesicles[v].loads && system_.vesicles[v].motion != NodeMotionKind::material)
            solved.sliding[v] = std::make_unique<const TangentialMotion>(
              sliding_motion(*there->vesicles[v].loads, tau));
        });
    } });
  return solved;
}

// `reference`: the state whose node velocities the implicit part is measured from, or nullptr.
std::vector<Points> Stepper::node_velocities(const Solved& stage, const State* reference) const
{
  std::vector<Points> result(stage.shape->vesicles.size());
  parallel_for(result.size(),
    [&](std::size_t v)
    {
      const VesicleShape& shape = stage.shape->vesicles[v];
      const Points velocity = rows_of_three(stage.shape->part(stage.solution.velocity, v));
      if (system_.vesicles[v].motion == NodeMotionKind::material)
        result[v] = velocity;
      else if (stage.sliding[v])
        result[v] = sliding_velocity(*shape.loads, *stage.sliding[v], neighbours_[v], velocity,
          system_.rate(), reference ? reference->vesicles[v].node_velocity : Points(0, 3));
      else
        result[v] =
          equidistributing_velocity(*shape.surface, neighbours_[v], velocity, system_.rate());
    });
  return result;
}

void Stepper::solve(State& state)
{
  const Solved stage =
    solve_stage(state, points_of(state), time_of(state), state.controller.next_step, {});
  const std::vector<Points> node_velocity = node_velocities(stage, nullptr);
  for (std::size_t v = 0; v < state.vesicles.size(); ++v)
  {
    VesicleState& vesicle = state.vesicles[v];
    const StageSolution::Part& part = stage.solution.vesicles[v];
    vesicle.velocity = rows_of_three(stage.shape->part(stage.solution.velocity, v));
    vesicle.node_velocity = node_velocity[v];
    vesicle.tension = part.tension;
    vesicle.stiff_force = part.stiff_force;
    vesicle.volume_speed = part.volume_speed;
    vesicle.pressure = part.pressure;
  }
}

void Stepper::complete(const State& before, const State& after, StepReport& report)
{
  if (settings_.integrator == Integrator::imex_euler)
    report.error = after.controller.last_step / 2 *
      largest_normal(*shape(after), velocity_of(after) - velocity_of(before));
}

State Stepper::attempt(const State& before, StepReport& report)
{
  const double dt = before.controller.next_step;
  State after = before;
  after.iterations = 0;
  after.controller.last_step = dt;
  after.step = before.step + 1;
  after.time = before.time + dt * settings_.time_unit;
  report = {};
  const auto start = shape(before);
  const Eigen::VectorXd relative = relative_to_centroids(*start, velocity_of(before));
  report.displacement = largest_displacement(*start, dt * relative, neighbours_);
  if (settings_.integrator == Integrator::imex_midpoint)
    advance_midpoint(before, after, relative, report);
  else
    for (VesicleState& vesicle : after.vesicles)
      vesicle.points += dt * vesicle.node_velocity;
  restore_area_and_volume(after, *start, report);
  if (has_neighbours() && report.finite)
    look_for_contact(after, start, report);
  return after;
}

void Stepper::advance_midpoint(
  const State& before, State& after, const Eigen::VectorXd& relative, StepReport& report)
{
  const double dt = before.controller.next_step;
  std::vector<Points> halfway = points_of(before);
  for (std::size_t v = 0; v < halfway.size(); ++v)
    halfway[v] += dt / 2 * before.vesicles[v].node_velocity;
  const Solved middle = solve_stage(after, halfway, time_of(before) + dt / 2, dt, relative);
  const std::vector<Points> node_velocity = node_velocities(middle, &before);
  for (std::size_t v = 0; v < halfway.size(); ++v)
  {
    const VesicleState& start = before.vesicles[v];
    const StageSolution::Part& half = middle.solution.vesicles[v];
    VesicleState& end = after.vesicles[v];
    end.points = start.points + dt * node_velocity[v];
    end.velocity =
      2 * rows_of_three(middle.shape->part(middle.solution.velocity, v)) - start.velocity;
    end.tension = 2 * half.tension - start.tension;
    end.pressure = 2 * half.pressure - start.pressure;
    end.volume_speed = 2 * half.volume_speed - start.volume_speed;
  }
  report.error = dt * largest_normal(*middle.shape, middle.solution.velocity - velocity_of(before));
}

// What the step changed of each vesicle's area and volume, and that taken out unless the step is to
// be rejected.
void Stepper::restore_area_and_volume(State& after, const SystemShape& start, StepReport& report)
{
  const auto finite = [&]
  {
    return std::all_of(after.vesicles.begin(), after.vesicles.end(),
      [](const VesicleState& vesicle) { return vesicle.points.allFinite(); });
  };
  report.finite = finite();
  if (!report.finite)
    return;
  for (std::size_t v = 0; v < after.vesicles.size(); ++v)
  {
    const VesicleShape& before = start.vesicles[v];
    const AreaAndVolume reached(*before.vesicle->space, after.vesicles[v].points);
    if (before.constraint)
      report.area_change =
        std::max(report.area_change, std::abs(reached.area() / before.surface->area - 1));
    report.volume_change =
      std::max(report.volume_change, std::abs(reached.volume() / before.surface->volume - 1));
  }
  if (!reason_to_reject(report, settings_.limits).empty())
    return;
  std::vector<double> left(after.vesicles.size(), 0);
  parallel_for(left.size(),
    [&](std::size_t v)
    {
      const VesicleShape& before = start.vesicles[v];
      if (!before.vesicle->conserved)
        return;
      VesicleState& vesicle = after.vesicles[v];
      const ProjectionResult removed =
        project_area_and_volume(vesicle.points, *before.vesicle->space, vesicle.target_area,
          vesicle.target_volume, !before.constraint || before.gauge_pinned());
      vesicle.area_correction += removed.area_removed;
      vesicle.volume_correction += removed.volume_removed;
      left[v] = removed.left;
    });
  for (const double of_vesicle : left)
    report.constraint_left += of_vesicle; // of all: a sum keeps a NaN
  report.finite = finite();
  if (!report.finite)
    return;
  if (system_.only_relaxes())
    report.energy_rise = energy(*shape(after)) / energy(start) - 1;
  else
    report.energy_jump = largest_jump(start, *shape(after));
}

}
