#include "solver/mesh/shapes/GradedMesh.h"

#include "solver/mesh/MeshQuality.h"
#include "solver/mesh/shapes/SphereMeshSmoothing.h"
#include "solver/mesh/shapes/SphereTriangulations.h"
#include "solver/mesh/shapes/UniformMesh.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace vesicle
{

namespace
{
constexpr int finalists = 4;
/// Errors below don't tell meshes apart: they may be small by accident.
constexpr double accidental_error = 1e-4;
/// Where no graded mesh is better than that the law's own assumption fails, that triangles see the
/// bends: even meshes may then do better.
constexpr double unresolved_error = 1e-2;

struct Graded
{
  SphereMesh mesh;
  double score;
};

/// After a few passes the best of them stand out.
std::vector<Graded> best_triangulations(
  const SphericalParametrisation& surface, int triangles, Symmetry symmetry)
{
  std::vector<Graded> tried;
  for (SphereMesh& mesh : placed_triangulations(triangles, symmetry))
  {
    const double score = grade(mesh, surface, trial_passes);
    const double merit = score * count_merit(mesh.triangles.rows(), triangles);
    tried.push_back({ std::move(mesh), merit });
  }
  std::ranges::stable_sort(tried, std::ranges::greater(), &Graded::score);
  tried.resize(std::min<std::size_t>(tried.size(), finalists));
  return tried;
}

/// Keeps the best mesh that it is shown.
class Choice
{
public:
  Choice(const SphericalParametrisation& surface, const MeshError& error)
    : surface_(surface), error_(error)
  {
  }

  void consider(const SphereMesh& mesh)
  {
    const double error = error_(mesh);
    const double angle = mesh_quality(mapped(mesh, surface_)).min_angle_deg;
    const double merit = angle / (error + accidental_error);
    if (!(merit > merit_)) // or not a number
      return;
    best_ = mesh;
    best_error_ = error;
    merit_ = merit;
  }
  double error() const { return best_error_; }
  const SphereMesh& best() const { return best_; }

private:
  const SphericalParametrisation& surface_;
  const MeshError& error_;
  SphereMesh best_;
  double best_error_ = std::numeric_limits<double>::infinity(), merit_ = 0;
};

SphereMesh best_coarse_mesh(
  const SphericalParametrisation& surface, int triangles, Symmetry symmetry, const MeshError& error)
{
  Choice choice(surface, error);
  for (Graded& graded : best_triangulations(surface, triangles, symmetry))
  {
    choice.consider(graded.mesh);
    grade(graded.mesh, surface, settling_passes);
    choice.consider(graded.mesh);
  }
  if (choice.error() > unresolved_error)
    choice.consider(uniform_mesh(surface, triangles, symmetry));
  return choice.best();
}
}

SphereMesh graded_mesh(
  const SphericalParametrisation& surface, int triangles, Symmetry symmetry, const MeshError& error)
{
  const CoarseCount coarse = coarse_count(triangles);
  SphereMesh mesh = best_coarse_mesh(surface, coarse.triangles, symmetry, error);
  for (int level = 0; level < coarse.refinements; ++level)
  {
    Choice choice(surface, error);
    mesh = refined(mesh);
    choice.consider(mesh);
    grade(mesh, surface, fine_passes);
    choice.consider(mesh);
    mesh = choice.best();
  }
  return mesh;
}

}
