#include "solver/dynamics/StateReport.h"

#include "solver/dynamics/InnerFlow.h"
#include "solver/dynamics/Observables.h"
#include "solver/dynamics/WallGap.h"
#include "solver/mesh/MeshQuality.h"
#include "solver/mesh/MeshIntegrals.h"

#include <cmath>
#include <map>
#include <numbers>

namespace vesicle
{

namespace
{

/// The forces of each term as the dynamics used them: what the stiff ones changed within a step is
/// the first one's.
std::vector<NodalForce> forces_used(const VesicleShape& shape, const VesicleState& state)
{
  std::vector<NodalForce> forces = shape.forces;
  if (state.stiff_force.size() > 0)
    for (std::size_t t = 0; t < forces.size(); ++t)
      if (shape.vesicle->terms[t]->stiff())
      {
        (shape.loads ? forces[t].vector : forces[t].normal) +=
          state.stiff_force - shape.stiff_force;
        break;
      }
  return forces;
}

/// What the constraints add to the tension: what the discrete pressure has beyond a uniform one, and
/// what holds a taut sphere. Smooth surfaces only.
NodalForce constraint_force(const VesicleShape& shape, const VesicleState& state)
{
  if (!shape.loads)
    return {};
  Eigen::VectorXd load = shape.loads->pressure_load(state.pressure);
  if (shape.loads->taut())
    load += shape.loads->taut_load(flat(state.velocity));
  return { {}, shape.loads->density(load) };
}

/// Of the membrane's own viscosity; no parts: none.
NodalForce viscous_force(const VesicleShape& shape, const VesicleState& state)
{
  if (!shape.loads || !shape.loads->viscous())
    return {};
  return { {},
    shape.loads->density(
      shape.loads->viscous_load(shape.surface->to_control(flat(state.velocity)))) };
}

template<class Selects>
NodalForce sum_of(const std::vector<NodalForce>& forces, const VesicleShape& shape, Selects selects)
{
  NodalForce sum;
  for (std::size_t t = 0; t < forces.size(); ++t)
    if (selects(*shape.vesicle->terms[t]))
      sum += forces[t];
  return sum;
}

bool external(const MembraneTerm& term)
{
  return term.external();
}

bool own(const MembraneTerm& term)
{
  return !term.external();
}

/// All that the membrane itself exerts on the fluids; `forces`: of its terms.
NodalForce membrane_force(
  const std::vector<NodalForce>& forces, const VesicleShape& shape, const VesicleState& state)
{
  NodalForce sum = sum_of(forces, shape, own);
  sum += constraint_force(shape, state);
  sum += viscous_force(shape, state);
  return sum;
}

bool empty(const NodalForce& force)
{
  return force.normal.size() == 0 && force.vector.size() == 0;
}

double power(const VesicleShape& shape, const NodalForce& force, const Eigen::VectorXd& velocity)
{
  return empty(force) ? 0 : shape.basis().power(force, velocity);
}

}

StateReport::StateReport(const System& system, const Scales& scales, const LayerSettings& layer)
  : system_(system), scales_(scales), layer_(layer)
{
  std::map<const SurfaceSpace*, std::shared_ptr<const FlatPieces>> of_space;
  for (const Vesicle& vesicle : system.vesicles)
  {
    auto& pieces = of_space[vesicle.space.get()];
    if (!pieces)
      pieces = std::make_shared<const FlatPieces>(*vesicle.space);
    pieces_.push_back(pieces);
  }
}

Diagnostics StateReport::diagnose(
  const State& state, const SystemShape& system, std::size_t number) const
{
  const VesicleShape& shape = system.vesicles[number];
  const VesicleState& vesicle = state.vesicles[number];
  Diagnostics d;
  d.step = static_cast<double>(state.step);
  d.time = state.time;
  d.dt = state.controller.last_step * scales_.time();
  d.area_drift = shape.surface->area / vesicle.target_area - 1;
  d.volume_drift = shape.surface->volume / vesicle.target_volume - 1;
  d.area_correction = vesicle.area_correction;
  d.volume_correction = vesicle.volume_correction;
  d.divergence = shape.surface->divergence(flat(vesicle.velocity)).cwiseAbs().maxCoeff();
  d.iterations = static_cast<double>(state.iterations);
  d.rejected = static_cast<double>(state.controller.rejected);
  d.triangles = static_cast<double>(vesicle.triangles.rows());
  d.remeshings = static_cast<double>(state.remeshing.count);
  d.remeshing_energy = state.remeshing.energy * scales_.energy;
  if (vesicle.tension.size() > 0)
  {
    const Eigen::VectorXd tension =
      shape.surface->collocation().at_vertices(vesicle.tension) * scales_.tension();
    d.tension_min = tension.minCoeff();
    d.tension_max = tension.maxCoeff();
  }
  add_geometry(shape, d);
  add_power(shape, vesicle, system.part(system.imposed, number), d);
  add_shape(shape, d);
  add_flow(shape, vesicle, *pieces_[number], d);
  if (system_.wall)
    add_wall(shape, d);
  return d;
}

// Once the velocity is there.
void StateReport::add_wall(const VesicleShape& shape, Diagnostics& d) const
{
  d.wall_gap =
    wall_gap(*system_.wall, { shape.vesicle->layer.get(), shape.surface.get() }).distance *
    scales_.length;
  d.lift_speed = system_.wall->normal.dot(Eigen::Map<const Vector3>(d.velocity.data()));
}

void StateReport::add_geometry(const VesicleShape& shape, Diagnostics& d) const
{
  const Surface& surface = *shape.surface;
  d.area = surface.area * scales_.length * scales_.length;
  d.volume = surface.volume * std::pow(scales_.length, 3);
  d.reduced_volume = reduced_volume(surface.area, surface.volume);
  const double energy = shape.vesicle->energy(surface);
  if (shape.vesicle->has_energy())
    d.bending_energy = energy * scales_.energy;
  d.energy_over_8pi = energy / (8 * std::numbers::pi);
  for (int c = 0; c < 3; ++c)
    d.centroid[c] = surface.center[c] * scales_.length;
  const MeshQuality quality = mesh_quality({ surface.vertices, surface.space->triangles() });
  d.min_angle_deg = quality.min_angle_deg;
  d.edge_ratio = quality.edge_ratio;
}

// Power of external forces on the membrane, of other vesicles' too, and the imposed flow's work against all forces.
void StateReport::add_power(const VesicleShape& shape, const VesicleState& state,
  const Eigen::VectorXd& imposed, Diagnostics& d) const
{
  const std::vector<NodalForce> forces = forces_used(shape, state);
  NodalForce load = sum_of(forces, shape, external);
  load += shape.force_from_others;
  const NodalForce membrane = membrane_force(forces, shape, state);
  const auto total = [&](const Eigen::VectorXd& v)
  {
    const double tension =
      state.tension.size() > 0 ? shape.basis().tension_power(state.tension, v) : 0;
    return power(shape, membrane, v) + tension + power(shape, load, v);
  };
  const Eigen::VectorXd u = flat(state.velocity);
  const double against = system_.flow ? total(imposed) : 0;
  d.power_in = (power(shape, load, u) - against) * scales_.power();
  d.dissipation = (total(u) - against) * scales_.power();
  // On smooth surfaces all that dissipates, what the fluid does, the tension's filter, the time
  // step and the mesh's own motion: the energy that is reported changes by the rest.
  if (shape.loads)
    d.dissipation = d.power_in -
      scales_.power() *
        shape.loads->gradient().dot(shape.surface->to_control(flat(state.node_velocity)));
  if (system_.splits_power())
    split_power(shape, u, imposed, total(u) - against, d);
}

// With t(u) the traction inside of a fluid of viscosity 1, f = −[σ]·n gives the outer fluid's traction
// λ t(u) − f, and that of its flow less the imposed one, a flow on either side, λ t(u) − f − t(u∞).
void StateReport::split_power(const VesicleShape& shape, const Eigen::VectorXd& velocity,
  const Eigen::VectorXd& imposed, double on_disturbance, Diagnostics& d) const
{
  const Surface& surface = *shape.surface;
  const VesicleLoads& loads = *shape.loads;
  const InnerFlow inner(loads, *shape.vesicle->layer, layer_);
  const Eigen::VectorXd u = surface.to_control(velocity);
  Eigen::VectorXd traction = loads.viscosity_ratio() * inner.traction(velocity);
  PowerSplit& split = d.split.emplace();
  split.inside = traction.dot(u) * scales_.power();
  if (system_.flow)
    traction -= inner.traction(imposed);
  split.outside =
    (on_disturbance - traction.dot(surface.to_control(velocity - imposed))) * scales_.power();
  if (loads.viscous())
    split.membrane = -loads.viscous_load(u).dot(u) * scales_.power();
}

void StateReport::add_shape(const VesicleShape& shape, Diagnostics& d) const
{
  const Surface& surface = *shape.surface;
  const InertiaEllipsoid ellipsoid = inertia_ellipsoid(surface.points, surface.center);
  d.inclination_deg = ellipsoid.inclination_deg;
  d.tilt_deg = ellipsoid.tilt_deg;
  for (int i = 0; i < 3; ++i)
    d.semi_axes[i] = ellipsoid.semi_axes[i] * scales_.length;
  d.taylor_deformation = (d.semi_axes[0] - d.semi_axes[2]) / (d.semi_axes[0] + d.semi_axes[2]);
  if (const auto amplitudes =
        harmonic_amplitudes(surface.points, surface.center, Diagnostics::harmonic_degree))
    std::copy(amplitudes->begin(), amplitudes->end(), d.harmonics.emplace().begin());
}

void StateReport::add_flow(const VesicleShape& shape, const VesicleState& state,
  const FlatPieces& pieces, Diagnostics& d) const
{
  const Surface& surface = *shape.surface;
  const BasisTable& table = surface.space->table();
  const Vector3 U = surface.mean_velocity(flat(state.velocity));
  for (int c = 0; c < 3; ++c)
    d.velocity[c] = U[c] * scales_.velocity();
  const FlatSample sample = pieces.around(surface.center.y(), surface, state.velocity);
  d.tank_treading_frequency =
    tank_treading_frequency(sample.mesh, sample.field, surface.center, U) / scales_.time();

  RowVectors force;
  const NodalForce membrane = membrane_force(forces_used(shape, state), shape, state);
  if (!empty(membrane))
    force = interpolate(
      table, rows_of_three(surface.to_control(flat(shape.basis().at_vertices(membrane)))));
  Eigen::VectorXd tension;
  if (state.tension.size() > 0)
    tension = interpolate(table, state.tension);
  Eigen::Matrix3d S = stresslet(surface.points, surface.center, force, tension);
  if (const double contrast = shape.vesicle->viscosity_ratio - 1; contrast != 0)
    S += contrast *
      interface_stresslet(surface.points,
        interpolate(table, rows_of_three(surface.to_control(flat(state.velocity)))));
  S *= scales_.energy;
  d.stresslet = { S(0, 0), S(0, 1), S(0, 2), S(1, 1), S(1, 2), S(2, 2) };
}

std::map<std::string, Eigen::MatrixXd> StateReport::fields(
  const State& state, const SystemShape& system, std::size_t number) const
{
  const VesicleShape& shape = system.vesicles[number];
  const VesicleState& vesicle = state.vesicles[number];
  const Surface& surface = *shape.surface;
  const Curvature curvature = vertex_curvature(surface);
  std::map<std::string, Eigen::MatrixXd> fields;
  fields["Mean_Curvature"] = curvature.mean * scales_.curvature();
  fields["Gauss_Curvature"] = curvature.gauss * std::pow(scales_.curvature(), 2);
  fields["Laplacian_Mean_Curvature"] = curvature.laplacian_mean * std::pow(scales_.curvature(), 3);
  fields["Normals"] = surface.normals;
  fields["Velocity"] = vesicle.velocity * scales_.velocity();
  fields["Surface_Divergence"] = surface.divergence(flat(vesicle.velocity)) / scales_.time();

  const std::vector<NodalForce> forces = forces_used(shape, vesicle);
  Points membrane = Points::Zero(surface.vertices.rows(), 3);
  for (std::size_t t = 0; t < forces.size(); ++t)
  {
    const MembraneTerm& term = *shape.vesicle->terms[t];
    const Points force = shape.basis().at_vertices(forces[t]);
    fields[term.name() + "_Force"] = force * scales_.force_density();
    if (!term.external())
      membrane += force;
  }
  if (const NodalForce viscous = viscous_force(shape, vesicle); !empty(viscous))
  {
    const Points force = shape.basis().at_vertices(viscous);
    fields["Viscous_Force"] = force * scales_.force_density();
    membrane += force;
  }
  if (!empty(shape.force_from_others))
    fields["Repulsion_Force"] =
      shape.basis().at_vertices(shape.force_from_others) * scales_.force_density();
  Points constraint = Points::Zero(membrane.rows(), 3);
  if (const NodalForce force = constraint_force(shape, vesicle); !empty(force))
    constraint = shape.basis().at_vertices(force);
  membrane += constraint;
  if (vesicle.tension.size() > 0)
  {
    const Points force = shape.basis().tension_at_vertices(vesicle.tension) + constraint;
    fields["Tension"] = surface.collocation().at_vertices(vesicle.tension) * scales_.tension();
    fields["Tension_Force"] = force * scales_.force_density();
    membrane += force - constraint;
  }
  fields["Membrane_Force"] = membrane * scales_.force_density();
  return fields;
}

}
