#include "solver/mesh/remesh/SurfaceSmoother.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vesicle
{

namespace
{
constexpr int pieces_per_edge = 4; // of the surface: 30 or so to each vertex
/// Edges steeper than the first begin to feel a tip or rim, those steeper than the second don't
/// resolve it (a radius of curvature is 2.5 or 1.25 edges then).
constexpr double resolved = 0.2, unresolved = 0.4;

int vertices(const DraftMesh& draft)
{
  return static_cast<int>(draft.points.rows());
}

/// Area-weighted means over what belongs to each vertex.
class Means
{
public:
  explicit Means(int vertices)
    : points(Points::Zero(vertices, 3)), normals(Points::Zero(vertices, 3)),
      areas(Eigen::VectorXd::Zero(vertices))
  {
  }
  void add(int i, double area, const Vector3& point, const Vector3& normal)
  {
    points.row(i) += area * point;
    normals.row(i) += area * normal;
    areas[i] += area;
  }
  bool empty(int i) const { return areas[i] == 0; }
  Vector3 point(int i) const { return points.row(i) / areas[i]; }
  Vector3 normal(int i) const { return normals.row(i) / areas[i]; }

private:
  Points points;
  Points normals;
  Eigen::VectorXd areas;
};

/// Of the surface nearest to each vertex.
Means cells(const std::vector<CurvedSurface::Sample>& samples, const DraftMesh& draft)
{
  Means means(vertices(draft));
  for (std::size_t s = 0; s < samples.size(); ++s)
  {
    means.add(draft.references[s], samples[s].area, samples[s].point, samples[s].normal);
  }
  return means;
}

/// Of the triangles around each vertex.
Means stars(const DraftMesh& draft)
{
  Means means(vertices(draft));
  for (const auto triangle : draft.triangles.rowwise())
  {
    const Vector3 a = draft.point(triangle[0]), b = draft.point(triangle[1]),
                  c = draft.point(triangle[2]);
    for (const int i : triangle)
    {
      means.add(i, (b - a).cross(c - a).norm() / 2, (a + b + c) / 3, draft.normal(i));
    }
  }
  return means;
}

/// The largest steepness of each vertex' edges.
Eigen::VectorXd steepest(const DraftMesh& draft)
{
  Eigen::VectorXd result = Eigen::VectorXd::Zero(vertices(draft));
  for (const auto triangle : draft.triangles.rowwise())
  {
    for (int k = 0; k < 3; ++k)
    {
      const int i = triangle[k], j = triangle[(k + 1) % 3];
      const double steepness = draft.steepness(i, j);
      result[i] = std::max(result[i], steepness);
      result[j] = std::max(result[j], steepness);
    }
  }
  return result;
}

}

double mean_edge(double area, int triangles)
{
  return std::sqrt(4 * area / (std::numbers::sqrt3 * triangles));
}

Relaxation::Relaxation(const TriangleMesh& input, int triangles)
  : surface_(input, mean_edge(flat_area(input), triangles) / pieces_per_edge),
    samples_(surface_.samples()), input_{ input.points, surface_.vertex_normals(), input.triangles,
      {} }
{
  for (const CurvedSurface::Sample& sample : samples_)
  {
    input_.references.push_back(sample.vertex);
    area_ += sample.area;
  }
}

/// Each sample goes from its vertex on to nearer neighbours as long as there are any: along the
/// mesh, so that it stays on its side of a thin body.
void Relaxation::find_owners(DraftMesh& draft) const
{
  const Connectivity connectivity(draft.triangles, vertices(draft));
  const AdjacencyList& around = connectivity.vertex_neighbours;
  const auto step = [&](const Vector3& x, int from)
  {
    int nearest = from;
    double least = (draft.point(from) - x).squaredNorm();
    for (const int* i = around.begin(from); i != around.end(from); ++i)
    {
      const double squared_distance = (draft.point(*i) - x).squaredNorm();
      nearest = squared_distance < least ? *i : nearest;
      least = std::min(least, squared_distance);
    }
    return nearest;
  };
  tbb::parallel_for(std::size_t(0), samples_.size(),
    [&](std::size_t s)
    {
      int& owner = draft.references[s];
      for (int next = step(samples_[s].point, owner); next != owner;
           next = step(samples_[s].point, owner))
      {
        owner = next;
      }
    });
}

void Relaxation::relax(DraftMesh& draft) const
{
  find_owners(draft);
  const Means cell = cells(samples_, draft), star = stars(draft);
  const Eigen::VectorXd steepness = steepest(draft);
  Points targets(vertices(draft), 3), directions(vertices(draft), 3);
  for (int i = 0; i < vertices(draft); ++i)
  {
    targets.row(i) = star.point(i);
    directions.row(i) = draft.normals.row(i);
    const double w = std::clamp((steepness[i] - resolved) / (unresolved - resolved), 0.0, 1.0);
    if (w > 0 && !cell.empty(i))
    {
      targets.row(i) = (1 - w) * star.point(i) + w * cell.point(i);
      directions.row(i) = (1 - w) * draft.normal(i) + w * cell.normal(i);
    }
  }
  move_without_folding(draft, targets, directions);
}

/// Moves the vertices to the surface above or below the targets; where a triangle would fold over,
/// part of the way or not at all.
void Relaxation::move_without_folding(
  DraftMesh& draft, const Points& targets, const Points& directions) const
{
  const int attempts = 6;
  Eigen::VectorXd fraction = Eigen::VectorXd::Ones(vertices(draft));
  DraftMesh moved = draft;
  for (int attempt = 0; attempt < attempts; ++attempt)
  {
    tbb::parallel_for(0, vertices(draft),
      [&](int i)
      {
        const Vector3 goal = (1 - fraction[i]) * draft.points.row(i) + fraction[i] * targets.row(i);
        const SurfacePoint there = fraction[i] > 0
          ? surface_.along(goal, directions.row(i).normalized())
          : SurfacePoint{ draft.point(i), draft.normal(i) };
        moved.points.row(i) = there.point;
        moved.normals.row(i) = there.normal;
      });
    Eigen::VectorXd lower = fraction;
    for (const auto t : draft.triangles.rowwise())
    {
      if (!moved.faces_outward(t[0], t[1], t[2]))
      {
        for (const int i : t)
        {
          lower[i] = attempt + 2 < attempts ? fraction[i] / 2 : 0;
        }
      }
    }
    if (lower == fraction)
    {
      break;
    }
    fraction = lower;
  }
  draft = std::move(moved);
}
}
