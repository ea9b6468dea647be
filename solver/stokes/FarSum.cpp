#include "solver/stokes/FarSum.h"

#include "solver/ParallelFor.h"

#include <algorithm>
#include <array>

namespace vesicle
{

void add_direct_sum(const ForceSources& sources, const Points& targets, Points& velocity)
{
  constexpr int lanes = stokeslet_lanes;
  const int n = static_cast<int>(targets.rows());
  parallel_for((n + lanes - 1) / lanes,
    [&](int group)
    {
      const int first = group * lanes, count = std::min(lanes, n - first);
      std::array<double, 3 * lanes> position;
      for (int lane = 0; lane < lanes; ++lane)
        for (int c = 0; c < 3; ++c)
          position[c * lanes + lane] = targets(first + std::min(lane, count - 1), c);
      std::array<double, lanes> all;
      all.fill(1);
      std::array<double, 4 * lanes> sum{};
      add_velocities(sources, 0, sources.rows, position.data(), all.data(), sum.data());
      for (int lane = 0; lane < count; ++lane)
        for (int c = 0; c < 3; ++c)
          velocity(first + lane, c) += sum[c * lanes + lane];
    });
}

}
