#include "solver/mesh/shapes/UniformMesh.h"

#include "solver/mesh/shapes/CappedTube.h"
#include "solver/mesh/MeshQuality.h"
#include "solver/mesh/shapes/Shapes.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace vesicle
{

namespace
{
enum class Smoothing
{
  /// Weights are areas: Lloyd's step with the triangles as cells. It leaves triangles a spacing
  /// around the fives with which Loop's surface does best: on the ellipsoid 2:1:1 of 1,280
  /// triangles its bending energy is then 1.4e-5 off, with equal areas 1.1e-4.
  centroids,
  /// Squared areas: more even, which keeps triangles on the rims of flat surfaces.
  equal_areas,
};

double orientation(const Vector3& a, const Vector3& b, const Vector3& c)
{
  return a.dot(b.cross(c));
}

/// One improvement under way: the directions and the points above them.
class Improvement
{
public:
  Improvement(const SphereMesh& mesh, const SphereImage& image)
    : surface(image), mesh(mesh), points(mesh.directions.rows(), 3)
  {
    place();
  }

  void smooth(Smoothing smoothing);
  SphereMesh result() && { return std::move(mesh); }

private:
  Vector3 direction(int i) const { return mesh.directions.row(i); }
  Vector3 point(int i) const { return points.row(i); }
  void place();
  void symmetrise(Points& moved) const;
  Points targets(Smoothing smoothing) const;
  Vector3 pulled_back(int i, const Vector3& displacement) const;
  void move_without_folding(const Points& shift);

  const SphereImage& surface;
  SphereMesh mesh;
  Points points;
};

void Improvement::place()
{
  for (int i = 0; i < points.rows(); ++i)
  {
    points.row(i) = surface(direction(i));
  }
}

/// Averages over the symmetric images, which differ by rounding only: the symmetry doesn't wear
/// off.
void Improvement::symmetrise(Points& moved) const
{
  const Points before = moved;
  for (const Turn& turn : mesh.turns)
  {
    for (int i = 0; i < moved.rows(); ++i)
    {
      moved.row(i) += before.row(turn.image[i]) * turn.rotation;
    }
  }
  moved.rowwise().normalize();
}

/// Where smoothing wants each vertex: the mean of the centres of its triangles, weighted by a power
/// of their areas.
Points Improvement::targets(Smoothing smoothing) const
{
  Points sum = Points::Zero(points.rows(), 3);
  Eigen::VectorXd weight = Eigen::VectorXd::Zero(points.rows());
  for (const auto triangle : mesh.triangles.rowwise())
  {
    const Vector3 a = point(triangle[0]), b = point(triangle[1]), c = point(triangle[2]);
    const double area = (b - a).cross(c - a).norm();
    const double w = smoothing == Smoothing::equal_areas ? area * area : area;
    for (const int i : triangle)
    {
      sum.row(i) += w * (a + b + c) / 3;
      weight[i] += w;
    }
  }
  return sum.array().colwise() / weight.array();
}

/// The change of direction i that moves its point by the tangential part of `displacement`: least
/// squares with the surface's tangents by central differences.
Vector3 Improvement::pulled_back(int i, const Vector3& displacement) const
{
  const double step = 1e-5;
  const Vector3 d = direction(i);
  Eigen::Matrix<double, 3, 2> across;
  across.col(0) = d.unitOrthogonal();
  across.col(1) = d.cross(across.col(0));
  Eigen::Matrix<double, 3, 2> tangents;
  for (int k = 0; k < 2; ++k)
  {
    const Vector3 ahead = (d + step * across.col(k)).normalized();
    const Vector3 behind = (d - step * across.col(k)).normalized();
    tangents.col(k) = (surface(ahead) - surface(behind)) / (2 * step);
  }
  const Eigen::Matrix2d metric = tangents.transpose() * tangents;
  return across * metric.inverse() * (tangents.transpose() * displacement);
}

/// Adds the shift to the directions; where a triangle of directions would fold over, less of it.
void Improvement::move_without_folding(const Points& shift)
{
  Eigen::VectorXd fraction = Eigen::VectorXd::Ones(points.rows());
  for (int attempt = 0; attempt < 8; ++attempt)
  {
    Points moved = mesh.directions + fraction.asDiagonal() * shift;
    moved.rowwise().normalize();
    symmetrise(moved);
    bool folded = false;
    Eigen::VectorXd lower = fraction;
    for (const auto triangle : mesh.triangles.rowwise())
    {
      const Vector3 a = moved.row(triangle[0]), b = moved.row(triangle[1]),
                    c = moved.row(triangle[2]);
      if (orientation(a, b, c) <= 0)
      {
        folded = true;
        for (const int i : triangle)
        {
          lower[i] = attempt < 6 ? fraction[i] / 2 : 0;
        }
      }
    }
    if (!folded)
    {
      mesh.directions = moved;
      break;
    }
    fraction = lower;
  }
  place();
}

void Improvement::smooth(Smoothing smoothing)
{
  const double damping = 0.5; // whole steps overshoot
  const Points goal = targets(smoothing);
  Points shift(points.rows(), 3);
  for (int i = 0; i < points.rows(); ++i)
  {
    shift.row(i) = pulled_back(i, damping * (goal.row(i) - points.row(i)));
  }
  move_without_folding(shift);
}
}

TriangleMesh surface_mesh(const SphereImage& surface, const SphereMesh& mesh)
{
  TriangleMesh result{ Points(mesh.directions.rows(), 3), mesh.triangles };
  for (int i = 0; i < mesh.directions.rows(); ++i)
  {
    result.points.row(i) = surface(mesh.directions.row(i));
  }
  return result;
}

namespace
{
/// What meshes are ranked by: smallest angle over edge ratio, 60 at best.
double score(const SphereMesh& mesh, const SphereImage& surface)
{
  const MeshQuality quality = mesh_quality(surface_mesh(surface, mesh));
  return quality.min_angle_deg / quality.edge_ratio;
}

SphereMesh smoothed(
  const SphereMesh& mesh, const SphereImage& surface, Smoothing smoothing, int passes)
{
  Improvement improvement(mesh, surface);
  for (int pass = 0; pass < passes; ++pass)
  {
    improvement.smooth(smoothing);
  }
  return std::move(improvement).result();
}
}

void improve(SphereMesh& mesh, const SphereImage& surface, int passes)
{
  const double much_better = 1.15;
  SphereMesh even = smoothed(mesh, surface, Smoothing::equal_areas, passes);
  mesh = smoothed(mesh, surface, Smoothing::centroids, passes);
  if (score(even, surface) > much_better * score(mesh, surface))
  {
    mesh = std::move(even);
  }
}

namespace
{
constexpr int most_coarse_triangles = 2000; // coarse enough to try many
constexpr double count_penalty = 30;        // on the score, of a relative deviation
constexpr int trial_passes = 40;
constexpr int finalists = 3;
constexpr int settling_passes = 200;
constexpr int fine_passes = 60;

/// The directions triangulate the sphere.
bool covers_once(const SphereMesh& mesh)
{
  return std::ranges::all_of(mesh.triangles.rowwise(),
    [&](const auto& t)
    {
      return orientation(
               mesh.directions.row(t[0]), mesh.directions.row(t[1]), mesh.directions.row(t[2])) > 0;
    });
}

int nearest_multiple(int of, int number)
{
  return of * static_cast<int>(std::lround(static_cast<double>(number) / of));
}

/// Triangulations with about that number of triangles, around z, with what they share of the
/// surface's symmetry.
std::vector<SphereMesh> triangulations(int triangles, Symmetry symmetry)
{
  const bool half_turns = symmetry == Symmetry::half_turns, none = symmetry == Symmetry::none;
  std::vector<SphereMesh> result;
  const auto add = [&](SphereMesh mesh, int fold)
  {
    if (covers_once(mesh))
    {
      mesh.turns = none ? std::vector<Turn>() : dihedral_turns(mesh, half_turns ? 2 : fold);
      result.push_back(std::move(mesh));
    }
  };
  const int tens = nearest_multiple(10, triangles), twelves = nearest_multiple(12, triangles);
  const bool twelve = half_turns || std::abs(twelves - triangles) < std::abs(tens - triangles);
  for (const CappedTube& tube : capped_tubes(twelve ? twelves : tens))
  {
    if (!half_turns || tube.fold == 6)
    {
      add(capped_tube_mesh(tube), tube.fold);
    }
  }
  const int n = geodesic_frequency(triangles);
  if (half_turns || 20 * n * n == tens || result.empty())
  {
    add(geodesic_sphere_mesh(n), 2);
  }
  return result;
}

/// The triangulations around the surface's axis, or around each that it may be long or flat along.
std::vector<SphereMesh> placed_triangulations(int triangles, Symmetry symmetry)
{
  const bool any_axis = symmetry == Symmetry::none || symmetry == Symmetry::half_turns;
  std::vector<SphereMesh> result;
  for (SphereMesh& mesh : triangulations(triangles, symmetry))
  {
    for (const Symmetry around : { Symmetry::around_z, Symmetry::around_x, Symmetry::around_y })
    {
      if (any_axis || around == symmetry)
      {
        result.push_back(mesh);
      }
      mesh = turned_over(mesh);
    }
  }
  return result;
}

struct Candidate
{
  SphereMesh mesh;
  double merit;
};

/// Smoothes the candidates and sorts them, best first. Where their numbers of triangles differ, one
/// farther off what was asked for counts against them.
void try_out(
  std::vector<Candidate>& candidates, const SphereImage& surface, int triangles, int passes)
{
  for (Candidate& candidate : candidates)
  {
    improve(candidate.mesh, surface, passes);
    const double deviation = static_cast<double>(candidate.mesh.triangles.rows()) / triangles - 1;
    candidate.merit =
      score(candidate.mesh, surface) * std::exp(-count_penalty * std::abs(deviation));
  }
  std::ranges::stable_sort(candidates, std::ranges::greater(), &Candidate::merit);
}

/// Which triangulation suits a surface shows when it lies there.
SphereMesh best_coarse_mesh(const SphereImage& surface, int triangles, Symmetry symmetry)
{
  std::vector<Candidate> candidates;
  for (SphereMesh& mesh : placed_triangulations(triangles, symmetry))
  {
    candidates.push_back({ std::move(mesh), 0 });
  }
  try_out(candidates, surface, triangles, trial_passes);
  candidates.resize(std::min<std::size_t>(candidates.size(), finalists));
  try_out(candidates, surface, triangles, settling_passes);
  return std::move(candidates.front().mesh);
}
}

SphereMesh uniform_mesh(const SphereImage& surface, int triangles, Symmetry symmetry)
{
  int halvings = 0;
  while (triangles > most_coarse_triangles)
  {
    triangles /= 4;
    ++halvings;
  }
  SphereMesh mesh = best_coarse_mesh(surface, triangles, symmetry);
  for (; halvings > 0; --halvings)
  {
    mesh = cut_in_four(mesh);
    improve(mesh, surface, fine_passes);
  }
  return mesh;
}

}
