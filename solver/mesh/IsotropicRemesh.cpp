// Splits, collapses, flips and smoothing along the surface in turn (M. Botsch, L. Kobbelt, Proc.
// Symposium on Geometry Processing 2004, 185–192), brought to an exact number of triangles.
// Smoothing towards the neighbours draws a mesh off tips and rims sharper than its edges, and in
// the end into a thin body: there vertices move to the centroids of the surface that is nearest to
// them instead (S. Lloyd, IEEE Trans. Inf. Theory 28 (1982) 129–137), by which all of it stays
// covered.

#include "solver/mesh/IsotropicRemesh.h"

#include "solver/Errors.h"
#include "solver/mesh/EdgeEdits.h"
#include "solver/mesh/MeshQuality.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vesicle
{

namespace
{
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double long_edge = 4.0 / 3, short_edge = 4.0 / 5; // of the mean (Botsch & Kobbelt)
/// Around a tip much sharper than the edges, cutting them until none is long need never end.
constexpr int split_passes = 4;
constexpr int rounds = 12; // evens out sizes that differ by orders of magnitude
constexpr int polishing_passes = 40;
constexpr int pieces_per_edge = 4; // of the surface: 30 or so to each vertex
/// Edges steeper than the first begin to feel a tip or rim, those steeper than the second don't
/// resolve it (a radius of curvature is 2.5 or 1.25 edges then).
constexpr double resolved = 0.2, unresolved = 0.4;

/// The side of `triangles` equilateral triangles of area `area` in all.
double mean_edge(double area, int triangles)
{
  return std::sqrt(4 * area / (std::numbers::sqrt3 * triangles));
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

class IsotropicRemesh
{
public:
  IsotropicRemesh(const TriangleMesh& input, int triangles);
  void even_out();
  void reach_count();
  void polish();
  TriangleMesh result() const { return { draft.points, draft.triangles }; }

private:
  int triangles() const { return static_cast<int>(draft.triangles.rows()); }
  int vertices() const { return static_cast<int>(draft.points.rows()); }
  void split_and_collapse(double length);
  bool split_some(int most);
  bool collapse_some(int most);

  void relax();
  void find_owners();
  Means cells() const;
  Means stars() const;
  Eigen::VectorXd steepest() const;
  void move_without_folding(const Points& targets, const Points& directions);

  int wanted;
  CurvedSurface surface;
  std::vector<CurvedSurface::Sample> samples; ///< draft.references: the nearest vertex of each
  DraftMesh draft;
  double edge; ///< mean edge length wanted
};

IsotropicRemesh::IsotropicRemesh(const TriangleMesh& input, int triangles)
  : wanted(triangles), surface(input, mean_edge(flat_area(input), triangles) / pieces_per_edge),
    samples(surface.samples()), draft{ input.points, surface.vertex_normals(), input.triangles, {} }
{
  double area = 0;
  for (const CurvedSurface::Sample& sample : samples)
  {
    draft.references.push_back(sample.vertex);
    area += sample.area;
  }
  edge = mean_edge(area, triangles);
}

void IsotropicRemesh::split_and_collapse(double length)
{
  for (int pass = 0; pass < split_passes; ++pass)
  {
    split_edges(draft, surface, long_edge * length);
  }
  while (collapse_edges(draft, short_edge * length, long_edge * length) > 0)
  {
  }
}

void IsotropicRemesh::even_out()
{
  double length = edge;
  for (int round = 0; round < rounds; ++round)
  {
    split_and_collapse(length);
    flip_edges(draft, FlipGoal::valences);
    relax();
    relax();
    length *= std::clamp(std::sqrt(static_cast<double>(triangles()) / wanted), 0.8, 1.25);
  }
}

bool IsotropicRemesh::split_some(int most)
{
  return split_edges(draft, surface, 0, most) > 0;
}

bool IsotropicRemesh::collapse_some(int most)
{
  const double longest = 2 * edge;
  return collapse_edges(draft, infinity, longest, most) > 0 ||
    collapse_edges(draft, infinity, infinity, most) > 0;
}

/// Half of what is too few or too many at a time, each edit being two triangles.
void IsotropicRemesh::reach_count()
{
  while (triangles() != wanted)
  {
    const int most = std::max(1, std::abs(triangles() - wanted) / 4);
    if (!(triangles() < wanted ? split_some(most) : collapse_some(most)))
    {
      throw InputError(fmt::format(
        "the surface can't be meshed with {} triangles (stopped at {}): ask for more triangles",
        wanted, triangles()));
    }
    flip_edges(draft, FlipGoal::valences);
    relax();
  }
}

/// Keeps the best mesh of the later passes, when sizes have settled.
void IsotropicRemesh::polish()
{
  DraftMesh best;
  double best_score = -1;
  for (int pass = 0; pass < polishing_passes; ++pass)
  {
    relax();
    flip_edges(draft, FlipGoal::angles);
    const MeshQuality quality = mesh_quality(result());
    const double score = quality.min_angle_deg / quality.edge_ratio; // 60 at best
    if (pass >= polishing_passes / 2 && score > best_score)
    {
      best_score = score;
      best = draft;
    }
  }
  draft = best;
}

/// Each sample goes from its vertex on to nearer neighbours as long as there are any: along the
/// mesh, so that it stays on its side of a thin body.
void IsotropicRemesh::find_owners()
{
  const Connectivity connectivity(draft.triangles, vertices());
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
  tbb::parallel_for(std::size_t(0), samples.size(),
    [&](std::size_t s)
    {
      int& owner = draft.references[s];
      for (int next = step(samples[s].point, owner); next != owner;
           next = step(samples[s].point, owner))
      {
        owner = next;
      }
    });
}

/// Of the surface nearest to each vertex.
Means IsotropicRemesh::cells() const
{
  Means means(vertices());
  for (std::size_t s = 0; s < samples.size(); ++s)
  {
    means.add(draft.references[s], samples[s].area, samples[s].point, samples[s].normal);
  }
  return means;
}

/// Of the triangles around each vertex.
Means IsotropicRemesh::stars() const
{
  Means means(vertices());
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
Eigen::VectorXd IsotropicRemesh::steepest() const
{
  Eigen::VectorXd result = Eigen::VectorXd::Zero(vertices());
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

/// Moves the vertices to the centroids of their triangles where the mesh resolves the surface, of
/// their cells where it doesn't.
void IsotropicRemesh::relax()
{
  find_owners();
  const Means cell = cells(), star = stars();
  const Eigen::VectorXd steepness = steepest();
  Points targets(vertices(), 3), directions(vertices(), 3);
  for (int i = 0; i < vertices(); ++i)
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
  move_without_folding(targets, directions);
}

/// Moves the vertices to the surface above or below the targets; where a triangle would fold over,
/// part of the way or not at all.
void IsotropicRemesh::move_without_folding(const Points& targets, const Points& directions)
{
  const int attempts = 6;
  Eigen::VectorXd fraction = Eigen::VectorXd::Ones(vertices());
  DraftMesh moved = draft;
  for (int attempt = 0; attempt < attempts; ++attempt)
  {
    tbb::parallel_for(0, vertices(),
      [&](int i)
      {
        const Vector3 goal = (1 - fraction[i]) * draft.points.row(i) + fraction[i] * targets.row(i);
        const SurfacePoint there = fraction[i] > 0
          ? surface.along(goal, directions.row(i).normalized())
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

TriangleMesh isotropic_mesh(const TriangleMesh& input, int triangles)
{
  IsotropicRemesh remesh(input, triangles);
  remesh.even_out();
  remesh.reach_count();
  remesh.polish();
  return remesh.result();
}

}
