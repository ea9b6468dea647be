#include "solver/mesh/remesh/EdgeFlips.h"

#include "solver/mesh/HalfEdgeMesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vesicle
{

namespace
{
constexpr int least_valence = 4;
constexpr int largest_valence = 8;
/// Edges steeper than this go around a tip or rim that the mesh doesn't resolve.
constexpr double steep = 0.5;
/// Edges that flip for the valences' sake face more: the flipped edge may face 1.4 π, not more.
constexpr double obtuse = 0.6 * std::numbers::pi;

double angle(const Vector3& at, const Vector3& left, const Vector3& right)
{
  const Vector3 u = left - at;
  const Vector3 w = right - at;
  return std::atan2(u.cross(w).norm(), u.dot(w));
}

class Flips
{
public:
  explicit Flips(EditableMesh& mesh)
    : mesh_(mesh), half_edges_(mesh.triangles, static_cast<int>(mesh.points.rows()))
  {
  }
  bool round(FlipGoal goal);
  void glide(std::mt19937& random);
  void apply() { mesh_.triangles = half_edges_.triangles(); }

private:
  int valence_gain(int h) const;
  double facing_angles(int h) const;
  double steepness_gain(int h) const;
  bool wants(int h, FlipGoal goal) const;
  bool may(int h) const;

  EditableMesh& mesh_;
  HalfEdgeMesh half_edges_;
};

/// By how much a flip lowers the sum of (valence − 6)² over the four vertices.
int Flips::valence_gain(int h) const
{
  const auto excess = [&](int vertex) { return half_edges_.valence(vertex) - 6; };
  const int a = excess(half_edges_.from(h)), b = excess(half_edges_.to(h));
  const int c = excess(half_edges_.apex(h)), d = excess(half_edges_.apex(half_edges_.twin(h)));
  return 2 * (a + b - c - d) - 4;
}

/// The sum of the two angles that face the edge: over π Delaunay flips it.
double Flips::facing_angles(int h) const
{
  const Vector3 a = mesh_.point(half_edges_.from(h)), b = mesh_.point(half_edges_.to(h));
  return angle(mesh_.point(half_edges_.apex(h)), a, b) +
    angle(mesh_.point(half_edges_.apex(half_edges_.twin(h))), a, b);
}

/// What a flip gains in following a sharp rim or tip: by how much the edge is too steep, before
/// less after. In radians nearly, so that it counts as angles do.
double Flips::steepness_gain(int h) const
{
  const auto excess = [&](int a, int b) { return std::max(0.0, mesh_.steepness(a, b) - steep); };
  return excess(half_edges_.from(h), half_edges_.to(h)) -
    excess(half_edges_.apex(h), half_edges_.apex(half_edges_.twin(h)));
}

bool Flips::wants(int h, FlipGoal goal) const
{
  const double margin = 1e-6; // rounding shan't decide in symmetric quadrilaterals
  const int worst_gain = -8;  // a flip among vertices with six neighbours each has −4
  const double steeper = steepness_gain(h);
  const int gain = valence_gain(h);
  if (goal == FlipGoal::valences)
    return gain > 0 && steeper >= 0 && facing_angles(h) > obtuse;
  return facing_angles(h) + steeper > std::numbers::pi + margin && gain > worst_gain;
}

bool Flips::may(int h) const
{
  const int a = half_edges_.from(h), b = half_edges_.to(h), c = half_edges_.apex(h),
            d = half_edges_.apex(half_edges_.twin(h));
  return half_edges_.valence(a) > least_valence && half_edges_.valence(b) > least_valence &&
    half_edges_.valence(c) < largest_valence && half_edges_.valence(d) < largest_valence &&
    half_edges_.find(c, d) < 0 && mesh_.faces_outward(a, d, c) && mesh_.faces_outward(d, b, c);
}

void Flips::glide(std::mt19937& random)
{
  const int one_in = 4; // too many at once don't get far
  const double allowed_steepening = 0.05;
  for (int h = 0; h < half_edges_.half_edges(); ++h)
    if (half_edges_.twin(h) > h && valence_gain(h) == 0 && facing_angles(h) > obtuse &&
      steepness_gain(h) >= -allowed_steepening && may(h) && random() % one_in == 0)
      half_edges_.flip(h);
}

bool Flips::round(FlipGoal goal)
{
  bool changed = false;
  for (int h = 0; h < half_edges_.half_edges(); ++h)
  {
    if (half_edges_.twin(h) > h && wants(h, goal) && may(h))
    {
      half_edges_.flip(h);
      changed = true;
    }
  }
  return changed;
}
}

void flip_edges(EditableMesh& mesh, FlipGoal goal)
{
  const int rounds = 10; // flips limited by the valence might go round in circles
  Flips flips(mesh);
  for (int round = 0; round < rounds && flips.round(goal); ++round)
  {
  }
  flips.apply();
}

void glide_dislocations(EditableMesh& mesh, std::mt19937& random)
{
  Flips flips(mesh);
  flips.glide(random);
  flips.apply();
}

}
