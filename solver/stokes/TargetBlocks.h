#pragma once
// Sources and targets as the kernel takes them (kernels/StokesletKernel.h): arrays of components;
// blocks of sum_lanes, x of all, y, z.

#include "solver/stokes/kernels/StokesletKernel.h"
#include "solver/surface/SurfaceIntegrals.h"

#include <algorithm>
#include <vector>

namespace vesicle
{

inline constexpr int block_size = 3 * sum_lanes; ///< numbers
/// So many blocks see the same sources while these are in the cache.
inline constexpr int most_blocks_a_task = 4;

/// `count` rows from `first` on of positions and strengths, a component a column.
template<PointKind kind, class Positions, class Strengths>
auto point_sources(const Positions& x, const Strengths& s, int first, int count)
{
  using Real = typename Strengths::Scalar;
  PointSources<Real, kind> sources{ {}, {}, count };
  for (int c = 0; c < 3; ++c)
    sources.position[c] = &x(first, c);
  for (int c = 0; c < components_of(kind); ++c)
    sources.strength[c] = &s(first, c);
  return sources;
}

/// Where component c of row i is.
inline int place_in_blocks(int i, int c)
{
  return i / sum_lanes * block_size + c * sum_lanes + i % sum_lanes;
}

/// The last row fills up the last block.
template<class Positions>
auto in_blocks(const Positions& rows)
{
  const int n = static_cast<int>(rows.rows()), all = (n + sum_lanes - 1) / sum_lanes * sum_lanes;
  std::vector<typename Positions::Scalar> blocks(3 * all);
  for (int i = 0; i < all; ++i)
    for (int c = 0; c < 3; ++c)
      blocks[place_in_blocks(i, c)] = rows(std::min(i, n - 1), c);
  return blocks;
}

}
