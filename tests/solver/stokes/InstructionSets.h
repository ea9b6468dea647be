#pragma once
// The loops of every instruction set that this processor has, and what they make of points.

#include "solver/mesh/TriangleMesh.h"
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
  const Eigen::Array<Real, Eigen::Dynamic, 3> x = positions.array().cast<Real>();
  const Eigen::Array<Real, Eigen::Dynamic, Eigen::Dynamic> f = strengths.array().cast<Real>();
  std::vector<Real> targets(3 * sum_lanes), velocities(3 * sum_lanes);
  for (int i = 0; i < sum_lanes; ++i)
    for (int c = 0; c < 3; ++c)
      targets[c * sum_lanes + i] = static_cast<Real>(at(i, c));
  PointSources<Real, kind> points{ { &x(0, 0), &x(0, 1), &x(0, 2) }, {},
    static_cast<int>(x.rows()) };
  for (int c = 0; c < components_of(kind); ++c)
    points.strength[c] = &f(0, c);
  loops.add_points<Real, kind>()(points, targets.data(), velocities.data());
  Points velocity(sum_lanes, 3);
  for (int i = 0; i < sum_lanes; ++i)
    for (int c = 0; c < 3; ++c)
      velocity(i, c) = velocities[c * sum_lanes + i];
  return velocity;
}

}
