#include "solver/mesh/shapes/GeodesicSphere.h"

#include "solver/Errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

namespace vesicle
{

namespace
{
constexpr int largest_frequency = 1000; // 20 million triangles: more is a slip of the pen

// The icosahedron with the coordinate planes as mirrors: (0, ±1, ±φ) and cyclic.
Points icosahedron_corners()
{
  const double phi = std::numbers::phi;
  Points corners(12, 3);
  corners << -1, phi, 0, 1, phi, 0, -1, -phi, 0, 1, -phi, 0, //
    0, -1, phi, 0, 1, phi, 0, -1, -phi, 0, 1, -phi,          //
    phi, 0, -1, phi, 0, 1, -phi, 0, -1, -phi, 0, 1;
  return corners;
}

constexpr std::array<std::array<int, 3>, 20> icosahedron_faces{ { { 0, 11, 5 }, { 0, 5, 1 },
  { 0, 1, 7 }, { 0, 7, 10 }, { 0, 10, 11 }, { 1, 5, 9 }, { 5, 11, 4 }, { 11, 10, 2 }, { 10, 7, 6 },
  { 7, 1, 8 }, { 3, 9, 4 }, { 3, 4, 2 }, { 3, 2, 6 }, { 3, 6, 8 }, { 3, 8, 9 }, { 4, 9, 5 },
  { 2, 4, 11 }, { 6, 2, 10 }, { 8, 6, 7 }, { 9, 8, 1 } } };

/// Numbers the points of all cut faces: a point with weights i, j, k = n − i − j of a face's
/// corners is shared with the neighbouring faces where a weight is zero.
class GeodesicPoints
{
public:
  explicit GeodesicPoints(int frequency) : n_(frequency), points_(10 * frequency * frequency + 2, 3)
  {
  }

  int index(const std::array<int, 3>& face, int i, int j)
  {
    using Weighted = std::pair<int, int>;
    std::array<Weighted, 3> key{ Weighted{ face[0], i }, { face[1], j }, { face[2], n_ - i - j } };
    for (auto& [corner, weight] : key)
      corner = weight == 0 ? -1 : corner;
    std::sort(key.begin(), key.end());
    const auto [entry, is_new] = numbers_.try_emplace(key, static_cast<int>(numbers_.size()));
    if (is_new)
    {
      Vector3 x = Vector3::Zero();
      for (const auto& [corner, weight] : key)
        x += weight > 0 ? Vector3(weight * corners_.row(corner)) : Vector3::Zero();
      points_.row(entry->second) = x.normalized();
    }
    return entry->second;
  }

  Points points() && { return std::move(points_); }

private:
  int n_;
  Points points_;
  Points corners_ = icosahedron_corners();
  std::map<std::array<std::pair<int, int>, 3>, int> numbers_;
};
}

TriangleMesh geodesic_sphere(int n)
{
  if (n < 1 || n > largest_frequency)
  {
    throw InputError(fmt::format(
      "a geodesic sphere has 20 n² triangles with 1 ≤ n ≤ {}, not n = {}", largest_frequency, n));
  }
  GeodesicPoints grid(n);
  Triangles triangles(20 * n * n, 3);
  int t = 0;
  for (const auto& face : icosahedron_faces)
  {
    for (int i = 0; i < n; ++i)
    {
      for (int j = 0; j < n - i; ++j)
      {
        const int a = grid.index(face, i + 1, j);
        const int b = grid.index(face, i, j + 1);
        triangles.row(t++) << a, b, grid.index(face, i, j);
        if (j < n - i - 1)
          triangles.row(t++) << a, grid.index(face, i + 1, j + 1), b;
      }
    }
  }
  return { std::move(grid).points(), std::move(triangles) };
}

int geodesic_frequency(int triangles)
{
  const int below = std::max(1, static_cast<int>(std::sqrt(std::max(0, triangles) / 20.0)));
  const auto distance = [triangles](double n) { return std::abs(20 * n * n - triangles); };
  return distance(below + 1) < distance(below) ? below + 1 : below;
}

}
