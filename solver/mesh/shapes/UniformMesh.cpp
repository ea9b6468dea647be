#include "solver/mesh/shapes/UniformMesh.h"

#include "solver/mesh/MeshQuality.h"
#include "solver/mesh/shapes/CappedTube.h"
#include "solver/mesh/shapes/GeodesicSphere.h"
#include "solver/mesh/shapes/SphereMeshSmoothing.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace vesicle
{

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
      const Vector3 a = mesh.directions.row(t[0]), b = mesh.directions.row(t[1]),
                    c = mesh.directions.row(t[2]);
      return a.dot(b.cross(c)) > 0;
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
      mesh.symmetries =
        none ? std::vector<SymmetryOperation>() : dihedral_symmetries(mesh, half_turns ? 2 : fold);
      result.push_back(std::move(mesh));
    }
  };
  const int tens = nearest_multiple(10, triangles), twelves = nearest_multiple(12, triangles);
  const bool twelve = half_turns || std::abs(twelves - triangles) < std::abs(tens - triangles);
  for (const CappedTube& tube : capped_tubes(twelve ? twelves : tens))
    if (!half_turns || tube.fold == 6)
      add(capped_tube_mesh(tube), tube.fold);
  const int n = geodesic_frequency(triangles);
  if (half_turns || 20 * n * n == tens || result.empty())
    add(geodesic_sphere_mesh(n), 2);
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
        result.push_back(mesh);
      mesh = axes_permuted(mesh);
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
void try_out(std::vector<Candidate>& candidates, const SphericalParametrisation& surface,
  int triangles, int passes)
{
  for (Candidate& candidate : candidates)
  {
    smooth(candidate.mesh, surface, passes);
    const double deviation = static_cast<double>(candidate.mesh.triangles.rows()) / triangles - 1;
    candidate.merit = mesh_quality(mapped(candidate.mesh, surface)).score() *
      std::exp(-count_penalty * std::abs(deviation));
  }
  std::ranges::stable_sort(candidates, std::ranges::greater(), &Candidate::merit);
}

/// Which triangulation suits a surface shows when it lies there.
SphereMesh best_coarse_mesh(
  const SphericalParametrisation& surface, int triangles, Symmetry symmetry)
{
  std::vector<Candidate> candidates;
  for (SphereMesh& mesh : placed_triangulations(triangles, symmetry))
    candidates.push_back({ std::move(mesh), 0 });
  try_out(candidates, surface, triangles, trial_passes);
  candidates.resize(std::min<std::size_t>(candidates.size(), finalists));
  try_out(candidates, surface, triangles, settling_passes);
  return std::move(candidates.front().mesh);
}
}

SphereMesh uniform_mesh(const SphericalParametrisation& surface, int triangles, Symmetry symmetry)
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
    mesh = refined(mesh);
    smooth(mesh, surface, fine_passes);
  }
  return mesh;
}

}
