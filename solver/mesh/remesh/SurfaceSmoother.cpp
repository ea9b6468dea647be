#include "solver/mesh/remesh/SurfaceSmoother.h"

#include "solver/ParallelFor.h"
#include "solver/mesh/Connectivity.h"
#include "solver/mesh/MeshIntegrals.h"
#include "solver/mesh/remesh/TriangleCount.h"

#include <algorithm>
#include <cmath>

namespace vesicle
{

namespace
{
constexpr int pieces_per_edge = 4; // of the surface: 30 or so to each vertex
/// Edges steeper than the first begin to feel a tip or rim, those steeper than the second don't
/// resolve it (a radius of curvature is 2.5 or 1.25 edges then).
constexpr double resolved = 0.2, unresolved = 0.4;

int vertices(const EditableMesh& mesh)
{
  return static_cast<int>(mesh.points.rows());
}

/// Area-weighted means over what belongs to each vertex.
class Means
{
public:
  explicit Means(int vertices)
    : points_(Points::Zero(vertices, 3)), normals_(Points::Zero(vertices, 3)),
      areas_(Eigen::VectorXd::Zero(vertices))
  {
  }
  void add(int i, double area, const Vector3& point, const Vector3& normal)
  {
    points_.row(i) += area * point;
    normals_.row(i) += area * normal;
    areas_[i] += area;
  }
  bool empty(int i) const { return areas_[i] == 0; }
  Vector3 point(int i) const { return points_.row(i) / areas_[i]; }
  Vector3 normal(int i) const { return normals_.row(i) / areas_[i]; }

private:
  Points points_;
  Points normals_;
  Eigen::VectorXd areas_;
};

/// Of the surface nearest to each vertex.
Means cells(const std::vector<CurvedSurface::Sample>& samples, const EditableMesh& mesh)
{
  Means means(vertices(mesh));
  for (std::size_t s = 0; s < samples.size(); ++s)
    means.add(mesh.references[s], samples[s].area, samples[s].point, samples[s].normal);
  return means;
}

/// Of the triangles around each vertex.
Means stars(const EditableMesh& mesh)
{
  Means means(vertices(mesh));
  for (const auto triangle : mesh.triangles.rowwise())
  {
    const Vector3 a = mesh.point(triangle[0]), b = mesh.point(triangle[1]),
                  c = mesh.point(triangle[2]);
    for (const int i : triangle)
      means.add(i, (b - a).cross(c - a).norm() / 2, (a + b + c) / 3, mesh.normal(i));
  }
  return means;
}

/// The largest steepness of each vertex' edges.
Eigen::VectorXd steepest(const EditableMesh& mesh)
{
  Eigen::VectorXd result = Eigen::VectorXd::Zero(vertices(mesh));
  for (const auto triangle : mesh.triangles.rowwise())
  {
    for (int k = 0; k < 3; ++k)
    {
      const int i = triangle[k], j = triangle[(k + 1) % 3];
      const double steepness = mesh.steepness(i, j);
      result[i] = std::max(result[i], steepness);
      result[j] = std::max(result[j], steepness);
    }
  }
  return result;
}
}

SurfaceSmoother::SurfaceSmoother(const TriangleMesh& input, int triangles)
  : surface_(input, equilateral_edge(flat_area(input), triangles) / pieces_per_edge),
    samples_(surface_.samples()), input_{ input.points, surface_.vertex_normals(), input.triangles,
      {}, {} }
{
  for (const CurvedSurface::Sample& sample : samples_)
  {
    input_.references.push_back(sample.vertex);
    area_ += sample.area;
  }
}

/// Each sample goes from its vertex on to nearer neighbours as long as there are any: along the
/// mesh, so that it stays on its side of a thin body.
void SurfaceSmoother::find_nearest_vertices(EditableMesh& mesh) const
{
  const Connectivity connectivity(mesh.triangles, vertices(mesh));
  const AdjacencyList& around = connectivity.vertex_neighbours;
  const auto step = [&](const Vector3& x, int from)
  {
    int nearest = from;
    double least = (mesh.point(from) - x).squaredNorm();
    for (const int* i = around.begin(from); i != around.end(from); ++i)
    {
      const double squared_distance = (mesh.point(*i) - x).squaredNorm();
      nearest = squared_distance < least ? *i : nearest;
      least = std::min(least, squared_distance);
    }
    return nearest;
  };
  parallel_for(samples_.size(),
    [&](std::size_t s)
    {
      int& nearest = mesh.references[s];
      for (int next = step(samples_[s].point, nearest); next != nearest;
           next = step(samples_[s].point, nearest))
      {
        nearest = next;
      }
    });
}

void SurfaceSmoother::smooth(EditableMesh& mesh) const
{
  find_nearest_vertices(mesh);
  const Means cell = cells(samples_, mesh), star = stars(mesh);
  const Eigen::VectorXd steepness = steepest(mesh);
  Points targets(vertices(mesh), 3), directions(vertices(mesh), 3);
  for (int i = 0; i < vertices(mesh); ++i)
  {
    targets.row(i) = star.point(i);
    directions.row(i) = mesh.normals.row(i);
    const double w = std::clamp((steepness[i] - resolved) / (unresolved - resolved), 0.0, 1.0);
    if (w > 0 && !cell.empty(i))
    {
      targets.row(i) = (1 - w) * star.point(i) + w * cell.point(i);
      directions.row(i) = (1 - w) * mesh.normal(i) + w * cell.normal(i);
    }
  }
  move_without_folding(mesh, targets, directions);
}

/// Moves the vertices to the surface above or below the targets; where a triangle would fold over,
/// part of the way or not at all.
void SurfaceSmoother::move_without_folding(
  EditableMesh& mesh, const Points& targets, const Points& directions) const
{
  const int attempts = 6;
  Eigen::VectorXd fraction = Eigen::VectorXd::Ones(vertices(mesh));
  EditableMesh moved = mesh;
  for (int attempt = 0; attempt < attempts; ++attempt)
  {
    parallel_for(vertices(mesh),
      [&](int i)
      {
        const Vector3 goal = (1 - fraction[i]) * mesh.points.row(i) + fraction[i] * targets.row(i);
        const PointWithNormal there = fraction[i] > 0
          ? surface_.project_along(goal, directions.row(i).normalized())
          : PointWithNormal{ mesh.point(i), mesh.normal(i) };
        moved.points.row(i) = there.point;
        moved.normals.row(i) = there.normal;
      });
    Eigen::VectorXd lower = fraction;
    for (const auto t : mesh.triangles.rowwise())
    {
      if (!moved.faces_outward(t[0], t[1], t[2]))
        for (const int i : t)
          lower[i] = attempt + 2 < attempts ? fraction[i] / 2 : 0;
    }
    if (lower == fraction)
      break;
    fraction = lower;
  }
  mesh = std::move(moved);
}

}
