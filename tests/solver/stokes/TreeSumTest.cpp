// Sums of point forces through clusters against all pairs one by one: on thin, round and scattered
// sets of points, to the tolerance asked for; every pair once; whatever the points.

#include "solver/stokes/TreeSum.h"

#include "solver/stokes/ClusterPairs.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <functional>
#include <map>
#include <random>

namespace vesicle
{
namespace
{

using Map = std::function<Eigen::RowVector3d(const Eigen::RowVector3d&)>;

RowVectors normal_rows(
  int rows, unsigned seed, const Map& map = [](const Eigen::RowVector3d& x) { return x; })
{
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  RowVectors points(rows, 3);
  for (int i = 0; i < rows; ++i)
  {
    const double x = normal(random), y = normal(random), z = normal(random);
    points.row(i) = map(Eigen::RowVector3d(x, y, z));
  }
  return points;
}

struct Scatter
{
  const char* name;
  Map map;
};

// A sphere, a thin bent shape, a volume far from the origin, a line, two bodies far apart.
const std::vector<Scatter>& scatters()
{
  static const std::vector<Scatter> all{
    { "sphere", [](const auto& x) { return x.normalized(); } },
    { "banana",
      [](const auto& x)
      {
        const Eigen::RowVector3d n = x.normalized();
        return Eigen::RowVector3d(2 * n[0], 0.3 * n[1] + n[0] * n[0], 0.3 * n[2]);
      } },
    { "volume", [](const auto& x) -> Eigen::RowVector3d { return x.array() + 100; } },
    { "line", [](const auto& x) { return Eigen::RowVector3d(x[0], 2 * x[0], 0); } },
    { "two bodies",
      [](const auto& x) -> Eigen::RowVector3d
      { return x.normalized() + Eigen::RowVector3d(x[0] > 0 ? 50 : 0, 0, 0); } },
  };
  return all;
}

Points direct(const RowVectors& sources, const RowVectors& forces, const Points& targets)
{
  Points velocity = Points::Zero(targets.rows(), 3);
  DirectSum(sources, targets).add(forces, 0, velocity);
  return velocity;
}

double relative_error(const Points& velocity, const Points& exact)
{
  return (velocity - exact).norm() / exact.norm();
}

TEST(TreeSum, LeavesTheToleranceAskedFor)
{
  for (const Scatter& scatter : scatters())
    for (const double tolerance : { 1e-4, 1e-6, 1e-8, 1e-10 })
    {
      const RowVectors sources = normal_rows(20000, 1, scatter.map), forces = normal_rows(20000, 2);
      const Points targets = normal_rows(5003, 3, scatter.map);
      const Points exact = direct(sources, forces, targets);
      Points velocity = Points::Zero(targets.rows(), 3);
      TreeSum({ sources, targets }, tolerance).add(forces, 0, velocity);
      EXPECT_LT(relative_error(velocity, exact), tolerance) << scatter.name << " " << tolerance;
    }
}

// What there is is added to; forces of one sign, whose far fields don't cancel.
TEST(TreeSum, AddsToTheVelocitiesWithTheErrorAllowed)
{
  const Map& banana = scatters()[1].map;
  const RowVectors sources = normal_rows(20000, 1, banana),
                   forces = normal_rows(20000, 2).cwiseAbs();
  const Points targets = normal_rows(5000, 3, banana), start = Points::Constant(5000, 3, 7);
  const Points exact = direct(sources, forces, targets);
  const TreeSum sum({ sources, targets }, 1e-7);
  for (const double allowed : { 0., 1e-9, single_precision_error, 1e-5, 1e-4, 1e-2 })
  {
    Points velocity = start;
    sum.add(forces, allowed, velocity);
    EXPECT_LT(relative_error(velocity - start, exact), std::max(allowed, 1e-7)) << allowed;
  }
}

TEST(TreeSum, FewPointsAreSummedExactly)
{
  for (const auto& [sources, targets] :
    { std::pair{ 1, 1 }, std::pair{ 1, 40 }, std::pair{ 40, 1 }, std::pair{ 17, 33 } })
  {
    const RowVectors at = normal_rows(sources, 1), forces = normal_rows(sources, 2);
    const Points to = normal_rows(targets, 3), exact = direct(at, forces, to);
    Points velocity = Points::Zero(targets, 3);
    TreeSum({ at, to }, 1e-7).add(forces, 0, velocity);
    EXPECT_LT(relative_error(velocity, exact), 1e-14) << sources << " " << targets;
  }
}

// Many at one place, or not a number: no crash, and what is right elsewhere.
TEST(TreeSum, TakesAnyPoints)
{
  const RowVectors forces = normal_rows(3000, 2);
  const Points targets = normal_rows(3000, 3);
  RowVectors sources = normal_rows(3000, 1);
  sources.topRows(2500).rowwise() = Eigen::RowVector3d(1, 2, 3);
  Points velocity = Points::Zero(3000, 3);
  TreeSum({ sources, targets }, 1e-7).add(forces, 0, velocity);
  EXPECT_LT(relative_error(velocity, direct(sources, forces, targets)), 1e-7);

  sources(17, 1) = std::numeric_limits<double>::quiet_NaN();
  for (const double allowed : { 0., 1e-5, 1e-3 })
  {
    velocity.setZero();
    TreeSum({ sources, targets }, 1e-7).add(forces, allowed, velocity);
    EXPECT_FALSE(velocity.allFinite()) << allowed;
  }
}

TEST(TreeSum, DoesNotDependOnTheNumberOfThreads)
{
  const Map& sphere = scatters()[0].map;
  const RowVectors sources = normal_rows(20000, 1, sphere), forces = normal_rows(20000, 2);
  const Points targets = normal_rows(5000, 3, sphere);
  std::vector<Points> velocity(2, Points::Zero(5000, 3));
  for (const int threads : { 1, 4 })
  {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    TreeSum({ sources, targets }, 1e-6).add(forces, 0, velocity[threads > 1]);
  }
  EXPECT_EQ(velocity[0], velocity[1]);
}

// A lattice of ellipsoids nearly touching, of different numbers of points.
struct Bodies
{
  RowVectors positions{ 0, 3 };
  std::vector<int> first{ 0 };

  Bodies(int fewest, unsigned seed)
  {
    for (int i = 0; i < 27; ++i)
    {
      const Eigen::RowVector3d center(i % 3, i / 3 % 3, i / 9);
      const int count = fewest + 7 * i;
      positions.conservativeResize(first.back() + count, 3);
      positions.bottomRows(count) = normal_rows(count, seed + i,
        [&](const Eigen::RowVector3d& x) -> Eigen::RowVector3d
        { return 2.3 * center + x.normalized().cwiseProduct(Eigen::RowVector3d(1.1, 0.9, 0.7)); });
      first.push_back(first.back() + count);
    }
  }
};

TEST(TreeSum, TakesBodiesAsClusters)
{
  const Bodies sources(900, 1), targets(150, 100);
  const RowVectors forces = normal_rows(sources.first.back(), 2);
  const Points exact = direct(sources.positions, forces, targets.positions);
  for (const double tolerance : { 1e-4, 1e-6, 1e-8 })
  {
    Points velocity = Points::Zero(targets.first.back(), 3);
    TreeSum({ sources.positions, targets.positions, sources.first, targets.first }, tolerance)
      .add(forces, 0, velocity);
    EXPECT_LT(relative_error(velocity, exact), tolerance);
  }
}

TEST(ClusterTree, NoClusterHoldsPartsOfTwoBodies)
{
  const Bodies bodies(150, 1);
  const ClusterTree tree(bodies.positions, bodies.first, 1e-6, 16);
  const auto body_of = [&](int point)
  {
    return std::upper_bound(bodies.first.begin(), bodies.first.end(), point) -
      bodies.first.begin() - 1;
  };
  for (const Cluster& cluster : tree.clusters)
  {
    std::map<std::ptrdiff_t, int> held;
    for (int i = cluster.begin; i < cluster.end; ++i)
      ++held[body_of(tree.order[i])];
    for (const auto& [body, points] : held)
      EXPECT_TRUE(held.size() == 1 || points == bodies.first[body + 1] - bodies.first[body]);
    for (int i = cluster.begin; i < cluster.end; ++i)
      EXPECT_LE(
        (bodies.positions.row(tree.order[i]).transpose() - cluster.centre).norm(), cluster.radius);
  }
  EXPECT_TRUE(tree.clusters.front().compact()); // of all bodies
  std::vector<int> all = tree.order;
  std::sort(all.begin(), all.end());
  for (std::size_t i = 0; i < all.size(); ++i)
    EXPECT_EQ(all[i], static_cast<int>(i));
}

TEST(ClusterPairs, CountEveryPairOnce)
{
  const auto count = [](const ClusterTree& targets, const ClusterTree& sources)
  {
    Eigen::MatrixXi pairs = Eigen::MatrixXi::Zero(
      static_cast<int>(targets.order.size()), static_cast<int>(sources.order.size()));
    const std::vector<std::vector<int>> acting = acting_clusters(targets, sources);
    for (std::size_t t = 0; t < acting.size(); ++t)
      for (const int s : acting[t])
      {
        const Cluster &to = targets.clusters[t], &from = sources.clusters[s];
        EXPECT_TRUE(to.leaf() || (to.compact() && is_far(from, to)));
        EXPECT_TRUE(from.leaf() || (from.compact() && is_far(to, from)));
        pairs.block(to.begin, from.begin, to.points(), from.points()).array() += 1;
      }
    return (pairs.array() == 1).all();
  };
  for (const Scatter& scatter : scatters())
    EXPECT_TRUE(count(ClusterTree(normal_rows(1000, 2, scatter.map), {}, 1e-4, 16),
      ClusterTree(normal_rows(2000, 1, scatter.map), {}, 1e-4, 16)))
      << scatter.name;
  const Bodies sources(90, 1), targets(50, 100);
  EXPECT_TRUE(count(ClusterTree(targets.positions, targets.first, 1e-2, 16),
    ClusterTree(sources.positions, sources.first, 1e-2, 16)));
}

// The grid's weights are those of the polynomial that interpolates.
TEST(ClusterTree, ProxiesInterpolatePolynomials)
{
  const RowVectors points = normal_rows(2000, 1, scatters()[1].map);
  const ClusterTree tree(points, {}, 1e-6, 16);
  const auto polynomial = [](const RowVectors& x)
  { return (x.col(0).array().square() - 2 * x.col(1).array() * x.col(2).array() + 1).eval(); };
  for (const Cluster& cluster : tree.clusters)
  {
    ASSERT_GE(*std::min_element(cluster.grid.begin(), cluster.grid.end()), 1);
    if (*std::min_element(cluster.grid.begin(), cluster.grid.end()) < 3)
      continue;
    RowVectors inside(cluster.points(), 3);
    for (int i = 0; i < cluster.points(); ++i)
      inside.row(i) = points.row(tree.order[cluster.begin + i]);
    const Eigen::ArrayXd values = polynomial(cluster.proxy_positions());
    const Eigen::MatrixXd x = cluster.weights(0, inside), y = cluster.weights(1, inside),
                          z = cluster.weights(2, inside);
    Eigen::ArrayXd interpolated = Eigen::ArrayXd::Zero(cluster.points());
    for (int i = 0; i < cluster.proxies(); ++i)
    {
      const int a = i % cluster.grid[0], b = i / cluster.grid[0] % cluster.grid[1],
                c = i / cluster.grid[0] / cluster.grid[1];
      interpolated += values[i] * x.col(a).array() * y.col(b).array() * z.col(c).array();
    }
    EXPECT_LT((interpolated - polynomial(inside)).abs().maxCoeff(), 1e-12);
  }
}

}
}
