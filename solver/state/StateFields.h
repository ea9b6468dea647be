#pragma once
// The fields of a State and their names in the run file, listed once for writing, reading and
// checking.

#include "solver/dynamics/State.h"

#include <string>

namespace vesicle
{

/// What belongs to a vesicle is in groups of this name.
inline std::string vesicle_group(std::size_t vesicle)
{
  return "vesicle_" + std::to_string(vesicle);
}

/// Calls visit(name, field) for every field, always in the same order; a name with a '/' is in the
/// group before it. Fields are std::int64_t, double, Points, Triangles or Eigen::VectorXd;
/// const where `state`
/// is. The state has its vesicles already.
template<class StateOrConst, class Visit>
void for_each_field(StateOrConst& state, Visit&& visit)
{
  visit("step", state.step);
  visit("time", state.time);
  visit("iterations", state.iterations);
  visit("last_step", state.controller.last_step);
  visit("next_step", state.controller.next_step);
  visit("free_step", state.controller.free_step);
  visit("output", state.controller.output);
  visit("rejected", state.controller.rejected);
  visit("preconditioner_step", state.preconditioner.step);
  visit("remeshings", state.remeshing.count);
  visit("remeshing_tried", state.remeshing.tried);
  visit("remeshing_disagreement", state.remeshing.disagreement);
  visit("remeshing_energy", state.remeshing.energy);
  for (std::size_t v = 0; v < state.vesicles.size(); ++v)
  {
    auto& vesicle = state.vesicles[v];
    const std::string group = vesicle_group(v) + "/";
    visit(group + "triangles", vesicle.triangles);
    visit(group + "points", vesicle.points);
    visit(group + "velocity", vesicle.velocity);
    visit(group + "node_velocity", vesicle.node_velocity);
    visit(group + "tension", vesicle.tension);
    visit(group + "stiff_force", vesicle.stiff_force);
    visit(group + "volume_speed", vesicle.volume_speed);
    visit(group + "pressure", vesicle.pressure);
    visit(group + "target_area", vesicle.target_area);
    visit(group + "target_volume", vesicle.target_volume);
    visit(group + "area_correction", vesicle.area_correction);
    visit(group + "volume_correction", vesicle.volume_correction);
    visit(group + "preconditioner_points", state.preconditioner.points[v]);
  }
}

}
