#pragma once
// The fields of a State and their names in the run file, listed once for writing, reading and
// checking.

#include "solver/state/State.h"

namespace vesicle
{

/// Calls visit(name, field) for every field, always in the same order. Fields are std::int64_t,
/// double, Points or Eigen::VectorXd; const where `state` is.
template<class StateOrConst, class Visit>
void for_each_field(StateOrConst& state, Visit&& visit)
{
  visit("step", state.step);
  visit("time", state.time);
  visit("last_step", state.last_step);
  visit("next_step", state.next_step);
  visit("free_step", state.free_step);
  visit("output", state.output);
  visit("points", state.points);
  visit("velocity", state.velocity);
  visit("node_velocity", state.node_velocity);
  visit("tension", state.tension);
  visit("bending", state.bending);
  visit("volume_speed", state.volume_speed);
  visit("target_area", state.target_area);
  visit("target_volume", state.target_volume);
  visit("area_correction", state.area_correction);
  visit("volume_correction", state.volume_correction);
  visit("iterations", state.iterations);
  visit("rejected", state.rejected);
  visit("preconditioner_points", state.preconditioner_points);
  visit("preconditioner_step", state.preconditioner_step);
}

}
