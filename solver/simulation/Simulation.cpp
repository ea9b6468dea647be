#include "solver/simulation/Simulation.h"

#include "solver/Errors.h"
#include "solver/Joined.h"
#include "solver/ParallelFor.h"
#include "solver/adaptation/AdaptedMesh.h"
#include "solver/adaptation/SettledShape.h"
#include "solver/dynamics/StepFailure.h"
#include "solver/simulation/Cost.h"
#include "solver/simulation/MeshAdaptation.h"
#include "solver/simulation/SceneOnMesh.h"
#include "solver/simulation/StartMesh.h"
#include "solver/simulation/StartOverlap.h"
#include "solver/simulation/SystemOfScene.h"
#include "solver/simulation/WallFit.h"
#include "solver/mesh/JoinedMesh.h"
#include "solver/mesh/Preparation.h"
#include "solver/mesh/SelfCrossing.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

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

std::string vesicle_name(std::size_t number)
{
  return fmt::format("vesicle {}", number);
}

/// What is said of each of several vesicles: equal texts once, for those that they are of.
std::string told_of_vesicles(const std::vector<std::string>& texts)
{
  if (texts.size() == 1)
    return texts.front();
  std::vector<std::string> told;
  for (std::size_t v = 0; v < texts.size(); ++v)
  {
    if (texts[v].empty() ||
      std::find(texts.begin(), texts.begin() + v, texts[v]) < texts.begin() + v)
      continue;
    const auto same = std::count(texts.begin() + v, texts.end(), texts[v]);
    const std::string more = same > 1 ? fmt::format(" and {} more", same - 1) : "";
    told.push_back(fmt::format("{}{}: {}", vesicle_name(v), more, texts[v]));
  }
  return joined(told, "\n");
}

std::vector<TriangleMesh> meshes_of(const State& state)
{
  std::vector<TriangleMesh> meshes;
  for (const VesicleState& vesicle : state.vesicles)
    meshes.push_back({ vesicle.points, vesicle.triangles });
  return meshes;
}

// Nothing in the equations keeps a membrane from passing through itself or another, and what follows
// means nothing. Seen from output time to output time, it costs nothing beside the steps.
void require_no_crossing(const State& state)
{
  const std::vector<TriangleMesh> meshes = meshes_of(state);
  const auto crossing = find_self_crossing(joined(meshes));
  if (!crossing)
    return;
  const std::size_t a = mesh_of_triangle(meshes, crossing->first),
                    b = mesh_of_triangle(meshes, crossing->second);
  const std::string what = a != b
    ? fmt::format("vesicles {} and {} pass through each other near ({:.6g}, {:.6g}, {:.6g})", a, b,
        crossing->place.x(), crossing->place.y(), crossing->place.z())
    : fmt::format("{} passes through itself, {}",
        meshes.size() > 1 ? "the membrane of " + vesicle_name(a) : "the membrane",
        to_text(*crossing));
  throw NumericalError(fmt::format(
    "t = {}: {} in units of r0. Take more triangles, or a milder flow, load or deflation.",
    state.time, what));
}

void require_apart(const Scene& scene, const std::vector<TriangleMesh>& start)
{
  if (const auto overlap = find_overlap(start))
    throw InputError(fmt::format("{}{}: take other centers, or let vesicle fill place them",
      scene.file.empty() ? "" : scene.file.string() + ": ", to_text(*overlap)));
}

void require_as_many(const Scene& scene, std::size_t meshes)
{
  if (meshes != scene.vesicles())
    throw InputError(fmt::format("the scene has {} vesicle{}, and there are {} start meshes",
      scene.vesicles(), scene.vesicles() == 1 ? "" : "s", meshes));
}

// What a scene that wasn't read from a file may ask for all the same.
void require_several_supported(const Scene& scene)
{
  if (scene.vesicles() > 1 &&
    (scene.accuracy.mesh_motion == Scene::MeshMotion::adaptive ||
      scene.accuracy.basis != Scene::Basis::loop))
    throw InputError("several vesicles take Loop's surface (accuracy.preset = \"balanced\" or "
                     "\"accurate\") and another mesh_motion than \"adaptive\"");
}

// Of the bending energy: below the first a shape is resolved (a pear of 320 triangles at Bo = 200,
// .2%), beyond the second it is another one.
constexpr double resolved = 0.01, lost = 0.1;

}

struct Simulation::Impl
{
  Scene scene;
  std::vector<std::string> prepared;      ///< what was changed in each start mesh
  std::vector<TriangleMesh> start_meshes; ///< in the scene's units
  std::vector<Points> references; ///< vertices of those that were read; other's without rows
  TriangleMesh start_mesh;        ///< all of them
  Scales scales;
  OutputSchedule schedule;
  std::optional<MeshAdaptation> adaptation;
  std::unique_ptr<SceneOnMesh> on_mesh; ///< of the mesh asked for last, if it is needed
  DimensionlessNumbers numbers;
  std::string notes;
  std::shared_ptr<const State> refused;

  Impl(const Scene& s, const std::vector<StartMesh>& start)
    : scene(s), prepared(start.size()), start_meshes(taken(s, start)),
      references(references_of(s, start)), start_mesh(joined(start_meshes)),
      scales(scales_of(s, start_meshes[0])), schedule(schedule_of(s)), on_mesh(on(start_meshes)),
      numbers(dimensionless_numbers(s, scales, on_mesh->evolution().system()))
  {
    if (s.accuracy.mesh_motion == Scene::MeshMotion::adaptive)
      adaptation.emplace(s, static_cast<int>(start_mesh.triangles.rows()));
    std::vector<std::string> rough(start.size()), said(start.size());
    for (std::size_t v = 0; v < start.size(); ++v)
    {
      // What a shape's own notes say of its mesh isn't said twice.
      const bool told = !s.alone(v).vesicle.mesh_file && !start[v].notes.empty();
      if (!told)
        rough[v] = check_smoothness(scene, start_meshes[v]);
      said[v] = start[v].notes;
    }
    std::erase(prepared, "");
    notes = lines({ told_of_vesicles(rough), check_units(numbers), told_of_vesicles(said),
      joined(prepared, "\n") });
  }

  /// Fit for dynamics, and apart from each other.
  std::vector<TriangleMesh> taken(const Scene& s, const std::vector<StartMesh>& start)
  {
    std::vector<TriangleMesh> meshes;
    for (std::size_t v = 0; v < start.size(); ++v)
    {
      const std::string name = start_name(s.alone(v));
      meshes.push_back(start[v].mesh);
      prepared[v] = prepare_for_dynamics(
        meshes[v], start.size() > 1 ? fmt::format("{}: {}", vesicle_name(v), name) : name);
    }
    require_apart(s, meshes);
    require_fit_for_wall(s, meshes);
    return meshes;
  }

  /// With the points and triangles of the start, in their order.
  std::vector<Points> references_of(const Scene& s, const std::vector<StartMesh>& start) const
  {
    std::vector<Points> references(start.size());
    for (std::size_t v = 0; v < start.size(); ++v)
    {
      const Scene::Membrane membrane = s.alone(v).membrane;
      if (membrane.reference != Scene::Membrane::Reference::file)
        continue;
      const std::string name = membrane.reference_file->string();
      if (!start[v].reference)
        throw InputError(name +
          ": the mesh that membrane.reference names wasn't handed on with the "
          "start mesh");
      TriangleMesh mesh = *start[v].reference;
      prepare_for_dynamics(mesh, name);
      if (mesh.points.rows() != start_meshes[v].points.rows() ||
        !same_triangles(mesh.triangles, start_meshes[v].triangles))
        throw InputError(fmt::format("{}: membrane.reference takes a mesh with the start's points "
                                     "and triangles in their order, "
                                     "{} and {}; it has {} and {}{}",
          name, start_meshes[v].points.rows(), start_meshes[v].triangles.rows(), mesh.points.rows(),
          mesh.triangles.rows(),
          mesh.triangles.rows() == start_meshes[v].triangles.rows() ? ", but others" : ""));
      references[v] = std::move(mesh.points);
    }
    return references;
  }

  Points scaled_reference(std::size_t v) const { return references[v] / scales.length; }

  /// Elastic membranes keep the start's shape in mind, whatever they are.
  VesicleMesh vesicle_mesh(std::size_t v, const TriangleMesh& mesh) const
  {
    return { mesh.triangles, static_cast<int>(mesh.points.rows()),
      start_meshes[v].points / scales.length, scaled_reference(v) };
  }
  std::unique_ptr<SceneOnMesh> on(const std::vector<TriangleMesh>& meshes) const
  {
    std::vector<VesicleMesh> vesicles;
    for (std::size_t v = 0; v < meshes.size(); ++v)
      vesicles.push_back(vesicle_mesh(v, meshes[v]));
    return std::make_unique<SceneOnMesh>(scene, scales, std::move(vesicles));
  }
  Evolution& start_evolution()
  {
    return at(start_meshes[0].triangles, [&] { return start_meshes; }).evolution();
  }
  SceneOnMesh& at(const Triangles& first, const std::function<std::vector<TriangleMesh>()>& meshes)
  {
    if (!on_mesh || (adaptation && !same_triangles(on_mesh->triangles(0), first)))
      on_mesh = on(meshes());
    return *on_mesh;
  }
  SceneOnMesh& at(const State& state)
  {
    return at(state.vesicles[0].triangles, [&] { return meshes_of(state); });
  }
  Evolution& evolution(const State& state) { return at(state).evolution(); }
  std::shared_ptr<const SystemShape> shape(const State& state)
  {
    return evolution(state).stepper().shape(state);
  }
  std::size_t vesicles() const { return start_meshes.size(); }

  std::vector<Points> start_points() const
  {
    std::vector<Points> points;
    for (const TriangleMesh& mesh : start_meshes)
      points.emplace_back(mesh.points / scales.length);
    return points;
  }

  // None where no mesh fits better: as long as its mesh carries on, so does the run.
  std::optional<State> laid_anew(const State& state, int triangles, const MeshFitness& old)
  try
  {
    const auto before = shape(state);
    const VesicleShape& vesicle = before->vesicles[0];
    const AdaptedMesh mesh = adapted_mesh(*vesicle.surface, triangles);
    auto fresh = on({ mesh.mesh });
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

  static std::vector<Points> points_of(const State& state)
  {
    std::vector<Points> points;
    for (const VesicleState& vesicle : state.vesicles)
      points.push_back(vesicle.points);
    return points;
  }
  /// Velocities of a shape by another rule, nothing of a time step in them.
  State by_rule(const State& state, int quadrature) const
  {
    Scene other = scene;
    other.accuracy.quadrature = quadrature;
    std::vector<VesicleMesh> meshes;
    for (std::size_t v = 0; v < vesicles(); ++v)
      meshes.push_back(vesicle_mesh(v, { state.vesicles[v].points, state.vesicles[v].triangles }));
    return SceneOnMesh(other, scales, std::move(meshes)).evolution().instant(points_of(state));
  }
  // What the steps need is given up before as much is made of the other rule.
  double layer_error(const State& state)
  {
    const double rate = evolution(state).system().rate();
    const State own = evolution(state).instant(points_of(state));
    on_mesh.reset();
    const State other = by_rule(state, other_quadrature(scene.accuracy.quadrature));
    double change = 0, squared = 0, count = 0;
    for (std::size_t v = 0; v < vesicles(); ++v)
    {
      const Points &velocity = own.vesicles[v].velocity, &there = other.vesicles[v].velocity;
      change += (velocity - there).rowwise().squaredNorm().sum();
      squared += there.rowwise().squaredNorm().sum();
      count += static_cast<double>(there.rows());
    }
    const double speed = std::max(std::sqrt(squared / count), rate);
    return speed > 0 ? std::sqrt(change / count) / speed : 0;
  }
  // A membrane whose energy is another than 2 ∮ H² dS can't be told from Loop's surface so.
  bool bends_plainly() const
  {
    return scene.membrane.bending_rigidity && scene.membrane.spontaneous_curvature == 0 &&
      !scene.membrane.area_difference_stiffness;
  }
  bool bends(std::size_t v) const
  {
    return (v == 0 ? scene.membrane : scene.companions[v - 1].membrane)
      .bending_rigidity.has_value();
  }
  /// The worst vesicle's.
  void estimate_energy(const State& state, ErrorEstimate& estimate)
  {
    for (std::size_t v = 0; v < vesicles(); ++v)
      if (bends(v))
        estimate_energy(state, v, estimate);
  }
  void estimate_energy(const State& state, std::size_t v, ErrorEstimate& estimate)
  {
    const VesicleState& vesicle = state.vesicles[v];
    const auto points = static_cast<int>(vesicle.points.rows());
    const auto six = LoopEnergyRules(vesicle.triangles, points, 6).energy(vesicle.points);
    if (scene.accuracy.basis == Scene::Basis::loop)
    {
      estimate.energy = std::max(estimate.energy.value_or(0), six.disagreement());
      estimate.energy_coarse = std::max(
        estimate.energy_coarse.value_or(0), at(state).resolution(v).disagreement(vesicle.points));
    }
    else if (bends_plainly())
    {
      const auto flat = shape(state);
      const VesicleShape& own = flat->vesicles[v];
      estimate.energy = std::abs(own.vesicle->energy(*own.surface) / six.fine - 1);
    }
  }
  /// What projections took and what they left; of a membrane that may stretch the volume's alone.
  /// The worst vesicle's.
  double projected(const State& state)
  {
    const auto now = shape(state);
    double worst = 0;
    for (std::size_t v = 0; v < vesicles(); ++v)
    {
      const VesicleState& vesicle = state.vesicles[v];
      const VesicleShape& there = now->vesicles[v];
      const double volume =
        vesicle.volume_correction + std::abs(there.surface->volume / vesicle.target_volume - 1);
      worst = std::max(worst,
        !there.constraint ? volume
                          : volume + vesicle.area_correction +
            std::abs(there.surface->area / vesicle.target_area - 1));
    }
    return worst;
  }

  // Without bending a rough surface costs nothing, and flat triangles know no better.
  std::string unresolved(const State& state, double allowed)
  {
    if (scene.accuracy.basis == Scene::Basis::linear)
      return {};
    for (std::size_t v = 0; v < vesicles(); ++v)
      if (bends(v))
        if (const std::string complaint =
              at(state).resolution(v).complaint(state.vesicles[v].points, allowed);
            !complaint.empty())
          return vesicles() > 1 ? fmt::format("{}: {}", vesicle_name(v), complaint) : complaint;
    return {};
  }

  /// E/8πEB is told by each vesicle's own rigidity; the row's unit is the first one's.
  Diagnostics diagnose(const State& state, const SystemShape& shape, std::size_t v)
  {
    Diagnostics d = at(state).report().diagnose(state, shape, v);
    if (v > 0 && bends(v))
      d.energy_over_8pi *= scales.energy / *scene.companions[v - 1].membrane.bending_rigidity;
    return d;
  }
};

Simulation::Simulation(const Scene& scene, TriangleMesh start, const std::string& notes)
  : Simulation(scene, std::vector<StartMesh>{ { std::move(start), notes } })
{
}

Simulation::Simulation(const Scene& scene, const std::vector<StartMesh>& start)
{
  if (scene.time.equilibrium)
    throw InputError(fmt::format("scene '{}' ends in an equilibrium, which isn't a run: vesicle "
                                 "equilibrium finds it, or set time.end to a time or \"steady\"",
      scene.name));
  require_as_many(scene, start.size());
  require_several_supported(scene);
  Eigen::Index triangles = 0;
  for (const StartMesh& mesh : start)
    triangles += mesh.mesh.triangles.rows();
  require_memory(scene,
    scene.accuracy.mesh_motion == Scene::MeshMotion::adaptive
      ? MeshAdaptation(scene, static_cast<int>(triangles)).most_triangles()
      : static_cast<double>(triangles));
  impl_ = std::make_unique<Impl>(scene, start);
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

std::size_t Simulation::vesicles() const
{
  return impl_->vesicles();
}

std::vector<Triangles> Simulation::start_triangles() const
{
  std::vector<Triangles> triangles;
  for (const TriangleMesh& mesh : impl_->start_meshes)
    triangles.push_back(mesh.triangles);
  return triangles;
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
static bool fits(const State& state, std::size_t vesicle, Eigen::Index vertices)
{
  const auto has = [&](const auto& field, bool may_be_empty)
  { return field.rows() == vertices || (may_be_empty && field.rows() == 0); };
  const VesicleState& v = state.vesicles[vesicle];
  return has(state.preconditioner.points[vesicle], true) && has(v.points, false) &&
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
  const std::size_t count = vesicles();
  if (state.vesicles.size() != count || state.preconditioner.points.size() != count)
    throw InputError(fmt::format("the scene has {} vesicles and the state to go on from {}: bring "
                                 "the old scene back or start anew",
      count, state.vesicles.size()));
  for (std::size_t v = 0; v < count; ++v)
  {
    const TriangleMesh& start = impl_->start_meshes[v];
    const VesicleState& own = state.vesicles[v];
    const bool anew = impl_->adaptation && state.remeshing.count > 0;
    if (!fits(state, v, anew ? own.points.rows() : start.points.rows()) ||
      (!anew && !same_triangles(own.triangles, start.triangles)))
    {
      throw InputError(fmt::format("{}: has {} vertices: it is not the mesh of the state to go on "
                                   "from; bring the old mesh back or start anew",
        start_name(scene().alone(v)), start.points.rows()));
    }
    if (anew)
      require_whole({ own.points, own.triangles });
  }
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
    require_no_crossing(after);
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

Diagnostics Simulation::diagnose(const State& state, std::size_t vesicle)
{
  return impl_->diagnose(state, *impl_->shape(state), vesicle);
}

// Looked for within this, in r0.
static constexpr double told_gap = 1;

std::vector<Diagnostics> Simulation::diagnose_all(const State& state)
{
  const auto shape = impl_->shape(state);
  std::vector<Diagnostics> all(vesicles());
  parallel_for(vesicles(), [&](std::size_t v) { all[v] = impl_->diagnose(state, *shape, v); });
  if (vesicles() > 1)
  {
    const std::vector<double> gaps = distances(Proximity(sides(*shape), told_gap));
    for (std::size_t v = 0; v < vesicles(); ++v)
      if (std::isfinite(gaps[v]))
        all[v].gap = gaps[v] * scales().length;
  }
  return all;
}

ErrorEstimate Simulation::error_estimate(const State& state)
{
  ErrorEstimate estimate;
  impl_->estimate_energy(state, estimate);
  estimate.time = impl_->projected(state);
  estimate.layer = impl_->layer_error(state);
  return estimate;
}

using Fields = std::map<std::string, Eigen::MatrixXd>;

// One vesicle's after the other's; of what a vesicle doesn't have it has 0.
static Fields joined_fields(std::vector<Fields> of, const std::vector<VesicleState>& vesicles)
{
  if (of.size() == 1)
    return std::move(of.front());
  Eigen::Index rows = 0;
  for (const VesicleState& vesicle : vesicles)
    rows += vesicle.points.rows();
  Fields all;
  for (const Fields& fields : of)
    for (const auto& [name, values] : fields)
      all.try_emplace(name, Eigen::MatrixXd::Zero(rows, values.cols()));
  Eigen::Index first = 0;
  for (std::size_t v = 0; v < of.size(); ++v)
  {
    for (const auto& [name, values] : of[v])
      all[name].middleRows(first, values.rows()) = values;
    first += vesicles[v].points.rows();
  }
  return all;
}

std::map<std::string, Eigen::MatrixXd> Simulation::fields(const State& state)
{
  const auto shape = impl_->shape(state);
  const StateReport& report = impl_->at(state).report();
  std::vector<Fields> of(vesicles());
  parallel_for(vesicles(), [&](std::size_t v) { of[v] = report.fields(state, *shape, v); });
  Fields fields = joined_fields(std::move(of), state.vesicles);
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

std::vector<int> Simulation::vesicle_ids(const State& state) const
{
  std::vector<int> ids;
  for (std::size_t v = 0; v < state.vesicles.size(); ++v)
    ids.insert(ids.end(), state.vesicles[v].points.rows(), static_cast<int>(v));
  return ids;
}

Points Simulation::points(const State& state) const
{
  return mesh(state).points;
}

TriangleMesh Simulation::mesh(const State& state) const
{
  TriangleMesh mesh = joined(meshes_of(state));
  mesh.points *= impl_->scales.length;
  return mesh;
}

Points Simulation::points_between(const State& before, const State& after, double time) const
{
  const double dt = (after.time - before.time) / impl_->scales.time();
  const double s = (time - before.time) / (after.time - before.time);
  const double s2 = s * s, s3 = s2 * s;
  TriangleMesh mesh = joined(meshes_of(before));
  Eigen::Index first = 0;
  for (std::size_t v = 0; v < before.vesicles.size(); ++v)
  {
    const VesicleState &a = before.vesicles[v], &b = after.vesicles[v];
    mesh.points.middleRows(first, a.points.rows()) = impl_->scales.length *
      ((2 * s3 - 3 * s2 + 1) * a.points + (s3 - 2 * s2 + s) * dt * a.node_velocity +
        (3 * s2 - 2 * s3) * b.points + (s3 - s2) * dt * b.node_velocity);
    first += a.points.rows();
  }
  return mesh.points;
}

}
