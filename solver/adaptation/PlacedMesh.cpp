#include "solver/adaptation/PlacedMesh.h"

#include "solver/mesh/Connectivity.h"
#include "solver/mesh/EdgeUses.h"
#include "solver/mesh/Refinement.h"
#include "solver/mesh/SizingLaw.h"

#include <algorithm>
#include <cmath>

namespace vesicle
{

TriangleMesh mesh_of(const PlacedMesh& mesh, const LimitSurface& surface)
{
  TriangleMesh flat{ Points(std::ssize(mesh.places), 3), mesh.triangles };
  for (Eigen::Index i = 0; i < flat.points.rows(); ++i)
    flat.points.row(i) = surface.at(mesh.places[i]).position.transpose();
  return flat;
}

static double shortest_edge(const Points& points, const AdjacencyList& neighbours, int i)
{
  double shortest = INFINITY;
  for (const int* j = neighbours.begin(i); j != neighbours.end(i); ++j)
    shortest = std::min(shortest, (points.row(*j) - points.row(i)).norm());
  return shortest;
}

// Part of the way, as whole steps overshoot, and no further than part of the shortest edge, so that no
// triangle folds over.
void spread(
  PlacedMesh& mesh, const LimitSurface& surface, const Eigen::VectorXd& edge_lengths, int passes)
{
  constexpr double damping = 0.7, longest = 0.3;
  const auto count = static_cast<int>(mesh.places.size());
  const AdjacencyList neighbours = Connectivity(mesh.triangles, count).vertex_neighbours;
  Eigen::VectorXd h(count);
  for (int pass = 0; pass < passes; ++pass)
  {
    const Points points = mesh_of(mesh, surface).points;
    for (int i = 0; i < count; ++i)
      h[i] = linear(mesh.places[i], surface.mesh().triangles, edge_lengths);
    const Points way = damping * towards_wanted(points, mesh.triangles, h);
    for (int i = 0; i < count; ++i)
    {
      const double most = longest * shortest_edge(points, neighbours, i),
                   length = way.row(i).norm(), part = length > most ? most / length : 1;
      mesh.places[i] = surface.moved(mesh.places[i], part * way.row(i));
    }
  }
}

PlacedMesh refined(const PlacedMesh& mesh, const LimitSurface& surface)
{
  const auto count = static_cast<int>(mesh.places.size());
  const EdgeUses edges(mesh.triangles);
  PlacedMesh fine{ mesh.places, refined(mesh.triangles, edges, count) };
  for (int e = 0; e < edges.size(); ++e)
  {
    const EdgeUse& use = edges[e].front();
    const Vector3 a = surface.at(mesh.places[use.a]).position,
                  b = surface.at(mesh.places[use.b]).position;
    fine.places.push_back(surface.nearest((a + b) / 2, mesh.places[use.a]));
  }
  return fine;
}

bool folds_over(const TriangleMesh& mesh)
{
  const auto facing = [&](int t) -> Vector3
  {
    const auto [a, b, c] = corners(mesh, t);
    return (b - a).cross(c - a);
  };
  const auto across = triangles_across(mesh.triangles);
  for (int t = 0; t < mesh.triangles.rows(); ++t)
    for (const int other : across[t])
      if (facing(t).dot(facing(other)) < 0)
        return true;
  return false;
}

}
