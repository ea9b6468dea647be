#include "solver/mesh/SizingLaw.h"

#include <cmath>
#include <functional>
#include <numbers>
#include <queue>
#include <utility>
#include <vector>

namespace vesicle
{

namespace
{

using Row3 = Eigen::RowVector3d;

// The largest field below `h` that grows by no more than `growth` along edges: from the least value
// outwards (Dijkstra), which no order of the vertices can change.
Eigen::VectorXd limited_growth(
  Eigen::VectorXd h, double growth, const Points& points, const AdjacencyList& neighbours)
{
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  for (int i = 0; i < h.size(); ++i)
    open.emplace(h[i], i);
  while (!open.empty())
  {
    const auto [length, i] = open.top();
    open.pop();
    if (length > h[i])
      continue;
    for (const int* j = neighbours.begin(i); j != neighbours.end(i); ++j)
    {
      const double most = length + growth * (points.row(*j) - points.row(i)).norm();
      if (most < h[*j])
      {
        h[*j] = most;
        open.emplace(most, *j);
      }
    }
  }
  return h;
}

double triangles_of(const Eigen::VectorXd& h, const Eigen::VectorXd& area)
{
  return 4 / std::numbers::sqrt3 * area.dot(h.cwiseAbs2().cwiseInverse());
}

}

// The count goes with 1/c², exactly so where the growth isn't limited: one round then.
Eigen::VectorXd wanted_edge_lengths(const SizingLaw& law, const Points& points,
  const AdjacencyList& neighbours, const Eigen::VectorXd& curvature, const Eigen::VectorXd& area,
  int triangles)
{
  constexpr int most_rounds = 20;
  constexpr double close_enough = 1e-3; // of a count; lengths follow its root
  const Eigen::VectorXd shape =
    (curvature.cwiseMax(0).array() + 1 / (law.radius * law.radius)).pow(-law.exponent / 2).matrix();
  double c = std::sqrt(triangles_of(shape, area) / triangles);
  Eigen::VectorXd h;
  for (int round = 0; round < most_rounds; ++round)
  {
    h = limited_growth(c * shape, law.growth, points, neighbours);
    const double ratio = triangles_of(h, area) / triangles;
    if (std::abs(ratio - 1) < close_enough)
      break;
    c *= std::sqrt(ratio);
  }
  return h;
}

Points towards_wanted(
  const Points& points, const Triangles& triangles, const Eigen::VectorXd& edge_lengths)
{
  Points sum = Points::Zero(points.rows(), 3);
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(points.rows());
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
  {
    const int i = triangles(t, 0), j = triangles(t, 1), k = triangles(t, 2);
    const Row3 a = points.row(i), b = points.row(j), c = points.row(k), centroid = (a + b + c) / 3;
    const double h = (edge_lengths[i] + edge_lengths[j] + edge_lengths[k]) / 3,
                 weight = 0.5 * (b - a).cross(c - a).norm() / (h * h * h);
    for (const int vertex : { i, j, k })
    {
      sum.row(vertex) += weight * (centroid - points.row(vertex));
      weights[vertex] += weight;
    }
  }
  return weights.cwiseInverse().asDiagonal() * sum;
}

}
