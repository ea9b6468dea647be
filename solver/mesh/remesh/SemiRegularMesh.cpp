#include "solver/mesh/remesh/SemiRegularMesh.h"

#include "solver/mesh/remesh/EdgeSplits.h"
#include "solver/mesh/remesh/IsotropicMesh.h"
#include "solver/mesh/remesh/TriangleCount.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vesicle
{

namespace
{
/// A closed mesh of genus 0 has at least twelve vertices with five neighbours if none has fewer.
constexpr int fewest_extraordinary = 12;
/// How many vertices of a coarse mesh get five or seven neighbours is chance: several are made.
constexpr double starts[] = { 1, 1.2, 0.8 };
constexpr int smoothing_passes = 20; // after each refinement
/// Triangles of a coarse mesh that doesn't resolve a tip or rim come out flatter, of all shapes
/// tried.
constexpr double even_angle = 38; // degrees

/// The vertices with five or seven neighbours; nothing if there are any with fewer or more.
std::optional<int> extraordinary(const EditableMesh& mesh)
{
  const std::vector<int> valences = mesh.valences();
  const auto off = [&](int by)
  { return std::ranges::count_if(valences, [by](int n) { return std::abs(n - 6) >= by; }); };
  return off(2) > 0 ? std::nullopt : std::optional(static_cast<int>(off(1)));
}

/// The number of triangles that is to be refined so many times, 0 if there is none near enough.
int coarse_count(int triangles, int refinements)
{
  const double pieces = std::pow(4, refinements);
  const int count = 2 * static_cast<int>(std::round(triangles / pieces / 2));
  const bool near = std::abs(count * pieces - triangles) <= allowed_deviation * triangles;
  return near && count >= fewest_triangles ? count : 0;
}

void refine_and_smooth(EditableMesh& mesh, const SurfaceSmoother& smoother, int refinements)
{
  const SurfaceProjection surface = [&](const Vector3& x, const Vector3& direction)
  { return smoother.project_along(x, direction); };
  for (int level = 0; level < refinements; ++level)
  {
    refine(mesh, surface);
    for (int pass = 0; pass < smoothing_passes; ++pass)
      smoother.smooth(mesh);
  }
}

/// Of several meshes with `coarse` triangles, refined so many times, the one with the fewest
/// extraordinary vertices; nothing if none resolves the surface.
std::optional<EditableMesh> best_mesh(const SurfaceSmoother& smoother, int coarse, int refinements)
{
  std::optional<EditableMesh> best;
  int fewest = std::numeric_limits<int>::max();
  for (const double start : starts)
  {
    std::optional<EditableMesh> mesh =
      isotropic_mesh(smoother, coarse, MeshGoal::regularity, start);
    const std::optional<int> count = mesh ? extraordinary(*mesh) : std::nullopt;
    if (count && *count < fewest)
    {
      refine_and_smooth(*mesh, smoother, refinements);
      if (mesh->quality().min_angle_deg >= even_angle)
      {
        best = std::move(mesh);
        fewest = *count;
      }
    }
    const bool hopeless = !best && refinements > 0; // a finer one is more likely to do
    if (hopeless || fewest == fewest_extraordinary)
      break;
  }
  return best;
}
}

std::optional<EditableMesh> semi_regular_mesh(const SurfaceSmoother& smoother, int triangles)
{
  int most_refinements = 0;
  while (triangles >> 2 * (most_refinements + 1) >= fewest_triangles)
    ++most_refinements;
  for (int refinements = most_refinements; refinements >= 0; --refinements)
  {
    if (const int coarse = coarse_count(triangles, refinements))
    {
      if (std::optional<EditableMesh> mesh = best_mesh(smoother, coarse, refinements))
        return mesh;
    }
  }
  return std::nullopt;
}

}
