#include "solver/stokes/ProxyTree.h"

#include "solver/ParallelFor.h"

namespace vesicle
{

namespace
{

int padded(int count, int multiple)
{
  return (count + multiple - 1) / multiple * multiple;
}

// Where proxies are wanted, those of the halves carry on.
void use_halves(const ClusterTree& tree, std::vector<bool>& used)
{
  for (std::size_t c = 0; c < used.size(); ++c)
  {
    used[c] = used[c] && tree.clusters[c].compact();
    for (const int child : tree.clusters[c].child)
      if (used[c])
        used[child] = true;
  }
}

std::vector<std::vector<int>> levels_of(const ClusterTree& tree, const std::vector<bool>& used)
{
  std::vector<std::vector<int>> levels(1);
  std::vector<int> level(tree.clusters.size(), 0);
  for (std::size_t c = 0; c < used.size(); ++c)
  {
    if (used[c])
      levels[level[c]].push_back(static_cast<int>(c));
    for (const int child : tree.clusters[c].child)
      if (child != Cluster::no_child)
        level[child] = level[c] + 1;
    if (!tree.clusters[c].leaf() && level[c] + 2 > static_cast<int>(levels.size()))
      levels.resize(level[c] + 2);
  }
  return levels;
}

}

// Leaf by leaf, which lie in the order of their points.
template<class Real>
void ProxyTree<Real>::place_points(int multiple)
{
  int first = 0;
  for (const Cluster& cluster : tree_.clusters)
    if (cluster.leaf())
    {
      for (int i = 0; i < cluster.points(); ++i)
        point_row_.push_back(first + i);
      first += padded(cluster.points(), multiple);
    }
  point_row_.push_back(first);
}

template<class Real>
ProxyTree<Real>::ProxyTree(
  ClusterTree tree, const RowVectors& points, std::vector<bool> used, int multiple)
  : tree_(std::move(tree))
{
  use_halves(tree_, used);
  place_points(multiple);
  int rows_of_all = point_row_.back();
  for (std::size_t c = 0; c < used.size(); ++c)
  {
    first_proxy_.push_back(rows_of_all);
    rows_of_all += used[c] ? padded(tree_.clusters[c].proxies(), multiple) : 0;
  }

  positions_.resize(rows_of_all, 3);
  for (std::size_t i = 0; i < tree_.order.size(); ++i)
    positions_.row(point_row_[i]) = points.row(tree_.order[i]);
  parallel_for(used.size(),
    [&](std::size_t c)
    {
      const RowRange at = rows(static_cast<int>(c));
      if (used[c])
        positions_.middleRows(at.first, at.count) = tree_.clusters[c].proxy_positions();
      if (used[c] || tree_.clusters[c].leaf())
        for (int i = at.first + at.count; i < at.first + padded(at.count, multiple); ++i)
          positions_.row(i) = positions_.row(i - 1);
    });

  for (const std::vector<int>& level : levels_of(tree_, used))
  {
    std::vector<Proxies> proxies(level.size());
    parallel_for(level.size(),
      [&](std::size_t k)
      {
        const Cluster& cluster = tree_.clusters[level[k]];
        proxies[k].rows = rows(level[k]);
        for (int h = 0; h < 2; ++h)
        {
          const RowRange half = proxies[k].half[h] = rows(cluster.child[h]);
          proxies[k].interpolation[h] =
            ProxyInterpolation<Real>(cluster, positions_.middleRows(half.first, half.count));
        }
      });
    levels_.push_back(std::move(proxies));
  }
}

template<class Real>
RowRange ProxyTree<Real>::rows(int c) const
{
  const Cluster& cluster = tree_.clusters[c];
  if (cluster.compact())
    return { first_proxy_[c], cluster.proxies() };
  const int first = point_row_[cluster.begin];
  return { first, point_row_[cluster.end - 1] + 1 - first };
}

template<class Real>
ThreeColumns<Real> ProxyTree<Real>::up(const RowVectors& forces) const
{
  ThreeColumns<Real> all = ThreeColumns<Real>::Zero(positions_.rows(), 3);
  for (std::size_t i = 0; i < tree_.order.size(); ++i)
    all.row(point_row_[i]) = forces.row(tree_.order[i]).template cast<Real>();
  for (auto level = levels_.rbegin(); level != levels_.rend(); ++level)
    parallel_for(level->size(),
      [&](std::size_t k)
      {
        const Proxies& at = (*level)[k];
        for (int h = 0; h < 2; ++h)
          at.interpolation[h].up(all.middleRows(at.half[h].first, at.half[h].count),
            all.middleRows(at.rows.first, at.rows.count));
      });
  return all;
}

template<class Real>
void ProxyTree<Real>::down(ThreeColumns<Real> all, Points& velocities) const
{
  for (const std::vector<Proxies>& level : levels_)
    parallel_for(level.size(),
      [&](std::size_t k)
      {
        const Proxies& at = level[k];
        for (int h = 0; h < 2; ++h)
          at.interpolation[h].down(all.middleRows(at.rows.first, at.rows.count),
            all.middleRows(at.half[h].first, at.half[h].count));
      });
  for (std::size_t i = 0; i < tree_.order.size(); ++i)
    velocities.row(tree_.order[i]) += all.row(point_row_[i]).template cast<double>();
}

template class ProxyTree<float>;
template class ProxyTree<double>;

}
