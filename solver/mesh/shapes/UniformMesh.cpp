#include "solver/mesh/shapes/UniformMesh.h"

#include "solver/ParallelFor.h"
#include "solver/mesh/MeshQuality.h"
#include "solver/mesh/shapes/SphereMeshSmoothing.h"
#include "solver/mesh/shapes/SphereTriangulations.h"

#include <algorithm>
#include <vector>

namespace vesicle
{

namespace
{
constexpr int finalists = 3;

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
  parallel_for(candidates.size(),
    [&](std::size_t i)
    {
      Candidate& candidate = candidates[i];
      smooth(candidate.mesh, surface, passes);
      candidate.merit = mesh_quality(mapped(candidate.mesh, surface)).score() *
        count_merit(candidate.mesh.triangles.rows(), triangles);
    });
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
  const CoarseCount coarse = coarse_count(triangles);
  SphereMesh mesh = best_coarse_mesh(surface, coarse.triangles, symmetry);
  for (int level = 0; level < coarse.refinements; ++level)
  {
    mesh = refined(mesh);
    smooth(mesh, surface, fine_passes);
  }
  return mesh;
}

}
