#include "solver/equilibrium/MeridianMesh.h"

#include "solver/Errors.h"
#include "solver/mesh/SizingLaw.h"
#include "solver/mesh/shapes/CappedTube.h"

#include <Eigen/Geometry>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace vesicle
{

namespace
{

using std::numbers::pi;

constexpr int samples = 1000; // of the meridian
constexpr int fewest_triangles = 60, most_triangles = 100'000;

/// The inner sheet and the neck of a stomatocyte are what its mesh has to follow.
SizingLaw law_of(EquilibriumBranch branch)
{
  SizingLaw law;
  if (branch == EquilibriumBranch::stomatocyte)
    law.exponent = 0.7;
  return law;
}

/// Unevenness of long waves takes as many as there are triangles to be gone; all but stomatocytes start
/// nearly even.
int passes_of(EquilibriumBranch branch, Eigen::Index triangles)
{
  return static_cast<int>(
    static_cast<double>(triangles) * (branch == EquilibriumBranch::stomatocyte ? 0.2 : 0.05));
}

/// Edge lengths along the meridian, and how the triangles are spread over it.
struct Spacing
{
  Eigen::VectorXd length;                     ///< wanted at t = i π/samples
  Eigen::VectorXd share;                      ///< of the triangles, above it
  double largest_around = 0, mean_around = 0; ///< edges of a parallel; mean over the rows

  Spacing(const Meridian& meridian, const SizingLaw& law, int triangles)
  {
    Points points(samples + 1, 3);
    Eigen::VectorXd curvature(samples + 1), area(samples + 1), way(samples + 1);
    AdjacencyList neighbours{ { 0 }, {} };
    for (int i = 0; i <= samples; ++i)
    {
      const Meridian::Point p = meridian.at(i * pi / samples);
      const auto [along, across] = p.curvatures();
      points.row(i) << p.r, 0, p.z;
      curvature[i] = along * along + across * across;
      way[i] = p.speed() * pi / samples;
      area[i] = 2 * pi * p.r * way[i];
      if (i > 0)
        neighbours.item.push_back(i - 1);
      if (i < samples)
        neighbours.item.push_back(i + 1);
      neighbours.start.push_back(static_cast<int>(neighbours.item.size()));
    }
    length = wanted_edge_lengths(law, points, neighbours, curvature, area, triangles);
    share = area.cwiseQuotient(length.cwiseAbs2());
    std::partial_sum(share.begin(), share.end(), share.begin());
    share /= share[samples];
    const Eigen::VectorXd around = 2 * pi * points.col(0).cwiseQuotient(length),
                          rows = way.cwiseQuotient(length);
    largest_around = around.maxCoeff();
    mean_around = around.dot(rows) / rows.sum();
  }

  double length_at(double t) const
  {
    const double s = t / pi * samples;
    const int i = std::clamp(static_cast<int>(s), 0, samples - 1);
    return length[i] + (s - i) * (length[i + 1] - length[i]);
  }
  /// t above which that share of the triangles is.
  double at_share(double wanted) const
  {
    const auto i = std::clamp<std::ptrdiff_t>(
      std::lower_bound(share.begin(), share.end(), wanted) - share.begin(), 1, samples);
    const double part = (wanted - share[i - 1]) / (share[i] - share[i - 1]);
    return (static_cast<double>(i) - 1 + part) * pi / samples;
  }
};

int nearest_multiple(int of, int number)
{
  return of * static_cast<int>(std::lround(static_cast<double>(number) / of));
}

CappedTube tube_for(int triangles, double around)
{
  const int tens = nearest_multiple(10, triangles), twelves = nearest_multiple(12, triangles);
  const auto tubes =
    capped_tubes(std::abs(twelves - triangles) < std::abs(tens - triangles) ? twelves : tens);
  return *std::ranges::min_element(tubes, {},
    [around](const CappedTube& tube)
    { return std::abs(std::log(tube.fold * std::sqrt(tube.T()) / around)); });
}

/// Vertices by t and the azimuth.
struct MeridianVertices
{
  const Meridian& meridian;
  const Spacing& spacing;
  Triangles triangles;
  Eigen::VectorXd t, azimuth;

  /// Those of a mesh of the sphere, from above down: each at the share of the triangles that it has
  /// above it there.
  MeridianVertices(const Meridian& m, const Spacing& s, const SphereMesh& sphere)
    : meridian(m), spacing(s), triangles(sphere.triangles), t(sphere.directions.rows()),
      azimuth(sphere.directions.rows())
  {
    constexpr double same_height = 1e-6, at_pole = 1 - 1e-9;
    const auto height = sphere.directions.col(2);
    const auto count = static_cast<int>(height.size());
    std::vector<int> order(count);
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, std::ranges::greater(), [&](int i) { return height[i]; });
    for (int first = 0, last; first < count; first = last)
    {
      const double z = height[order[first]];
      for (last = first; last < count && height[order[last]] > z - same_height;)
        ++last;
      const double row =
        std::abs(z) < at_pole ? s.at_share((first + last) / 2. / count) : (z > 0 ? 0 : pi);
      for (int i = first; i < last; ++i)
      {
        const int vertex = order[i];
        t[vertex] = row;
        azimuth[vertex] = std::atan2(sphere.directions(vertex, 1), sphere.directions(vertex, 0));
      }
    }
  }

  Points points() const
  {
    Points result(t.size(), 3);
    for (Eigen::Index i = 0; i < t.size(); ++i)
    {
      const Meridian::Point p = meridian.at(t[i]);
      result.row(i) << p.r * std::cos(azimuth[i]), p.r * std::sin(azimuth[i]), p.z;
    }
    return result;
  }

  /// Along the surface to where the sizing law wants them; poles stay.
  void relax()
  {
    constexpr double damping = 0.9, widest_turn = 0.5; // whole steps overshoot
    Eigen::VectorXd lengths(t.size());
    for (Eigen::Index i = 0; i < t.size(); ++i)
      lengths[i] = spacing.length_at(t[i]);
    const Points shift = damping * towards_wanted(points(), triangles, lengths);
    for (Eigen::Index i = 0; i < t.size(); ++i)
    {
      if (t[i] == 0 || t[i] == pi)
        continue;
      const Meridian::Point p = meridian.at(t[i]);
      const Eigen::RowVector2d outward(std::cos(azimuth[i]), std::sin(azimuth[i]));
      const double radial = shift.row(i).head<2>().dot(outward),
                   around = outward[0] * shift(i, 1) - outward[1] * shift(i, 0);
      const double down = (radial * p.r1 + shift(i, 2) * p.z1) / (p.speed() * p.speed());
      constexpr double least_part = 0.2; // of the way to a pole is left
      t[i] = std::clamp(t[i] + down, least_part * t[i], pi - least_part * (pi - t[i]));
      if (std::abs(around) < widest_turn * p.r)
        azimuth[i] += around / p.r;
    }
  }
};

}

TriangleMesh meridian_mesh(const Meridian& meridian, EquilibriumBranch branch, int triangles)
{
  if (triangles < fewest_triangles || triangles > most_triangles)
    throw InputError(fmt::format("triangles = {}: an equilibrium is searched on {} to {}",
      triangles, fewest_triangles, most_triangles));
  const Spacing spacing(meridian, law_of(branch), triangles);
  const double around =
    branch == EquilibriumBranch::stomatocyte ? spacing.mean_around : spacing.largest_around;
  MeridianVertices vertices(meridian, spacing, capped_tube_mesh(tube_for(triangles, around)));
  const int passes = passes_of(branch, vertices.triangles.rows());
  for (int pass = 0; pass < passes; ++pass)
    vertices.relax();
  return { vertices.points(), vertices.triangles };
}

}
