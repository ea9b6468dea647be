#include "solver/mesh/remesh/SemiRegularMesh.h"

#include "solver/mesh/remesh/EdgeEdits.h"
#include "solver/mesh/remesh/IsotropicMesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vesicle
{

namespace
{
constexpr int fewest_triangles = 20; // the icosahedron
/// A closed mesh of genus 0 has at least twelve vertices with five neighbours if none has fewer.
constexpr int fewest_extraordinary = 12;
/// How many vertices of a coarse mesh get five or seven neighbours is chance: several are made.
constexpr double starts[] = { 1, 1.2, 0.8 };
constexpr int passes = 20; // after each cut
/// Triangles of a coarse mesh that doesn't resolve a tip or rim come out flatter, of all shapes
/// tried.
constexpr double least_angle = 38; // degrees

/// The vertices with five or seven neighbours; nothing if there are any with fewer or more.
std::optional<int> extraordinary(const DraftMesh& mesh)
{
  const std::vector<int> valences = mesh.valences();
  const auto off = [&](int by)
  { return std::ranges::count_if(valences, [by](int n) { return std::abs(n - 6) >= by; }); };
  return off(2) > 0 ? std::nullopt : std::optional(static_cast<int>(off(1)));
}

/// The number of triangles to be cut `cuts` times in four, 0 if there is none near enough.
int coarse_count(int triangles, int cuts)
{
  const double pieces = std::pow(4, cuts);
  const int count = 2 * static_cast<int>(std::round(triangles / pieces / 2));
  const bool near = std::abs(count * pieces - triangles) <= allowed_deviation * triangles;
  return near && count >= fewest_triangles ? count : 0;
}

void cut_and_smooth(DraftMesh& mesh, const Relaxation& relaxation, int cuts)
{
  for (int cut = 0; cut < cuts; ++cut)
  {
    cut_in_four(mesh, relaxation.surface());
    for (int pass = 0; pass < passes; ++pass)
    {
      relaxation.relax(mesh);
    }
  }
}

/// Of several meshes with `coarse` triangles, cut so many times, the one with the fewest
/// extraordinary vertices; nothing if none resolves the surface.
std::optional<DraftMesh> best_mesh(const Relaxation& relaxation, int coarse, int cuts)
{
  std::optional<DraftMesh> best;
  int fewest = std::numeric_limits<int>::max();
  for (const double start : starts)
  {
    std::optional<DraftMesh> mesh = isotropic_mesh(relaxation, coarse, MeshGoal::order, start);
    const std::optional<int> count = mesh ? extraordinary(*mesh) : std::nullopt;
    if (count && *count < fewest)
    {
      cut_and_smooth(*mesh, relaxation, cuts);
      if (mesh->least_angle() >= least_angle)
      {
        best = std::move(mesh);
        fewest = *count;
      }
    }
    const bool hopeless = !best && cuts > 0; // a finer one is more likely to do
    if (hopeless || fewest == fewest_extraordinary)
    {
      break;
    }
  }
  return best;
}
}

std::optional<DraftMesh> semi_regular_mesh(const Relaxation& relaxation, int triangles)
{
  int most_cuts = 0;
  while (triangles >> 2 * (most_cuts + 1) >= fewest_triangles)
  {
    ++most_cuts;
  }
  for (int cuts = most_cuts; cuts >= 0; --cuts)
  {
    if (const int coarse = coarse_count(triangles, cuts))
    {
      if (std::optional<DraftMesh> mesh = best_mesh(relaxation, coarse, cuts))
      {
        return mesh;
      }
    }
  }
  return std::nullopt;
}

}
