#include "solver/mesh/Remesh.h"

#include "solver/mesh/FlippableMesh.h"
#include "solver/mesh/MeshQuality.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace vesicle
{

namespace
{
enum class Smoothing
{
  centroids,   // full steps: untangles and rounds the triangles
  equal_areas, // damped steps towards triangles of equal area
};

constexpr int least_valence = 4;
constexpr int largest_valence = 8;

double orientation(const Vector3& a, const Vector3& b, const Vector3& c)
{
  return a.dot(b.cross(c));
}

double angle(const Vector3& at, const Vector3& left, const Vector3& right)
{
  const Vector3 u = left - at;
  const Vector3 w = right - at;
  return std::atan2(u.cross(w).norm(), u.dot(w));
}

template<typename T>
bool all_different(std::vector<T> items)
{
  std::ranges::sort(items);
  return std::ranges::adjacent_find(items) == items.end();
}

/// One improvement under way: the triangulation, its directions and the points above them.
class Improvement
{
public:
  Improvement(const SphereMesh& mesh, const SphereImage& image)
    : surface(image), half_turns(mesh.half_turns), directions(mesh.directions),
      points(mesh.directions.rows(), 3),
      mesh(mesh.triangles, static_cast<int>(mesh.directions.rows()))
  {
    place();
  }

  void smooth(Smoothing smoothing);
  bool flip_edges();
  SphereMesh result() && { return { std::move(directions), mesh.triangles(), half_turns }; }

private:
  Vector3 direction(int i) const { return directions.row(i); }
  Vector3 point(int i) const { return points.row(i); }
  void place();
  void symmetrise(Points& moved) const;
  Points targets(int area_power) const;
  Vector3 pulled_back(int i, const Vector3& displacement) const;
  void move_without_folding(const Points& shift);

  bool wants_flip(int h) const;
  bool may_flip(int h) const;
  std::optional<std::vector<int>> images(int h) const;

  const SphereImage& surface;
  std::vector<std::vector<int>> half_turns;
  Points directions;
  Points points;
  FlippableMesh mesh;
};

void Improvement::place()
{
  for (int i = 0; i < directions.rows(); ++i)
  {
    points.row(i) = surface(direction(i));
  }
}

/// Averages over the symmetric images, which differ by rounding only: the symmetry doesn't wear
/// off.
void Improvement::symmetrise(Points& moved) const
{
  const Points before = moved;
  for (int i = 0; i < moved.rows() && !half_turns.empty(); ++i)
  {
    Vector3 sum = before.row(i);
    for (int axis = 0; axis < 3; ++axis)
    {
      sum += half_turn(before.row(half_turns[axis][i]), axis);
    }
    moved.row(i) = sum.normalized();
  }
}

/// Where smoothing wants each vertex: the mean of the centres of its triangles, weighted by a power
/// of their areas. The power 1 (Lloyd's step with the triangles as cells) is the one that
/// untangles; 2 pulls harder towards large triangles, hence towards equal areas, but overshoots
/// unless damped.
Points Improvement::targets(int area_power) const
{
  Points sum = Points::Zero(points.rows(), 3);
  Eigen::VectorXd weight = Eigen::VectorXd::Zero(points.rows());
  for (const auto triangle : mesh.triangles().rowwise())
  {
    const Vector3 a = point(triangle[0]), b = point(triangle[1]), c = point(triangle[2]);
    const double area = (b - a).cross(c - a).norm();
    const double w = area_power == 2 ? area * area : area;
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
  Eigen::VectorXd fraction = Eigen::VectorXd::Ones(directions.rows());
  for (int attempt = 0; attempt < 8; ++attempt)
  {
    Points moved = directions + fraction.asDiagonal() * shift;
    moved.rowwise().normalize();
    symmetrise(moved);
    bool folded = false;
    Eigen::VectorXd lower = fraction;
    for (const auto triangle : mesh.triangles().rowwise())
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
      directions = moved;
      break;
    }
    fraction = lower;
  }
  place();
}

void Improvement::smooth(Smoothing smoothing)
{
  const bool equalise = smoothing == Smoothing::equal_areas;
  const Points goal = targets(equalise ? 2 : 1);
  const double damping = equalise ? 0.5 : 1;
  Points shift(points.rows(), 3);
  for (int i = 0; i < points.rows(); ++i)
  {
    shift.row(i) = pulled_back(i, damping * (goal.row(i) - points.row(i)));
  }
  move_without_folding(shift);
}

/// Delaunay's criterion on the two flat triangles: the angles facing the edge sum up to more than
/// π. The margin keeps flips from chasing rounding errors in symmetric quadrilaterals.
bool Improvement::wants_flip(int h) const
{
  const double margin = 1e-6;
  const int g = mesh.twin(h);
  const Vector3 a = point(mesh.from(h)), b = point(mesh.to(h));
  return angle(point(mesh.apex(h)), a, b) + angle(point(mesh.apex(g)), a, b) >
    std::numbers::pi + margin;
}

bool Improvement::may_flip(int h) const
{
  const int a = mesh.from(h), b = mesh.to(h), c = mesh.apex(h), d = mesh.apex(mesh.twin(h));
  return mesh.valence(a) > least_valence && mesh.valence(b) > least_valence &&
    mesh.valence(c) < largest_valence && mesh.valence(d) < largest_valence && mesh.find(c, d) < 0 &&
    orientation(direction(a), direction(d), direction(c)) > 0 &&
    orientation(direction(d), direction(b), direction(c)) > 0;
}

/// The half-edge and its images under the half turns, each edge once; nothing if two of them share
/// a triangle or a would-be edge, so that they can't all flip.
std::optional<std::vector<int>> Improvement::images(int h) const
{
  std::vector<int> result{ h };
  for (const std::vector<int>& turned : half_turns)
  {
    const int image = mesh.find(turned[mesh.from(h)], turned[mesh.to(h)]);
    if (std::ranges::none_of(result, [&](int g) { return g == image || g == mesh.twin(image); }))
    {
      result.push_back(image);
    }
  }
  std::vector<int> triangles;
  std::vector<std::array<int, 2>> diagonals;
  for (const int g : result)
  {
    const int t = mesh.twin(g);
    triangles.insert(triangles.end(), { g / 3, t / 3 });
    const auto [low, high] = std::minmax({ mesh.apex(g), mesh.apex(t) });
    diagonals.push_back({ low, high });
  }
  return all_different(triangles) && all_different(diagonals) ? std::optional(result)
                                                              : std::nullopt;
}

bool Improvement::flip_edges()
{
  bool changed = false;
  for (int h = 0; h < mesh.half_edges(); ++h)
  {
    if (mesh.twin(h) < h || !wants_flip(h) || !may_flip(h))
    {
      continue;
    }
    if (const auto edges = images(h))
    {
      for (const int g : *edges)
      {
        mesh.flip(g);
      }
      changed = true;
    }
  }
  return changed;
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
SphereMesh smoothed(
  const SphereMesh& mesh, const SphereImage& surface, Smoothing smoothing, int passes)
{
  const int flip_rounds = 10; // flips limited by the valence might go round in circles
  Improvement improvement(mesh, surface);
  for (int pass = 0; pass < passes; ++pass)
  {
    improvement.smooth(smoothing);
    for (int round = 0; round < flip_rounds && improvement.flip_edges(); ++round)
    {
    }
  }
  return std::move(improvement).result();
}

/// What candidates are ranked by: smallest angle over edge ratio, 60 at best.
double score(const SphereMesh& mesh, const SphereImage& surface)
{
  const MeshQuality quality = mesh_quality(surface_mesh(surface, mesh));
  return quality.min_angle_deg / quality.edge_ratio;
}

/// Keeps the best of the meshes offered.
class Contest
{
public:
  explicit Contest(const SphereImage& surface) : surface(surface) {}
  void offer(SphereMesh mesh)
  {
    const double offered = score(mesh, surface);
    if (best.directions.rows() == 0 || offered > best_score)
    {
      best_score = offered;
      best = std::move(mesh);
    }
  }
  SphereMesh winner() && { return std::move(best); }

private:
  const SphereImage& surface;
  SphereMesh best;
  double best_score = 0;
};
}

void improve(SphereMesh& mesh, const SphereImage& surface, int passes)
{
  Contest contest(surface);
  for (const Smoothing smoothing : { Smoothing::equal_areas, Smoothing::centroids })
  {
    contest.offer(smoothed(mesh, surface, smoothing, passes));
  }
  mesh = std::move(contest).winner();
}

namespace
{
constexpr int coarse_frequency = 4; // 320 triangles: coarse enough to try several ways
constexpr int coarse_passes = 20;
constexpr int fine_passes = 30;

/// Turns the mesh by 90° about z, which maps half turns onto half turns.
SphereMesh quarter_turned(SphereMesh mesh)
{
  mesh.directions.col(0).swap(mesh.directions.col(1));
  mesh.directions.col(0) *= -1;
  if (!mesh.half_turns.empty())
  {
    std::swap(mesh.half_turns[0], mesh.half_turns[1]);
  }
  return mesh;
}

/// Cuts and smoothes, `halvings` times.
SphereMesh refined(SphereMesh mesh, const SphereImage& surface, int halvings)
{
  for (int level = 0; level < halvings; ++level)
  {
    mesh = cut_in_four(mesh);
    improve(mesh, surface, fine_passes);
  }
  return mesh;
}

/// Smoothes a geodesic sphere into place: coarse triangles of a slender surface have to be
/// untangled first.
SphereMesh settled(const SphereMesh& start, const SphereImage& surface, int untangling)
{
  SphereMesh mesh = smoothed(start, surface, Smoothing::centroids, untangling);
  improve(mesh, surface, coarse_passes);
  return mesh;
}

/// Which edges of a slender shape flip hangs on details, so that several ways to a coarse mesh are
/// tried: two frequencies, two orientations, two durations.
SphereMesh best_coarse_mesh(const SphereImage& surface, int n, bool symmetric)
{
  Contest contest(surface);
  for (int halvings = 0; halvings <= 1 && n % (1 << halvings) == 0; ++halvings)
  {
    const SphereMesh sphere = geodesic_sphere_mesh(n >> halvings, symmetric);
    for (const SphereMesh& start : { sphere, quarter_turned(sphere) })
    {
      for (const int untangling : { coarse_passes, 5 * coarse_passes })
      {
        contest.offer(refined(settled(start, surface, untangling), surface, halvings));
      }
    }
  }
  return std::move(contest).winner();
}
}

SphereMesh uniform_mesh(const SphereImage& surface, int n, bool symmetric)
{
  int halvings = 0;
  while (n % 2 == 0 && n > coarse_frequency)
  {
    n /= 2;
    ++halvings;
  }
  return refined(best_coarse_mesh(surface, n, symmetric), surface, halvings);
}

}
