#include "solver/mesh/remesh/CurvedSurface.h"

#include "solver/mesh/remesh/FittedNormals.h"

#include <algorithm>
#include <cmath>

namespace vesicle
{

namespace
{
constexpr int most_sides = 64; // pieces along a patch's side: bounds the work on needles
}

CurvedPatches::CurvedPatches(const TriangleMesh& mesh) : mesh_(mesh), normals_(fitted_normals(mesh))
{
}

double CurvedPatches::longest_side(int patch) const
{
  double longest = 0;
  for (int k = 0; k < 3; ++k)
  {
    const int i = mesh_.triangles(patch, k), j = mesh_.triangles(patch, (k + 1) % 3);
    longest = std::max(longest, (mesh_.points.row(i) - mesh_.points.row(j)).norm());
  }
  return longest;
}

/// The cubic with control points at the corners, two an edge in the corners' tangent planes, and
/// one in the middle so placed that quadratics are reproduced (Vlachos et al., section 3.1); the
/// normal is interpolated linearly.
SurfacePoint CurvedPatches::point(int patch, const Vector3& weights) const
{
  Vector3 position = Vector3::Zero(), normal = Vector3::Zero();
  Vector3 corners = Vector3::Zero(), edges = Vector3::Zero();
  for (int k = 0; k < 3; ++k)
  {
    const int i = mesh_.triangles(patch, k);
    const Vector3 x = mesh_.points.row(i);
    const Vector3 n = normals_.row(i);
    const double w = weights[k];
    normal += w * n;
    corners += x / 3;
    position += w * w * w * x;
    for (const int other : { (k + 1) % 3, (k + 2) % 3 })
    {
      const Vector3 y = mesh_.points.row(mesh_.triangles(patch, other));
      const Vector3 control = (2 * x + y - (y - x).dot(n) * n) / 3;
      edges += control / 6;
      position += 3 * w * w * weights[other] * control;
    }
  }
  position += 6 * weights.prod() * (edges + (edges - corners) / 2);
  return { position, normal.normalized() };
}

CurvedSurface::CurvedSurface(const TriangleMesh& mesh, double resolution)
  : patches(mesh), pieces(cut(resolution)), tree(std::move(pieces.mesh), std::move(pieces.facings))
{
}

CurvedSurface::Pieces CurvedSurface::cut(double resolution) const
{
  const int number = static_cast<int>(patches.mesh().triangles.rows());
  std::vector<int> sides(number);
  int points = 0, triangles = 0;
  for (int t = 0; t < number; ++t)
  {
    const double n = std::ceil(patches.longest_side(t) / resolution);
    sides[t] = static_cast<int>(std::clamp(n, 1.0, static_cast<double>(most_sides)));
    points += (sides[t] + 1) * (sides[t] + 2) / 2;
    triangles += sides[t] * sides[t];
  }
  Pieces result{ { Points(points, 3), Triangles(triangles, 3) }, Points(points, 3),
    Points(triangles, 3), std::vector<int>(triangles) };
  points = triangles = 0;
  for (int t = 0; t < number; ++t)
  {
    cut_patch(t, sides[t], points, triangles, result);
  }
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
      cut.mesh.points.row(points++) = patches.point(number, weights).point;
    }
  }
  const auto add = [&](int a, int b, int c)
  {
    const Vector3 middle = (cut.weights.row(a) + cut.weights.row(b) + cut.weights.row(c)) / 3;
    cut.facings.row(triangles) = patches.point(number, middle).normal;
    cut.patch[triangles] = number;
    cut.mesh.triangles.row(triangles++) << a, b, c;
  };
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < n - i; ++j)
    {
      add(id(i, j), id(i + 1, j), id(i, j + 1));
      if (j < n - i - 1)
      {
        add(id(i + 1, j), id(i + 1, j + 1), id(i, j + 1));
      }
    }
  }
}

SurfacePoint CurvedSurface::along(const Vector3& x, const Vector3& direction) const
{
  TriangleTree::Hit hit = tree.along(x, direction);
  if (hit.triangle < 0)
  {
    hit = tree.nearest(x);
  }
  Vector3 weights = Vector3::Zero();
  for (int k = 0; k < 3; ++k)
  {
    weights += hit.weights[k] * pieces.weights.row(tree.mesh().triangles(hit.triangle, k));
  }
  return patches.point(pieces.patch[hit.triangle], weights);
}

std::vector<CurvedSurface::Sample> CurvedSurface::samples() const
{
  const TriangleMesh& flat = tree.mesh();
  std::vector<Sample> result;
  result.reserve(flat.triangles.rows());
  for (int t = 0; t < flat.triangles.rows(); ++t)
  {
    const Vector3 a = flat.points.row(flat.triangles(t, 0)),
                  b = flat.points.row(flat.triangles(t, 1)),
                  c = flat.points.row(flat.triangles(t, 2));
    result.push_back({ (a + b + c) / 3, tree.facings().row(t), (b - a).cross(c - a).norm() / 2,
      patches.mesh().triangles(pieces.patch[t], 0) });
  }
  return result;
}

}
