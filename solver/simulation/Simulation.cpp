#include "solver/simulation/Simulation.h"

#include "solver/Errors.h"
#include "solver/Joined.h"
#include "solver/adaptation/AdaptedMesh.h"
#include "solver/adaptation/SettledShape.h"
#include "solver/dynamics/StepFailure.h"
#include "solver/simulation/Cost.h"
#include "solver/simulation/MeshAdaptation.h"
#include "solver/simulation/SceneOnMesh.h"
#include "solver/simulation/StartMesh.h"
#include "solver/simulation/SystemOfScene.h"
#include "solver/mesh/Preparation.h"
#include "solver/mesh/SelfCrossing.h"

#include <fmt/format.h>

namespace vesicle
{

namespace
{

/// The next finer rule of the single layer; of the finest the one before.
int other_quadrature(int points)
{
  return points == 1 ? 3 : points == 6 ? 12 : 6;
}

std::string start_name(const Scene& scene)
{
  return scene.vesicle.mesh_file ? scene.vesicle.mesh_file->string() : "start mesh";
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
  OutputSchedule schedule;
  std::optional<MeshAdaptation> adaptation;
  std::unique_ptr<SceneOnMesh> on_mesh; ///< of the mesh asked for last
  DimensionlessNumbers numbers;
  std::shared_ptr<const State> refused;

  Impl(const Scene& s, TriangleMesh mesh, const std::string& start_notes)
    : scene(s), notes(prepare_for_dynamics(mesh, start_name(s))), start_mesh(std::move(mesh)),
      scales(scales_of(s, start_mesh)), schedule(schedule_of(s)), on_mesh(on(start_mesh)),
      numbers(dimensionless_numbers(s, scales, on_mesh->evolution().system()))
  {
    if (s.accuracy.mesh_motion == Scene::MeshMotion::adaptive)
      adaptation.emplace(s, static_cast<int>(start_mesh.triangles.rows()));
    // What a shape's own notes say of its mesh isn't said twice.
    const bool told = !s.vesicle.mesh_file && !start_notes.empty();
    notes = lines({ told ? std::string() : check_smoothness(scene, start_mesh),
      check_units(numbers), start_notes, notes });
  }

  std::unique_ptr<SceneOnMesh> on(const TriangleMesh& mesh) const
  {
    return std::make_unique<SceneOnMesh>(
      scene, scales, mesh.triangles, static_cast<int>(mesh.points.rows()), start_points()[0]);
  }
  Evolution& start_evolution()
  {
    if (!same_triangles(on_mesh->triangles(), start_mesh.triangles))
      on_mesh = on(start_mesh);
    return on_mesh->evolution();
  }
  SceneOnMesh& at(const State& state)
  {
    const VesicleState& vesicle = state.vesicles[0];
    if (!same_triangles(on_mesh->triangles(), vesicle.triangles))
      on_mesh = on({ vesicle.points, vesicle.triangles });
    return *on_mesh;
  }
  Evolution& evolution(const State& state) { return at(state).evolution(); }
  std::shared_ptr<const SystemShape> shape(const State& state)
  {
    return evolution(state).stepper().shape(state);
  }

  std::vector<Points> start_points() const { return { start_mesh.points / scales.length }; }

  // None where no mesh fits better: as long as its mesh carries on, so does the run.
  std::optional<State> laid_anew(const State& state, int triangles, const MeshFitness& old)
  try
  {
    const auto before = shape(state);
    const VesicleShape& vesicle = before->vesicles[0];
    const AdaptedMesh mesh = adapted_mesh(*vesicle.surface, triangles);
    auto fresh = on(mesh.mesh);
    const Vesicle& there = fresh->evolution().system().vesicles[0];
    const SettledShape settled = settle_shape(*there.space, there.terms, mesh,
      { *vesicle.surface, vesicle.vesicle->terms, state.vesicles[0].target_area,
        state.vesicles[0].target_volume });
    const MeshFitness fitness = fresh->fitness(settled.points);
    if (!adaptation->better(fitness, old) ||
      find_self_crossing({ settled.points, mesh.mesh.triangles }))
      return {};
    State after = fresh->evolution().transferred(state, { settled.points });
    after.remeshing = { state.remeshing.count + 1, state.step, fitness.disagreement,
      state.remeshing.energy + settled.energy_change };
    on_mesh = std::move(fresh);
    return after;
  }
  catch (const NumericalError&)
  {
    return {};
  }
  catch (const InputError&) // of a mesh that can't carry the basis
  {
    return {};
  }

  State ready(const State& state)
  {
    if (!adaptation)
      return state;
    const MeshFitness fitness = at(state).fitness(state.vesicles[0].points);
    const std::vector<int> counts = adaptation->wanted_triangles(state, fitness);
    if (counts.empty())
      return state;
    for (const int triangles : counts)
      if (const std::optional<State> after = laid_anew(state, triangles, fitness))
        return *after;
    State tried = state;
    tried.remeshing.tried = state.step;
    return tried;
  }

  /// Velocities of a shape by another rule, nothing of a time step in them.
  Points velocities(const VesicleState& vesicle, int quadrature) const
  {
    Scene other = scene;
    other.accuracy.quadrature = quadrature;
    SceneOnMesh mesh(
      other, scales, vesicle.triangles, static_cast<int>(vesicle.points.rows()), start_points()[0]);
    return mesh.evolution().instant({ vesicle.points }).vesicles[0].velocity;
  }
  double layer_error(const State& state)
  {
    const VesicleState& vesicle = state.vesicles[0];
    const int points = scene.accuracy.quadrature;
    const Points velocity = evolution(state).instant({ vesicle.points }).vesicles[0].velocity,
                 other = velocities(vesicle, other_quadrature(points));
    const auto mean = [](const Points& v) { return std::sqrt(v.rowwise().squaredNorm().mean()); };
    const double speed = std::max(mean(other), evolution(state).system().rate());
    return speed > 0 ? mean(velocity - other) / speed : 0;
  }
  // A membrane whose energy is another than 2 ∮ H² dS can't be told from Loop's surface so.
  bool bends_plainly() const
  {
    return scene.membrane.bending_rigidity && scene.membrane.spontaneous_curvature == 0 &&
      !scene.membrane.area_difference_stiffness;
  }
  void estimate_energy(const State& state, ErrorEstimate& estimate)
  {
    const VesicleState& vesicle = state.vesicles[0];
    const auto points = static_cast<int>(vesicle.points.rows());
    const auto six = LoopEnergyRules(vesicle.triangles, points, 6).energy(vesicle.points);
    if (scene.accuracy.basis == Scene::Basis::loop)
    {
      estimate.energy = six.disagreement();
      estimate.energy_coarse = at(state).resolution().disagreement(vesicle.points);
    }
    else if (bends_plainly())
    {
      const auto flat = shape(state);
      const VesicleShape& own = flat->vesicles[0];
      estimate.energy = std::abs(own.vesicle->energy(*own.surface) / six.fine - 1);
    }
  }
  /// What projections took and what they left; of a membrane that may stretch the volume's alone.
  double projected(const State& state)
  {
    const VesicleState& vesicle = state.vesicles[0];
    const auto now = shape(state);
    const VesicleShape& there = now->vesicles[0];
    const double volume =
      vesicle.volume_correction + std::abs(there.surface->volume / vesicle.target_volume - 1);
    return !there.constraint
      ? volume
      : volume + vesicle.area_correction + std::abs(there.surface->area / vesicle.target_area - 1);
  }

  // Without bending a rough surface costs nothing, and flat triangles know no better.
  std::string unresolved(const State& state, double allowed)
  {
    if (!scene.membrane.bending_rigidity || scene.accuracy.basis == Scene::Basis::linear)
      return {};
    return at(state).resolution().complaint(state.vesicles[0].points, allowed);
  }
};

Simulation::Simulation(const Scene& scene, TriangleMesh start, const std::string& notes)
{
  if (scene.time.equilibrium)
    throw InputError(fmt::format("scene '{}' ends in an equilibrium, which isn't a run: vesicle "
                                 "equilibrium finds it, or set time.end to a time or \"steady\"",
      scene.name));
  const auto triangles = static_cast<int>(start.triangles.rows());
  require_memory(scene,
    scene.accuracy.mesh_motion == Scene::MeshMotion::adaptive
      ? MeshAdaptation(scene, triangles).most_triangles()
      : triangles);
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
  return impl_->schedule;
}

State Simulation::instant()
{
  return impl_->start_evolution().instant(impl_->start_points());
}

State Simulation::start()
{
  return impl_->start_evolution().start(impl_->start_points());
}

// All fields have as many rows as there are vertices, or none where they may.
static bool fits(const State& state, Eigen::Index vertices)
{
  const auto has = [&](const auto& field, bool may_be_empty)
  { return field.rows() == vertices || (may_be_empty && field.rows() == 0); };
  const VesicleState& v = state.vesicles.front();
  return has(state.preconditioner.points.front(), true) && has(v.points, false) &&
    has(v.velocity, false) && has(v.node_velocity, false) && has(v.tension, true) &&
    (has(v.stiff_force, true) || v.stiff_force.rows() == 3 * vertices);
}

// A mesh that dynamics take.
static void require_whole(TriangleMesh mesh)
{
  const std::string name = "the mesh of the state to go on from";
  if (mesh.triangles.size() == 0 || mesh.triangles.minCoeff() < 0 ||
    mesh.triangles.maxCoeff() >= mesh.points.rows())
    throw InputError(name + ": its triangles have corners that don't exist");
  prepare_for_dynamics(mesh, name);
}

void Simulation::require_own(const State& state) const
{
  const TriangleMesh& start = impl_->start_mesh;
  const bool one = state.vesicles.size() == 1 && state.preconditioner.points.size() == 1,
             anew = one && impl_->adaptation && state.remeshing.count > 0;
  if (!one || !fits(state, anew ? state.vesicles[0].points.rows() : start.points.rows()) ||
    (!anew && !same_triangles(state.vesicles[0].triangles, start.triangles)))
  {
    throw InputError(fmt::format("{}: has {} vertices: it is not the mesh of the state to go on "
                                 "from; bring the old mesh back or start anew",
      start_name(scene()), start.points.rows()));
  }
  if (anew)
    require_whole({ state.vesicles[0].points, state.vesicles[0].triangles });
}

State Simulation::ready(const State& state)
{
  return impl_->ready(state);
}

State Simulation::step(const State& before)
{
  const State state = ready(before);
  const auto stepped = [&]
  {
    try
    {
      return impl_->evolution(state).step(state);
    }
    catch (const StepFailure& error)
    {
      impl_->refused = error.attempted;
      throw NumericalError(lines({ error.what(), unresolved_warning(state) }));
    }
  };
  impl_->refused.reset();
  State after = stepped();
  // What an adaptive mesh can't hold it loses within a step.
  if (!schedule().due(after) && !impl_->adaptation)
    return after;
  try
  {
    require_no_crossing({ after.vesicles[0].points, after.vesicles[0].triangles }, after.time);
    if (const std::string complaint = impl_->unresolved(after, lost); !complaint.empty())
      throw NumericalError(fmt::format("t = {}: {}.", after.time, complaint));
  }
  catch (const NumericalError&)
  {
    impl_->refused = std::make_shared<const State>(std::move(after));
    throw;
  }
  return after;
}

const State* Simulation::refused() const
{
  return impl_->refused.get();
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
  return state.step > 0 && impl_->evolution(state).steady(state);
}

Diagnostics Simulation::diagnose(const State& state)
{
  return impl_->at(state).report().diagnose(state, *impl_->shape(state), 0);
}

ErrorEstimate Simulation::error_estimate(const State& state)
{
  ErrorEstimate estimate;
  if (impl_->scene.membrane.bending_rigidity)
    impl_->estimate_energy(state, estimate);
  estimate.layer = impl_->layer_error(state);
  estimate.time = impl_->projected(state);
  return estimate;
}

std::map<std::string, Eigen::MatrixXd> Simulation::fields(const State& state)
{
  auto fields = impl_->at(state).report().fields(state, *impl_->shape(state), 0);
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

TriangleMesh Simulation::mesh(const State& state) const
{
  return { points(state), state.vesicles[0].triangles };
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
