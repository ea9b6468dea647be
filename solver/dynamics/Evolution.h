#pragma once
// Accepted steps: State in, State out. The step size follows the error, output times are hit.

#include "solver/dynamics/OutputSchedule.h"
#include "solver/dynamics/Stepper.h"

namespace vesicle
{

class Evolution
{
public:
  /// `time_unit`: t0 in the scene's units. `fixed_step` in t0; empty: adaptive.
  Evolution(System system, const StepperSettings& settings, const OutputSchedule& schedule,
    double time_unit, std::optional<double> fixed_step);

  const System& system() const { return stepper_.system(); }
  const OutputSchedule& schedule() const { return schedule_; }
  Stepper& stepper() { return stepper_; }

  /// Time 0 at these points, velocities and tensions solved with bending as implicit as the first
  /// step needs it.
  State start(const std::vector<Points>& points);
  /// The same with nothing of a time step in it: stiff forces are those of the shape.
  State instant(const std::vector<Points>& points);
  /// The same moment as `state`, whose vesicles had other meshes, at these points of the system's own.
  State transferred(const State& state, const std::vector<Points>& points);
  /// One accepted step. Throws StepFailure if there is none; `state` is then still valid.
  State step(const State& state);
  /// True where no shape changes any more: normal speeds, relative to the centroids.
  bool steady(const State& state);

private:
  double rate() const;
  double time_unit() const { return stepper_.settings().time_unit; }
  State unsolved(const std::vector<Points>& points);
  void require_apart(const State& state);
  void plan_next_step(State& state);
  bool overshoots(const State& state) const;
  State accept(const State& before, const State& from, State after, StepReport report);

  Stepper stepper_;
  OutputSchedule schedule_;
  std::optional<double> fixed_step_;
};

}
