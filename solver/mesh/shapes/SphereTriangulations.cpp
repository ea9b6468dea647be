#include "solver/mesh/shapes/SphereTriangulations.h"

#include "solver/mesh/shapes/CappedTube.h"
#include "solver/mesh/shapes/GeodesicSphere.h"

#include <algorithm>
#include <cmath>

namespace vesicle
{

namespace
{
constexpr int most_coarse_triangles = 2000; // coarse enough to try many

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

bool turns_over(const SymmetryOperation& operation)
{
  return operation.rotation(2, 2) < 0;
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
      if (symmetry == Symmetry::turns_about_z)
        std::erase_if(mesh.symmetries, turns_over);
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
}

std::vector<SphereMesh> placed_triangulations(int triangles, Symmetry symmetry)
{
  const bool any_axis = symmetry == Symmetry::none || symmetry == Symmetry::half_turns;
  const Symmetry axis = symmetry == Symmetry::turns_about_z ? Symmetry::around_z : symmetry;
  std::vector<SphereMesh> result;
  for (SphereMesh& mesh : triangulations(triangles, symmetry))
  {
    for (const Symmetry around : { Symmetry::around_z, Symmetry::around_x, Symmetry::around_y })
    {
      if (any_axis || around == axis)
        result.push_back(mesh);
      mesh = axes_permuted(mesh);
    }
  }
  return result;
}

double count_merit(Eigen::Index has, int asked_for)
{
  constexpr double penalty = 30; // of a relative deviation
  return std::exp(-penalty * std::abs(static_cast<double>(has) / asked_for - 1));
}

CoarseCount coarse_count(int triangles)
{
  CoarseCount count{ triangles, 0 };
  while (count.triangles > most_coarse_triangles)
  {
    count.triangles /= 4;
    ++count.refinements;
  }
  return count;
}

}
