#include "solver/stokes/PointSum.h"

#include "solver/ParallelFor.h"
#include "solver/stokes/TargetBlocks.h"

#include <array>

namespace vesicle
{

namespace
{

// Sources that stay in the cache while all of a task's targets see them.
constexpr int chunk = 1024;
constexpr int fewest_tasks = 32;

}

Eigen::Matrix<double, Eigen::Dynamic, 6> symmetric_products(
  const RowVectors& a, const RowVectors& b)
{
  const auto x = a.array(), y = b.array();
  Eigen::Array<double, Eigen::Dynamic, 6> s(a.rows(), 6);
  s.col(0) = x.col(0) * y.col(0);
  s.col(1) = (x.col(0) * y.col(1) + x.col(1) * y.col(0)) / 2;
  s.col(2) = (x.col(0) * y.col(2) + x.col(2) * y.col(0)) / 2;
  s.col(3) = x.col(1) * y.col(1);
  s.col(4) = (x.col(1) * y.col(2) + x.col(2) * y.col(1)) / 2;
  s.col(5) = x.col(2) * y.col(2);
  return s;
}

Eigen::RowVector3d summation_origin(PointKind kind, const Points& targets)
{
  Eigen::RowVector3d origin = targets.colwise().mean();
  if (is_image(kind))
    origin.z() = 0;
  return origin;
}

template<PointKind kind>
template<class Real>
DirectPointSum<kind>::Places<Real>::Places(const RowVectors& sources, const RowVectors& targets)
  : grid(std::max(extent_of(sources), extent_of(targets))), sources(grid.positions(sources)),
    targets(in_blocks(grid.positions(targets)))
{
}

template<PointKind kind>
DirectPointSum<kind>::DirectPointSum(const RowVectors& sources, const Points& targets)
  : DirectPointSum(sources, targets, summation_origin(kind, targets))
{
}

template<PointKind kind>
DirectPointSum<kind>::DirectPointSum(
  const RowVectors& sources, const Points& targets, const Eigen::RowVector3d& origin)
  : full_(sources.rowwise() - origin, targets.rowwise() - origin),
    single_(sources.rowwise() - origin, targets.rowwise() - origin)
{
}

template<PointKind kind>
template<class Real>
void DirectPointSum<kind>::add(const Places<Real>& at,
  const Eigen::Ref<const Eigen::MatrixXd>& strengths, Points& velocity) const
{
  constexpr int components = components_of(kind);
  const double scale = strength_unit<Real>(strengths), unit = scale * at.grid.unit(kind);
  const Eigen::Array<Real, Eigen::Dynamic, components> strength =
    (strengths / scale).array().template cast<Real>();
  const int blocks = static_cast<int>(at.targets.size()) / block_size,
            a_task = std::clamp(blocks / fewest_tasks, 1, most_blocks_a_task),
            sources = static_cast<int>(strength.rows()), n = static_cast<int>(velocity.rows());
  parallel_for((blocks + a_task - 1) / a_task,
    [&](int task)
    {
      const int first = task * a_task, count = std::min(a_task, blocks - first);
      std::array<double, most_blocks_a_task * block_size> sum{};
      for (int q = 0; q < sources; q += chunk)
      {
        const auto of_chunk =
          point_sources<kind>(at.sources, strength, q, std::min(chunk, sources - q));
        for (int b = 0; b < count; ++b)
          add_points(
            of_chunk, at.targets.data() + (first + b) * block_size, sum.data() + b * block_size);
      }
      for (int i = first * sum_lanes; i < std::min((first + count) * sum_lanes, n); ++i)
        for (int c = 0; c < 3; ++c)
          velocity(i, c) += unit * sum[place_in_blocks(i - first * sum_lanes, c)];
    });
}

template<PointKind kind>
void DirectPointSum<kind>::add(
  const Eigen::Ref<const Eigen::MatrixXd>& strengths, double allowed, Points& velocity) const
{
  if (allowed >= single_precision_error)
    add(single_, strengths, velocity);
  else
    add(full_, strengths, velocity);
}

template class DirectPointSum<PointKind::force>;
template class DirectPointSum<PointKind::stresslet>;
template class DirectPointSum<PointKind::force_image>;
template class DirectPointSum<PointKind::stresslet_image>;

}
