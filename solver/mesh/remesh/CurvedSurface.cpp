#include "solver/mesh/remesh/CurvedSurface.h"

#include <algorithm>
#include <cmath>

namespace vesicle
{

namespace
{
constexpr int most_sides = 64; // pieces along a patch's side: bounds the work on needles
}

CurvedSurface::CurvedSurface(const TriangleMesh& mesh, double resolution)
  : patches_(mesh), pieces_(cut(resolution)),
    tree_(std::move(pieces_.mesh), std::move(pieces_.facings))
{
}

CurvedSurface::Pieces CurvedSurface::cut(double resolution) const
{
  const int number = static_cast<int>(patches_.mesh().triangles.rows());
  std::vector<int> sides(number);
  int points = 0, triangles = 0;
  for (int t = 0; t < number; ++t)
  {
    const double n = std::ceil(patches_.longest_side(t) / resolution);
    sides[t] = static_cast<int>(std::clamp(n, 1.0, static_cast<double>(most_sides)));
    points += (sides[t] + 1) * (sides[t] + 2) / 2;
    triangles += sides[t] * sides[t];
  }
  Pieces result{ { Points(points, 3), Triangles(triangles, 3) }, Points(points, 3),
    Points(triangles, 3), std::vector<int>(triangles) };
  points = triangles = 0;
  for (int t = 0; t < number; ++t)
    cut_patch(t, sides[t], points, triangles, result);
  return result;
}

/// Cuts a patch in n² pieces; `points` and `triangles` count those made so far.
void CurvedSurface::cut_patch(int number, int n, int& points, int& triangles, Pieces& cut) const
{
  const auto id = [first = points, n](int i, int j)
  { return first + i * (n + 1) - i * (i - 1) / 2 + j; };
  for (int i = 0; i <= n; ++i)
  {
    for (int j = 0; j <= n - i; ++j)
    {
      const Vector3 weights = Vector3(n - i - j, i, j) / n;
      cut.weights.row(points) = weights;
      cut.mesh.points.row(points++) = patches_.point(number, weights).point;
    }
  }
  const auto add = [&](int a, int b, int c)
  {
    const Vector3 middle = (cut.weights.row(a) + cut.weights.row(b) + cut.weights.row(c)) / 3;
    cut.facings.row(triangles) = patches_.point(number, middle).normal;
    cut.patch[triangles] = number;
    cut.mesh.triangles.row(triangles++) << a, b, c;
  };
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < n - i; ++j)
    {
      add(id(i, j), id(i + 1, j), id(i, j + 1));
      if (j < n - i - 1)
        add(id(i + 1, j), id(i + 1, j + 1), id(i, j + 1));
    }
  }
}

PointWithNormal CurvedSurface::project_along(const Vector3& x, const Vector3& direction) const
{
  TriangleTree::Hit hit = tree_.intersect(x, direction);
  if (hit.triangle < 0)
    hit = tree_.nearest(x);
  Vector3 weights = Vector3::Zero();
  for (int k = 0; k < 3; ++k)
    weights += hit.weights[k] * pieces_.weights.row(tree_.mesh().triangles(hit.triangle, k));
  return patches_.point(pieces_.patch[hit.triangle], weights);
}

std::vector<CurvedSurface::Sample> CurvedSurface::samples() const
{
  const TriangleMesh& flat = tree_.mesh();
  std::vector<Sample> result;
  result.reserve(flat.triangles.rows());
  for (int t = 0; t < flat.triangles.rows(); ++t)
  {
    const auto [a, b, c] = corners(flat, t);
    result.push_back({ (a + b + c) / 3, tree_.facings().row(t), (b - a).cross(c - a).norm() / 2,
      patches_.mesh().triangles(pieces_.patch[t], 0) });
  }
  return result;
}

}
