#include "solver/simulation/Trajectory.h"

#include <algorithm>
#include <cmath>

namespace vesicle
{
namespace
{

/// True if `time` lies between two states; false if one of them is missing.
bool holds(const std::optional<State>& before, const State* after, double time)
{
  return before && after && before->time <= time && time <= after->time;
}

}

Trajectory::Trajectory(Simulation& simulation, State start, int capacity)
  : simulation_(simulation),
    capacity_(static_cast<std::size_t>(std::max(capacity, 1))), kept_{ start },
    last_(std::move(start)), finished_(simulation.finished(last_))
{
}

void Trajectory::advance()
{
  State ready = simulation_.ready(last_);
  last_ = simulation_.step(ready);
  previous_ = std::move(ready);
  finished_ = simulation_.finished(last_);
  if (simulation_.schedule().due(last_))
  {
    keep(last_);
  }
}

void Trajectory::keep(const State& state)
{
  kept_.push_back(state);
  if (kept_.size() <= capacity_)
  {
    return;
  }
  std::vector<State> fewer;
  for (std::size_t i = 0; i < kept_.size(); i += 2)
  {
    fewer.push_back(std::move(kept_[i]));
  }
  kept_ = std::move(fewer);
}

Trajectory::Moment Trajectory::between(const State& before, const State& after, double time) const
{
  if (time <= before.time || same_time(time, before.time))
  {
    return { before.time, &before, nullptr };
  }
  if (time >= after.time || same_time(time, after.time))
  {
    return { after.time, &after, nullptr };
  }
  return { time, &before, &after };
}

Trajectory::Moment Trajectory::at(double time)
{
  if (time >= last_.time || same_time(time, last_.time))
  {
    return { last_.time, &last_, nullptr };
  }
  if (time <= start_time())
  {
    return { start_time(), &kept_.front(), nullptr };
  }
  if (holds(previous_, &last_, time))
  {
    return between(*previous_, last_, time);
  }
  for (const State& state : kept_)
  {
    if (same_time(time, state.time))
    {
      return { state.time, &state, nullptr };
    }
  }
  if (!holds(replayed_before_, replayed_after_ ? &*replayed_after_ : nullptr, time))
  {
    replay(time);
  }
  return between(*replayed_before_, *replayed_after_, time);
}

void Trajectory::replay(double time)
{
  const auto later =
    std::find_if(kept_.begin(), kept_.end(), [&](const State& state) { return state.time > time; });
  replayed_before_ = simulation_.ready(*std::prev(later));
  replayed_after_ = simulation_.step(*replayed_before_);
  while (replayed_after_->time < time)
  {
    replayed_before_ = simulation_.ready(*replayed_after_);
    replayed_after_ = simulation_.step(*replayed_before_);
  }
}

}
