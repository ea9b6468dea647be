// Splits, collapses, flips and smoothing along the surface in turn (M. Botsch, L. Kobbelt, Proc.
// Symposium on Geometry Processing 2004, 185–192), brought to an exact number of triangles.

#include "solver/mesh/remesh/IsotropicMesh.h"

#include "solver/mesh/remesh/EdgeEdits.h"
#include "solver/mesh/MeshQuality.h"

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
constexpr int polishing_passes = 40;

/// The sum of (valence − 6)²: twelve at least on a closed mesh of genus 0.
int disorder(const DraftMesh& mesh)
{
  int result = 0;
  for (const int valence : mesh.valences())
  {
    result += (valence - 6) * (valence - 6);
  }
  return result;
}

class IsotropicRemesh
{
public:
  IsotropicRemesh(const Relaxation& relaxation, int triangles)
    : relaxation(relaxation), wanted(triangles), draft(relaxation.input()),
      edge(mean_edge(relaxation.area(), triangles))
  {
  }
  void even_out(double start);
  bool reach_count();
  void annihilate();
  void polish();
  DraftMesh result() && { return std::move(draft); }

private:
  int triangles() const { return static_cast<int>(draft.triangles.rows()); }
  void split_and_collapse(double length);
  bool split_some(int most);
  bool collapse_some(int most);

  const Relaxation& relaxation;
  int wanted;
  DraftMesh draft;
  double edge; ///< mean edge length wanted
};

void IsotropicRemesh::split_and_collapse(double length)
{
  for (int pass = 0; pass < split_passes; ++pass)
  {
    split_edges(draft, relaxation.surface(), long_edge * length);
  }
  while (collapse_edges(draft, short_edge * length, long_edge * length) > 0)
  {
  }
}

void IsotropicRemesh::even_out(double start)
{
  double length = start * edge;
  for (int round = 0; round < rounds; ++round)
  {
    split_and_collapse(length);
    flip_edges(draft, FlipGoal::valences);
    relaxation.relax(draft);
    relaxation.relax(draft);
    length *= std::clamp(std::sqrt(static_cast<double>(triangles()) / wanted), 0.8, 1.25);
  }
}

bool IsotropicRemesh::split_some(int most)
{
  return split_edges(draft, relaxation.surface(), 0, most) > 0;
}

bool IsotropicRemesh::collapse_some(int most)
{
  const double longest = 2 * edge;
  return collapse_edges(draft, infinity, longest, most) > 0 ||
    collapse_edges(draft, infinity, infinity, most) > 0;
}

/// Half of what is too few or too many at a time, each edit being two triangles.
bool IsotropicRemesh::reach_count()
{
  while (triangles() != wanted)
  {
    const int most = std::max(1, std::abs(triangles() - wanted) / 4);
    if (!(triangles() < wanted ? split_some(most) : collapse_some(most)))
    {
      return false;
    }
    flip_edges(draft, FlipGoal::valences);
    relaxation.relax(draft);
  }
  return true;
}

/// A pair of neighbours with five and seven neighbours is a dislocation of the triangulation: it
/// wanders until it meets an opposite one and both vanish.
void IsotropicRemesh::annihilate()
{
  std::mt19937 random(1);
  DraftMesh best = draft;
  int least = disorder(draft);
  for (int pass = 0; pass < gliding_passes; ++pass)
  {
    glide_edges(draft, random);
    flip_edges(draft, FlipGoal::valences);
    relaxation.relax(draft);
    const int reached = disorder(draft);
    if (reached < least)
    {
      least = reached;
      best = draft;
    }
  }
  draft = std::move(best);
}

/// Keeps the best mesh of the later passes, when sizes have settled.
void IsotropicRemesh::polish()
{
  DraftMesh best;
  double best_score = -1;
  for (int pass = 0; pass < polishing_passes; ++pass)
  {
    relaxation.relax(draft);
    flip_edges(draft, FlipGoal::angles);
    const MeshQuality quality = mesh_quality({ draft.points, draft.triangles });
    const double score = quality.min_angle_deg / quality.edge_ratio; // 60 at best
    if (pass >= polishing_passes / 2 && score > best_score)
    {
      best_score = score;
      best = draft;
    }
  }
  draft = std::move(best);
}
}

std::optional<DraftMesh> isotropic_mesh(
  const Relaxation& relaxation, int triangles, MeshGoal goal, double start)
{
  IsotropicRemesh remesh(relaxation, triangles);
  remesh.even_out(start);
  if (!remesh.reach_count())
  {
    return std::nullopt;
  }
  if (goal == MeshGoal::order)
  {
    remesh.annihilate();
  }
  remesh.polish();
  return std::move(remesh).result();
}

}
