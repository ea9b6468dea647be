#include "solver/stokes/TreeSum.h"

#include "solver/ParallelFor.h"
#include "solver/stokes/ClusterPairs.h"
#include "solver/stokes/TargetBlocks.h"

namespace vesicle
{

namespace
{

// What a solve allows grows from iteration to iteration, and the more, the fewer pairs a tree has.
constexpr double fine_error = single_precision_error, coarse_error = 1e-4;

}

template<PointKind kind>
template<class Real>
TreePointSum<kind>::Tree<Real>::Tree(const PointPlaces& places, double tolerance)
{
  const Eigen::RowVector3d origin = summation_origin(kind, places.targets);
  const RowVectors sources_at = places.sources.rowwise() - origin,
                   targets_at = places.targets.rowwise() - origin;
  ClusterTree source_tree(sources_at, places.first_source, tolerance, sum_lanes),
    target_tree(targets_at, places.first_target, tolerance, sum_lanes);
  const std::vector<std::vector<int>> pairs = acting_clusters(target_tree, source_tree);
  std::vector<bool> acts(source_tree.clusters.size()), acted_on(target_tree.clusters.size());
  for (std::size_t t = 0; t < pairs.size(); ++t)
    for (const int s : pairs[t])
      acts[s] = acted_on[t] = true;
  sources = std::make_unique<ProxyTree<Real>>(std::move(source_tree), sources_at, acts, sum_lanes);
  targets =
    std::make_unique<ProxyTree<Real>>(std::move(target_tree), targets_at, acted_on, sum_lanes);
  const PointGrid<Real> grid(
    std::max(extent_of(sources->positions()), extent_of(targets->positions())));
  unit = grid.unit(kind);
  source_positions = grid.positions(sources->positions());
  target_positions = in_blocks(grid.positions(targets->positions()));

  for (std::size_t t = 0; t < pairs.size(); ++t)
  {
    if (pairs[t].empty())
      continue;
    std::vector<RowRange> of_target;
    for (const int s : pairs[t])
      of_target.push_back(sources->rows(s));
    const RowRange rows = targets->rows(static_cast<int>(t));
    const int first = rows.first / sum_lanes, blocks = (rows.count + sum_lanes - 1) / sum_lanes;
    for (int b = 0; b < blocks; b += most_blocks_a_task)
      tasks.push_back(
        { first + b, std::min(most_blocks_a_task, blocks - b), static_cast<int>(acting.size()) });
    acting.push_back(std::move(of_target));
  }
}

template<PointKind kind>
template<class Real>
void TreePointSum<kind>::Tree<Real>::add(
  const Eigen::Ref<const Eigen::MatrixXd>& strengths, Points& velocity) const
{
  constexpr int components = components_of(kind);
  const double scale = strength_unit<Real>(strengths), velocity_unit = scale * unit;
  Eigen::Array<Real, Eigen::Dynamic, components> f(sources->positions().rows(), components);
  for (int c = 0; c < components; c += 3)
    f.template middleCols<3>(c) = sources->up(strengths.middleCols<3>(c) / scale).array();
  ThreeColumns<Real> u = ThreeColumns<Real>::Zero(targets->positions().rows(), 3);
  const auto& x = source_positions;
  parallel_for(tasks.size(),
    [&](std::size_t k)
    {
      const Task& task = tasks[k];
      std::array<double, most_blocks_a_task * block_size> sum{};
      for (const RowRange& rows : acting[task.acting])
      {
        const auto of_range = point_sources<kind>(x, f, rows.first, rows.count);
        for (int b = 0; b < task.blocks; ++b)
          add_points(of_range, target_positions.data() + (task.first_block + b) * block_size,
            sum.data() + b * block_size);
      }
      for (int i = 0; i < task.blocks * sum_lanes; ++i)
        for (int c = 0; c < 3; ++c)
          u(task.first_block * sum_lanes + i, c) =
            static_cast<Real>(velocity_unit * sum[place_in_blocks(i, c)]);
    });
  targets->down(std::move(u), velocity);
}

template<PointKind kind>
TreePointSum<kind>::TreePointSum(const PointPlaces& places, double tolerance)
  : best_(places, tolerance), fine_(places, std::max(tolerance, fine_error)),
    coarse_(places, std::max(tolerance, coarse_error))
{
}

template<PointKind kind>
void TreePointSum<kind>::add(
  const Eigen::Ref<const Eigen::MatrixXd>& strengths, double allowed, Points& velocity) const
{
  if (allowed >= coarse_error)
    coarse_.add(strengths, velocity);
  else if (allowed >= fine_error)
    fine_.add(strengths, velocity);
  else
    best_.add(strengths, velocity);
}

template class TreePointSum<PointKind::force>;
template class TreePointSum<PointKind::stresslet>;
template class TreePointSum<PointKind::force_image>;
template class TreePointSum<PointKind::stresslet_image>;

}
