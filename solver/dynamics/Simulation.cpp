#include "solver/dynamics/Simulation.h"

#include "solver/Errors.h"
#include "solver/dynamics/Observables.h"
#include "solver/dynamics/StartMesh.h"
#include "solver/dynamics/Stepper.h"
#include "solver/dynamics/SurfaceMeasures.h"
#include "solver/mesh/MeshIntegrals.h"
#include "solver/mesh/MeshQuality.h"
#include "solver/mesh/Preparation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vesicle
{

namespace
{

// The first step of an adaptive run, in units of the scene's own time; the controller takes over.
constexpr double first_step = 1e-2;
// Where the scene has no rate of its own (nothing moves, or nothing but a uniform flow).
constexpr double idle_rate = 1;
// Shorter steps than this fraction of the scene's time mean that the run is stuck.
constexpr double shortest_step = 1e-6;
constexpr int max_attempts = 40;
// end = "steady": the shape's normal speed relative to its centroid, in r0 times the scene's rate.
constexpr double steady_speed = 2e-3;

Scales make_scales(const Scene& scene, const TriangleMesh& mesh)
{
  return { equivalent_radius(surface_measures(scene.accuracy.basis, mesh).volume),
    scene.membrane.bending_rigidity.value_or(1), scene.fluid.viscosity };
}

double bond_number(const Scene& scene, const Scales& scales)
{
  if (!scene.gravity)
    return 0;
  if (scene.gravity->bond_number)
    return *scene.gravity->bond_number;
  return scene.gravity->density_difference * scene.gravity->acceleration *
    std::pow(scales.length, 4) / scales.energy;
}

Model make_model(const Scene& scene, const Scales& scales)
{
  Model model;
  model.bending = scene.membrane.bending_rigidity.has_value();
  model.fitted_bending = scene.accuracy.bending == Scene::Bending::fit;
  model.incompressible = scene.membrane.incompressible;
  model.bond = bond_number(scene, scales);
  if (scene.flow)
    model.flow = scene.flow->dimensionless(scales.length, scales.velocity());
  model.scheme = scene.accuracy.scheme;
  return model;
}

StepperSettings make_settings(const Scene& scene)
{
  StepperSettings settings;
  settings.basis = scene.accuracy.basis;
  settings.integrator = scene.accuracy.integrator;
  settings.mesh_motion = scene.accuracy.mesh_motion;
  settings.quadrature = scene.accuracy.quadrature;
  settings.linear_tolerance = scene.accuracy.linear_tolerance;
  settings.adaptive = !scene.time.step;
  // A step that the user has fixed is taken whatever its error is estimated at.
  settings.limits.tolerance = settings.adaptive ? scene.time.tolerance : INFINITY;
  return settings;
}

// k · every, without the rounding of decimal fractions where 1/every is a whole number.
double multiple(std::int64_t k, double every)
{
  const double inverse = std::round(1 / every);
  return std::abs(inverse * every - 1) < 1e-12 ? static_cast<double>(k) / inverse
                                               : static_cast<double>(k) * every;
}

}

struct Simulation::Impl
{
  Scene scene;
  std::string notes;
  TriangleMesh start_mesh; ///< in the scene's units
  Scales scales;
  Model model;
  StepperSettings settings;
  Stepper stepper;

  Impl(const Scene& s, TriangleMesh mesh, const std::string& start_notes)
    : scene(s), notes(prepare_for_dynamics(mesh,
                  s.vesicle.mesh_file ? s.vesicle.mesh_file->string() : std::string("start mesh"))),
      start_mesh(std::move(mesh)), scales(make_scales(s, start_mesh)), model(make_model(s, scales)),
      settings(make_settings(s)),
      stepper(model, start_mesh.triangles, static_cast<int>(start_mesh.points.rows()), settings)
  {
    for (const std::string& note : { start_notes, check_smoothness(scene, start_mesh) })
      if (!note.empty())
        notes = notes.empty() ? note : note + "\n" + notes;
  }

  double rate() const
  {
    const double rate = stepper.scene_rate();
    return rate > 0 ? rate : idle_rate;
  }

  std::optional<double> next_target(const State& state) const;
  void plan_next_step(State& state) const;
  bool overshoots(const State& state) const;
  bool steady(const State& state) const;
  void add_observables(const State& state, const ShapeOperators& shape, Diagnostics& d) const;
  State unsolved() const; ///< the start shape at rest
};

// The next time, in the scene's units, that must be hit exactly.
std::optional<double> Simulation::Impl::next_target(const State& state) const
{
  std::optional<double> target;
  if (scene.time.output_every > 0)
    target = multiple(state.output, scene.time.output_every);
  if (scene.time.end && (!target || *scene.time.end < *target))
    target = scene.time.end;
  return target;
}

// next_step from free_step: no longer than the mesh allows, and such that the next target is hit.
void Simulation::Impl::plan_next_step(State& state) const
{
  double dt = state.free_step;
  if (settings.adaptive && state.velocity.rows() > 0)
    dt = std::min(dt, stepper.longest_step(state));
  if (const auto target = next_target(state); target && *target > state.time)
    dt = step_towards(dt, state.time / scales.time(), *target / scales.time());
  state.next_step = dt;
}

// True for the last state of a run whose end has been put off since.
bool Simulation::Impl::overshoots(const State& state) const
{
  const auto target = next_target(state);
  return target && state.next_step > (*target - state.time) / scales.time() * (1 + 1e-9);
}

bool Simulation::Impl::steady(const State& state) const
{
  const auto kept = stepper.shape(state.points);
  const ShapeOperators& shape = *kept;
  const Eigen::VectorXd relative = StageProblem::relative_to_centroid(shape, flat(state.velocity));
  const double speed =
    shape.outward.cwiseProduct(rows_of_three(relative)).rowwise().sum().cwiseAbs().maxCoeff();
  return speed < steady_speed * rate();
}

// What the field reports of shape and motion.
void Simulation::Impl::add_observables(
  const State& state, const ShapeOperators& shape, Diagnostics& d) const
{
  const Discretization& operators = stepper.discretization();
  const BasisTable& table = operators.table();
  const SurfacePoints surface = evaluate(table, shape.control);

  const InertiaEllipsoid ellipsoid = inertia_ellipsoid(surface, shape.center);
  d.inclination_deg = ellipsoid.inclination_deg;
  d.tilt_deg = ellipsoid.tilt_deg;
  for (int i = 0; i < 3; ++i)
    d.semi_axes[i] = ellipsoid.semi_axes[i] * scales.length;
  d.taylor_deformation = (d.semi_axes[0] - d.semi_axes[2]) / (d.semi_axes[0] + d.semi_axes[2]);
  if (const auto amplitudes = harmonic_amplitudes(surface, shape.center, d.harmonic_degree))
    std::copy(amplitudes->begin(), amplitudes->end(), d.harmonics.emplace().begin());

  const Vector3 U = shape.centroid_velocity * flat(state.velocity);
  const FlatSample sample = operators.sample_around(shape.center.y(), shape, state.velocity);
  d.tank_treading_frequency =
    tank_treading_frequency(sample.mesh, sample.field, shape.center, U) / scales.time();

  RowVectors bending;
  if (model.bending)
    bending = interpolate(
      table, rows_of_three(operators.to_control(operators.bending_force(shape, state.bending))));
  Eigen::VectorXd tension;
  if (model.incompressible)
    tension = interpolate(table, state.tension);
  const Eigen::Matrix3d S = scales.energy * stresslet(surface, shape.center, bending, tension);
  d.stresslet = { S(0, 0), S(0, 1), S(0, 2), S(1, 1), S(1, 2), S(2, 2) };
}

Simulation::Simulation(const Scene& scene, TriangleMesh start, const std::string& notes)
  : impl_(std::make_unique<Impl>(scene, std::move(start), notes))
{
}

Simulation::~Simulation() = default;

const Scene& Simulation::scene() const
{
  return impl_->scene;
}

const Scales& Simulation::scales() const
{
  return impl_->scales;
}

const Triangles& Simulation::triangles() const
{
  return impl_->start_mesh.triangles;
}

const std::string& Simulation::notes() const
{
  return impl_->notes;
}

State Simulation::Impl::unsolved() const
{
  State state;
  state.points = start_mesh.points / scales.length;
  const auto shape = stepper.shape(state.points);
  state.target_area = shape->area;
  state.target_volume = shape->volume;
  return state;
}

State Simulation::instant() const
{
  State state = impl_->unsolved();
  impl_->stepper.solve(state); // over a step of 0
  return state;
}

State Simulation::start() const
{
  State state = impl_->unsolved();
  state.free_step = impl_->scene.time.step ? *impl_->scene.time.step / impl_->scales.time()
                                           : first_step / impl_->rate();
  impl_->plan_next_step(state);
  impl_->stepper.solve(state);
  return state;
}

State Simulation::step(const State& before) const
{
  const Impl& impl = *impl_;
  State from = before;
  if (impl.overshoots(from))
  {
    impl.plan_next_step(from);
    impl.stepper.solve(from);
  }
  std::string reason;
  for (int attempt = 0; attempt < max_attempts; ++attempt)
  {
    StepReport report;
    State after;
    try
    {
      after = impl.stepper.attempt(from, report);
      reason = reason_to_reject(report, impl.settings.limits);
    }
    catch (const NumericalError& error)
    {
      reason = error.what();
    }
    if (reason.empty())
    {
      const auto target = impl.next_target(before);
      const double left =
        target ? *target / impl.scales.time() - before.time / impl.scales.time() : INFINITY;
      const bool on_target = target && from.next_step == left;
      after.time = on_target ? *target : before.time + from.next_step * impl.scales.time();
      if (on_target && impl.scene.time.output_every > 0 &&
        *target == multiple(before.output, impl.scene.time.output_every))
        ++after.output;
      if (impl.settings.adaptive)
        after.free_step = wanted_step(from.next_step, from.free_step, report, impl.settings.limits);
      impl.plan_next_step(after);
      impl.stepper.solve(after);
      if (impl.settings.adaptive && impl.settings.integrator == Scene::Integrator::imex_euler)
      {
        // Known only now: the step after the next one follows it.
        report.error = impl.stepper.euler_error(from, after);
        after.free_step = wanted_step(from.next_step, from.free_step, report, impl.settings.limits);
      }
      return after;
    }
    if (!impl.settings.adaptive)
      throw NumericalError(fmt::format("t = {}: a step of {} can't be made: {}. Take a smaller "
                                       "time.step, or time.step = \"auto\".",
        before.time, from.next_step * impl.scales.time(), reason));
    ++from.rejected;
    from.free_step = from.next_step / 2;
    if (from.free_step < shortest_step / impl.rate())
      break;
    impl.plan_next_step(from);
    impl.stepper.solve(from);
  }
  throw NumericalError(fmt::format("t = {}: no step can be made, down to {:.1e}: {}. Try more "
                                   "triangles, or a milder flow, load or deflation.",
    before.time, from.next_step * impl.scales.time(), reason));
}

bool Simulation::finished(const State& state) const
{
  if (impl_->scene.time.end)
    return state.time >= *impl_->scene.time.end;
  return state.step > 0 && impl_->steady(state);
}

Diagnostics Simulation::diagnose(const State& state) const
{
  const Impl& impl = *impl_;
  const Scales& unit = impl.scales;
  const auto kept = impl.stepper.shape(state.points);
  const ShapeOperators& shape = *kept;
  const TriangleMesh mesh{ state.points, impl.start_mesh.triangles };
  const Eigen::VectorXd u = flat(state.velocity);
  const Vector3 U = shape.centroid_velocity * u;

  Diagnostics d;
  d.step = static_cast<double>(state.step);
  d.time = state.time;
  d.dt = state.last_step * unit.time();
  d.area = shape.area * unit.length * unit.length;
  d.volume = shape.volume * std::pow(unit.length, 3);
  d.area_drift = shape.area / state.target_area - 1;
  d.volume_drift = shape.volume / state.target_volume - 1;
  d.area_correction = state.area_correction;
  d.volume_correction = state.volume_correction;
  d.divergence = (shape.area_rate * impl.stepper.discretization().to_control(u))
                   .cwiseQuotient(shape.vertex_area)
                   .cwiseAbs()
                   .maxCoeff();
  d.reduced_volume = reduced_volume(shape.area, shape.volume);

  // Power of gravity on the membrane, and the imposed flow's work against all forces.
  const Discretization& operators = impl.stepper.discretization();
  const auto load_power = [&](const Eigen::VectorXd& v)
  { return impl.model.bond != 0 ? operators.load_power(shape, v) : 0; };
  const auto power = [&](const Eigen::VectorXd& v)
  { return operators.membrane_power(shape, state.bending, state.tension, v) + load_power(v); };
  const double against = impl.model.flow ? power(shape.ambient) : 0;
  d.power_in = (load_power(u) - against) * unit.power();
  d.dissipation = (power(u) - against) * unit.power();

  if (impl.model.bending)
    d.bending_energy = shape.bending_energy * unit.energy;
  d.energy_over_8pi = shape.bending_energy / (8 * std::numbers::pi);
  if (state.tension.size() > 0)
  {
    const Eigen::VectorXd tension = operators.at_vertices(state.tension) * unit.tension();
    d.tension_min = tension.minCoeff();
    d.tension_max = tension.maxCoeff();
  }
  for (int c = 0; c < 3; ++c)
  {
    d.centroid[c] = shape.center[c] * unit.length;
    d.velocity[c] = U[c] * unit.velocity();
  }
  impl.add_observables(state, shape, d);
  const MeshQuality quality = mesh_quality(mesh);
  d.min_angle_deg = quality.min_angle_deg;
  d.edge_ratio = quality.edge_ratio;
  d.iterations = static_cast<double>(state.iterations);
  d.rejected = static_cast<double>(state.rejected);
  return d;
}

double Simulation::time(const State& state) const
{
  return state.time;
}

Points Simulation::points(const State& state) const
{
  return state.points * impl_->scales.length;
}

Points Simulation::points_between(const State& before, const State& after, double time) const
{
  const double dt = (after.time - before.time) / impl_->scales.time();
  const double s = (time - before.time) / (after.time - before.time);
  const double s2 = s * s, s3 = s2 * s;
  return impl_->scales.length *
    ((2 * s3 - 3 * s2 + 1) * before.points + (s3 - 2 * s2 + s) * dt * before.node_velocity +
      (3 * s2 - 2 * s3) * after.points + (s3 - s2) * dt * after.node_velocity);
}

std::map<std::string, Eigen::MatrixXd> Simulation::fields(const State& state) const
{
  const Impl& impl = *impl_;
  const Scales& unit = impl.scales;
  const auto kept = impl.stepper.shape(state.points);
  const ShapeOperators& shape = *kept;
  const Discretization& operators = impl.stepper.discretization();
  std::map<std::string, Eigen::MatrixXd> fields;
  fields["Mean_Curvature"] = shape.curvature.mean * unit.curvature();
  fields["Gauss_Curvature"] = shape.curvature.gauss * std::pow(unit.curvature(), 2);
  fields["Laplacian_Mean_Curvature"] =
    shape.curvature.laplacian_mean * std::pow(unit.curvature(), 3);
  fields["Normals"] = shape.outward;
  fields["Velocity"] = state.velocity * unit.velocity();
  fields["Surface_Divergence"] = (shape.area_rate * operators.to_control(flat(state.velocity)))
                                   .cwiseQuotient(shape.vertex_area) /
    unit.time();

  Points membrane = Points::Zero(state.points.rows(), 3);
  if (impl.model.bending)
  {
    const Points force = rows_of_three(operators.bending_force(shape, state.bending));
    fields["Bending_Force"] = force * unit.force_density();
    membrane += force;
  }
  if (impl.model.incompressible)
  {
    const Points force = rows_of_three(operators.tension_force(shape, state.tension));
    fields["Tension"] = operators.at_vertices(state.tension) * unit.tension();
    fields["Tension_Force"] = force * unit.force_density();
    membrane += force;
  }
  fields["Membrane_Force"] = membrane * unit.force_density();
  if (impl.model.bond != 0)
    fields["Gravity_Force"] = rows_of_three(operators.load_force(shape)) * unit.force_density();
  return fields;
}

}
