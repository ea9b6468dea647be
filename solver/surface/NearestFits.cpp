#include "solver/surface/NearestFits.h"

#include "solver/mesh/VertexNormals.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace vesicle
{

namespace
{

// Twice the 14 unknowns of a quartic through the vertex are asked for; on a regular mesh these are
// three rings, of which the weights favour two.
constexpr int fewest_rings = 2, most_rings = 8, wanted_neighbours = 28;
// The two rings of a regular vertex give the local size σ; weights are exp(−decay d²/σ²).
constexpr int size_neighbours = 18;
// On a border one-sided fits of high order amplify errors: the far neighbours must steady them.
constexpr double inner_decay = 4, border_decay = 1;
// Beyond the first ring a neighbour must face roughly as the vertex does, or the surface is no
// height over the tangent plane there.
constexpr double least_normal_cosine = 0.3;

/// Root mean square of the smallest distances, of which the squares are given and reordered.
double local_size(std::vector<double>& squares)
{
  const auto count = std::min<std::ptrdiff_t>(size_neighbours, std::ssize(squares));
  const auto end = squares.begin() + count;
  std::nth_element(squares.begin(), end, squares.end());
  return count > 0
    ? std::sqrt(std::accumulate(squares.begin(), end, 0.) / static_cast<double>(count))
    : 0;
}

/// Fewest neighbours for a fit: with exactly as many as unknowns, terms of order three and four
/// would follow every error.
int needed_neighbours(int degree)
{
  const int unknowns = HeightFit::unknowns(degree);
  return degree <= 1 ? 1 : degree == 2 ? unknowns : unknowns * 5 / 4;
}

}

NearestFits::NearestFits(
  const TriangleMesh& mesh, const Connectivity& connectivity, const std::vector<char>& border)
  : points_(mesh.points), neighbours_(connectivity.vertex_neighbours), border_(border),
    normal_(vertex_normals(mesh.points, mesh.triangles))
{
}

void NearestFits::gather(int i, NeighbourSearch& search) const
{
  search.begin(i, static_cast<int>(points_.rows()));
  search.visit(neighbours_, i, [&](int j) { return !normal_.row(j).isZero(0); });
  const Vector3 normal = normal_.row(i);
  const auto faces_likewise = [&](int j)
  { return normal_.row(j).dot(normal) >= least_normal_cosine; };
  for (std::size_t ring = 1, first = 0; ring < most_rings && first < search.size() &&
       (ring < fewest_rings || search.size() < wanted_neighbours);
       ++ring)
    for (const std::size_t last = search.size(); first < last; ++first)
      search.visit(neighbours_, search.found()[first], faces_likewise);
}

void NearestFits::describe(int i, Workspace& work) const
{
  Patch& patch = work.patch;
  const std::vector<int>& neighbour = work.search.found();
  const auto count = std::ssize(neighbour);
  patch.offset.resize(count, 3);
  work.squares.resize(count);
  for (std::ptrdiff_t k = 0; k < count; ++k)
  {
    patch.offset.row(k) = points_.row(neighbour[k]) - points_.row(i);
    work.squares[k] = patch.offset.row(k).squaredNorm();
  }
  patch.weight = work.squares;
  patch.size = local_size(work.squares);
  const double factor =
    -0.5 * (border_[i] ? border_decay : inner_decay) / (patch.size * patch.size);
  for (double& weight : patch.weight)
    weight = std::exp(factor * weight);
}

int NearestFits::fit(int i, Workspace& work) const
{
  const Vector3 normal = normal_.row(i);
  if (normal.isZero(0))
    return 0; // no triangle, only degenerate ones, or two that cancel
  gather(i, work.search);
  describe(i, work);
  for (int degree = 4; degree >= 1; --degree)
    if (work.patch.count() >= needed_neighbours(degree) &&
      work.fit.compute(work.patch, normal, degree))
      return degree;
  return 0;
}

}
