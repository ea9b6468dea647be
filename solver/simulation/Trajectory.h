#pragma once
// The accepted steps of a simulation, made as far as they are asked for and found again by time.

#include "solver/simulation/Simulation.h"

#include <optional>
#include <vector>

namespace vesicle
{

/// Steps are made in order and never depend on what was asked for. States at output times are kept;
/// what lies between two of them is computed again when it is asked for.
class Trajectory
{
public:
  /// A time on the trajectory: a state, or a place between two successive ones.
  struct Moment
  {
    double time = 0;
    const State* before = nullptr;
    const State* after = nullptr; ///< nullptr: exactly at `before`
  };

  /// Keeps at most `capacity` states; when there are more, every second one is given up.
  Trajectory(Simulation& simulation, State start, int capacity);

  const State& last() const { return last_; }
  bool finished() const { return finished_; }
  double start_time() const { return kept_.front().time; }

  /// One accepted step on from the last state. Throws NumericalError; the last state is then still
  /// what it was.
  void advance();

  /// The moment at `time`, or the nearest end of what was computed so far. Valid until the next
  /// call.
  Moment at(double time);

private:
  void keep(const State& state);
  Moment between(const State& before, const State& after, double time) const;
  void replay(double time);

  Simulation& simulation_;
  std::size_t capacity_;
  std::vector<State> kept_; ///< ascending; the first is the start
  std::optional<State> previous_;
  State last_;
  bool finished_;
  std::optional<State> replayed_before_, replayed_after_;
};

}
