#pragma once
// The loops of every instruction set that this processor has, and what they make of points.

#include "solver/stokes/TargetBlocks.h"
#include "solver/stokes/PointGrid.h"
#include "solver/stokes/kernels/StokesletLoops.h"

#include <vector>

namespace vesicle::test
{

inline std::vector<const StokesletLoops*> all_loops()
{
  std::vector<const StokesletLoops*> all{ &portable_loops() };
#ifdef VESICLE_X86_LOOPS
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    all.push_back(&avx2_loops());
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq"))
    all.push_back(&avx512_loops());
#endif
  return all;
}

/// The velocities at sum_lanes targets.
template<class Real, PointKind kind>
Points velocities_by(const StokesletLoops& loops, const Points& positions,
  const Eigen::MatrixXd& strengths, const Points& at)
{
  const PointGrid<Real> grid(std::max(extent_of(positions), extent_of(at)));
  const auto x = grid.positions(positions);
  const Eigen::Array<Real, Eigen::Dynamic, Eigen::Dynamic> f = strengths.array().cast<Real>();
  const auto targets = in_blocks(grid.positions(at));
  std::vector<double> velocities(3 * sum_lanes);
  loops.add_points<Real, kind>()(
    point_sources<kind>(x, f, 0, static_cast<int>(x.rows())), targets.data(), velocities.data());
  Points velocity(sum_lanes, 3);
  for (int i = 0; i < sum_lanes; ++i)
    for (int c = 0; c < 3; ++c)
      velocity(i, c) = grid.unit(kind) * velocities[place_in_blocks(i, c)];
  return velocity;
}

}
