#include "solver/simulation/Simulation.h"

#include "solver/Errors.h"
#include "solver/Joined.h"
#include "solver/dynamics/Evolution.h"
#include "solver/dynamics/StateReport.h"
#include "solver/mesh/MeshInspection.h"
#include "solver/simulation/Cost.h"
#include "solver/simulation/Resolution.h"
#include "solver/simulation/StartMesh.h"
#include "solver/simulation/SystemOfScene.h"
#include "solver/mesh/Preparation.h"
#include "solver/mesh/SelfCrossing.h"

#include <fmt/format.h>

namespace vesicle
{

namespace
{

std::string start_name(const Scene& scene)
{
  return scene.vesicle.mesh_file ? scene.vesicle.mesh_file->string() : "start mesh";
}

std::optional<double> fixed_step(const Scene& scene, const Scales& scales)
{
  if (scene.time.step)
    return *scene.time.step / scales.time();
  return {};
}

// Nothing in the equations keeps a membrane from passing through itself, and what follows means
// nothing. Seen from output time to output time, it costs nothing beside the steps.
void require_no_crossing(const TriangleMesh& mesh, double time)
{
  if (const auto crossing = find_self_crossing(mesh))
    throw NumericalError(
      fmt::format("t = {}: the membrane passes through itself, {} in units of r0. Take more "
                  "triangles, or a milder flow, load or deflation.",
        time, to_text(*crossing)));
}

// Of the bending energy: below the first a shape is resolved (a pear of 320 triangles at Bo = 200,
// .2%), beyond the second it is another one.
constexpr double resolved = 0.01, lost = 0.1;

}

struct Simulation::Impl
{
  Scene scene;
  std::string notes;
  TriangleMesh start_mesh; ///< in the scene's units
  Scales scales;
  Evolution evolution;
  StateReport report;
  DimensionlessNumbers numbers;
  std::optional<Resolution> resolution; ///< made when it is first asked for

  Impl(const Scene& s, TriangleMesh mesh, const std::string& start_notes)
    : scene(s), notes(prepare_for_dynamics(mesh, start_name(s))), start_mesh(std::move(mesh)),
      scales(scales_of(s, start_mesh)),
      evolution(system_of(s, scales, start_mesh), stepper_settings_of(s), schedule_of(s),
        scales.time(), fixed_step(s, scales)),
      report(evolution.system(), scales),
      numbers(dimensionless_numbers(s, scales, evolution.system()))
  {
    // What a shape's own notes say of its mesh isn't said twice.
    const bool told = !s.vesicle.mesh_file && !start_notes.empty();
    notes = lines({ told ? std::string() : check_smoothness(scene, start_mesh),
      check_units(numbers), start_notes, notes });
  }

  std::vector<Points> start_points() const { return { start_mesh.points / scales.length }; }

  // Without bending a rough surface costs nothing, and flat triangles know no better.
  std::string unresolved(const State& state, double allowed)
  {
    if (!scene.membrane.bending_rigidity || scene.accuracy.basis == Scene::Basis::linear)
      return {};
    const Points& points = state.vesicles[0].points;
    if (!resolution)
      resolution.emplace(start_mesh.triangles, static_cast<int>(points.rows()));
    return resolution->complaint(points, allowed);
  }
};

Simulation::Simulation(const Scene& scene, TriangleMesh start, const std::string& notes)
{
  if (scene.time.equilibrium)
    throw InputError(fmt::format("scene '{}' ends in an equilibrium, which isn't a run: vesicle "
                                 "equilibrium finds it, or set time.end to a time or \"steady\"",
      scene.name));
  require_memory(scene, static_cast<double>(start.triangles.rows()));
  impl_ = std::make_unique<Impl>(scene, std::move(start), notes);
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

const TriangleMesh& Simulation::start_mesh() const
{
  return impl_->start_mesh;
}

const Triangles& Simulation::triangles() const
{
  return impl_->start_mesh.triangles;
}

const std::string& Simulation::notes() const
{
  return impl_->notes;
}

const DimensionlessNumbers& Simulation::numbers() const
{
  return impl_->numbers;
}

const OutputSchedule& Simulation::schedule() const
{
  return impl_->evolution.schedule();
}

State Simulation::instant()
{
  return impl_->evolution.instant(impl_->start_points());
}

State Simulation::start()
{
  return impl_->evolution.start(impl_->start_points());
}

void Simulation::require_own(const State& state) const
{
  const Eigen::Index vertices = impl_->start_mesh.points.rows();
  const auto fits = [&](const auto& field, bool may_be_empty)
  { return field.rows() == vertices || (may_be_empty && field.rows() == 0); };
  bool own = state.vesicles.size() == 1 && state.preconditioner.points.size() == 1 &&
    fits(state.preconditioner.points.front(), true);
  for (const VesicleState& v : state.vesicles)
  {
    own = own && fits(v.points, false) && fits(v.velocity, false) && fits(v.node_velocity, false) &&
      fits(v.tension, true) && (fits(v.stiff_force, true) || v.stiff_force.rows() == 3 * vertices);
  }
  if (!own)
  {
    throw InputError(fmt::format("{}: has {} vertices: it is not the mesh of the state to go on "
                                 "from; bring the old mesh back or start anew",
      start_name(scene()), vertices));
  }
}

State Simulation::step(const State& state)
{
  const auto stepped = [&]
  {
    try
    {
      return impl_->evolution.step(state);
    }
    catch (const NumericalError& error)
    {
      throw NumericalError(lines({ error.what(), unresolved_warning(state) }));
    }
  };
  State after = stepped();
  if (!schedule().due(after))
    return after;
  require_no_crossing({ after.vesicles[0].points, triangles() }, after.time);
  if (const std::string complaint = impl_->unresolved(after, lost); !complaint.empty())
    throw NumericalError(fmt::format("t = {}: {}.", after.time, complaint));
  return after;
}

std::string Simulation::unresolved_warning(const State& state)
{
  const std::string complaint = impl_->unresolved(state, resolved);
  return complaint.empty() ? complaint : complaint + ".";
}

bool Simulation::finished(const State& state)
{
  if (impl_->scene.time.end)
    return state.time >= *impl_->scene.time.end;
  return state.step > 0 && impl_->evolution.steady(state);
}

Diagnostics Simulation::diagnose(const State& state)
{
  return impl_->report.diagnose(state, *impl_->evolution.stepper().shape(state), 0);
}

std::map<std::string, Eigen::MatrixXd> Simulation::fields(const State& state)
{
  auto fields = impl_->report.fields(state, *impl_->evolution.stepper().shape(state), 0);
  for (const auto& [name, values] : fields)
    if (!values.allFinite())
      throw NumericalError(
        fmt::format("{} isn't finite at t = {:.6g}: sizes, rigidity, viscosity or "
                    "flow are beyond what can be computed with; check their units",
          name, state.time));
  return fields;
}

double Simulation::time(const State& state) const
{
  return state.time;
}

Points Simulation::points(const State& state) const
{
  return state.vesicles[0].points * impl_->scales.length;
}

Points Simulation::points_between(const State& before, const State& after, double time) const
{
  const double dt = (after.time - before.time) / impl_->scales.time();
  const double s = (time - before.time) / (after.time - before.time);
  const double s2 = s * s, s3 = s2 * s;
  const VesicleState &a = before.vesicles[0], &b = after.vesicles[0];
  return impl_->scales.length *
    ((2 * s3 - 3 * s2 + 1) * a.points + (s3 - 2 * s2 + s) * dt * a.node_velocity +
      (3 * s2 - 2 * s3) * b.points + (s3 - s2) * dt * b.node_velocity);
}

}
