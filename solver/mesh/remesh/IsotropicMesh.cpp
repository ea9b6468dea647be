#include "solver/mesh/remesh/IsotropicMesh.h"

#include "solver/mesh/remesh/EdgeCollapses.h"
#include "solver/mesh/remesh/EdgeFlips.h"
#include "solver/mesh/remesh/EdgeSplits.h"
#include "solver/mesh/remesh/TriangleCount.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vesicle
{

namespace
{
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double long_edge = 4.0 / 3, short_edge = 4.0 / 5; // of the mean (Botsch & Kobbelt)
/// Around a tip much sharper than the edges, cutting them until none is long need never end.
constexpr int split_passes = 4;
constexpr int rounds = 12; // evens out sizes that differ by orders of magnitude
constexpr int gliding_passes = 50;
constexpr int angle_passes = 40;

/// The sum of (valence − 6)²: twelve at least on a closed mesh of genus 0.
int irregularity(const EditableMesh& mesh)
{
  int result = 0;
  for (const int valence : mesh.valences())
    result += (valence - 6) * (valence - 6);
  return result;
}

/// Splits, collapses, flips and smoothing along the surface in turn (M. Botsch, L. Kobbelt, Proc.
/// Symposium on Geometry Processing 2004, 185–192), brought to an exact number of triangles.
class IsotropicRemeshing
{
public:
  IsotropicRemeshing(const SurfaceSmoother& smoother, int triangles)
    : smoother_(smoother), wanted_(triangles), mesh_(smoother.input()),
      edge_(equilateral_edge(smoother.area(), triangles))
  {
  }
  void equalise(double start);
  bool reach_count();
  void remove_dislocations();
  void improve_angles();
  EditableMesh result() && { return std::move(mesh_); }

private:
  int triangles() const { return static_cast<int>(mesh_.triangles.rows()); }
  void split_and_collapse(double length);
  int split(double length, int most = std::numeric_limits<int>::max());
  bool split_some(int most);
  bool collapse_some(int most);

  const SurfaceSmoother& smoother_;
  int wanted_;
  EditableMesh mesh_;
  double edge_; ///< mean edge length wanted
};

int IsotropicRemeshing::split(double length, int most)
{
  return split_edges(
    mesh_,
    [&](const Vector3& x, const Vector3& direction)
    { return smoother_.project_along(x, direction); },
    length, most);
}

void IsotropicRemeshing::split_and_collapse(double length)
{
  for (int pass = 0; pass < split_passes; ++pass)
    split(long_edge * length);
  while (collapse_edges(mesh_, short_edge * length, long_edge * length) > 0)
  {
  }
}

void IsotropicRemeshing::equalise(double start)
{
  double length = start * edge_;
  for (int round = 0; round < rounds; ++round)
  {
    split_and_collapse(length);
    flip_edges(mesh_, FlipGoal::valences);
    smoother_.smooth(mesh_);
    smoother_.smooth(mesh_);
    length *= std::clamp(std::sqrt(static_cast<double>(triangles()) / wanted_), 0.8, 1.25);
  }
}

bool IsotropicRemeshing::split_some(int most)
{
  return split(0, most) > 0;
}

bool IsotropicRemeshing::collapse_some(int most)
{
  const double longest = 2 * edge_;
  return collapse_edges(mesh_, infinity, longest, most) > 0 ||
    collapse_edges(mesh_, infinity, infinity, most) > 0;
}

/// Half of what is too few or too many at a time, each edit being two triangles.
bool IsotropicRemeshing::reach_count()
{
  while (triangles() != wanted_)
  {
    const int most = std::max(1, std::abs(triangles() - wanted_) / 4);
    if (!(triangles() < wanted_ ? split_some(most) : collapse_some(most)))
      return false;
    flip_edges(mesh_, FlipGoal::valences);
    smoother_.smooth(mesh_);
  }
  return true;
}

/// A pair of neighbours with five and seven neighbours is a dislocation of the triangulation: it
/// glides until it meets an opposite one and both annihilate.
void IsotropicRemeshing::remove_dislocations()
{
  std::mt19937 random(1);
  EditableMesh best = mesh_;
  int least = irregularity(mesh_);
  for (int pass = 0; pass < gliding_passes; ++pass)
  {
    glide_dislocations(mesh_, random);
    flip_edges(mesh_, FlipGoal::valences);
    smoother_.smooth(mesh_);
    const int reached = irregularity(mesh_);
    if (reached < least)
    {
      least = reached;
      best = mesh_;
    }
  }
  mesh_ = std::move(best);
}

/// Keeps the best mesh of the later passes, when sizes have settled.
void IsotropicRemeshing::improve_angles()
{
  EditableMesh best;
  double best_score = -1;
  for (int pass = 0; pass < angle_passes; ++pass)
  {
    smoother_.smooth(mesh_);
    flip_edges(mesh_, FlipGoal::angles);
    const double score = mesh_.quality().score();
    if (pass >= angle_passes / 2 && score > best_score)
    {
      best_score = score;
      best = mesh_;
    }
  }
  mesh_ = std::move(best);
}
}

std::optional<EditableMesh> isotropic_mesh(
  const SurfaceSmoother& smoother, int triangles, MeshGoal goal, double start)
{
  IsotropicRemeshing remeshing(smoother, triangles);
  remeshing.equalise(start);
  if (!remeshing.reach_count())
    return std::nullopt;
  if (goal == MeshGoal::regularity)
    remeshing.remove_dislocations();
  remeshing.improve_angles();
  return std::move(remeshing).result();
}

}
