#include "solver/adaptation/AdaptedMesh.h"

#include "solver/Errors.h"
#include "solver/adaptation/GradedRemeshing.h"
#include "solver/adaptation/SphereLayout.h"
#include "solver/mesh/Connectivity.h"
#include "solver/mesh/MeshIntegrals.h"
#include "solver/mesh/MeshQuality.h"
#include "solver/mesh/SizingLaw.h"
#include "solver/mesh/shapes/SphereTriangulations.h"
#include "solver/surface/LoopEnergy.h"

#include <algorithm>
#include <cmath>

namespace vesicle
{

namespace
{

constexpr int finalists = 4;
/// What matters less than angles, which a run wears down: errors below the first, angles above the second.
constexpr double small_error = 1e-3, wide_angle = 35;
/// Twelve fives fit all but necks and tethers. The smallest angle in degrees.
constexpr double good_error = 1e-3, good_angle = 30;

/// What a mesh is to hold.
class Original
{
public:
  explicit Original(const Surface& surface)
    : surface_(surface), limit_({ surface.vertices, surface.space->triangles() }),
      neighbours_(
        Connectivity(surface.space->triangles(), surface.space->nodes()).vertex_neighbours),
      curvature_(squared_curvature(surface)), energy_(loop_energy(limit_.mesh()).fine),
      reduced_volume_(reduced_volume(surface.area, surface.volume))
  {
  }

  const LimitSurface& limit() const { return limit_; }
  Eigen::VectorXd edge_lengths(int triangles) const
  {
    return wanted_edge_lengths(
      SizingLaw{}, surface_.vertices, neighbours_, curvature_, surface_.vertex_area, triangles);
  }
  /// Around each vertex, but for a factor.
  Eigen::VectorXd triangles() const
  {
    constexpr int any = 1000;
    return surface_.vertex_area.cwiseQuotient(edge_lengths(any).cwiseAbs2());
  }
  double error(const TriangleMesh& mesh) const
  {
    return loop_error(mesh, energy_, reduced_volume_);
  }

private:
  const Surface& surface_;
  LimitSurface limit_;
  AdjacencyList neighbours_;
  Eigen::VectorXd curvature_;
  double energy_, reduced_volume_;
};

/// Keeps the best mesh that it is shown.
class Choice
{
public:
  explicit Choice(const Original& original) : original_(original) {}

  void consider(const PlacedMesh& placed)
  {
    const TriangleMesh mesh = mesh_of(placed, original_.limit());
    if (!mesh.points.allFinite())
      return;
    const double error = original_.error(mesh), angle = mesh_quality(mesh).min_angle_deg,
                 merit = std::min(angle, wide_angle) / (error + small_error);
    if (!(merit > merit_) || folds_over(mesh)) // or not a number
      return;
    best_ = placed;
    error_ = error;
    angle_ = angle;
    merit_ = merit;
  }
  bool any() const { return merit_ > 0; }
  const PlacedMesh& best() const { return best_; }
  bool good() const { return error_ <= good_error && angle_ >= good_angle; }

private:
  const Original& original_;
  PlacedMesh best_;
  double error_ = INFINITY, angle_ = 0, merit_ = 0;
};

struct Tried
{
  PlacedMesh mesh;
  double score;
};

/// After a few passes the best of them stand out.
std::vector<Tried> best_triangulations(
  const Original& original, const Eigen::VectorXd& edge_lengths, int triangles)
{
  constexpr int axes = 3;
  std::vector<Tried> tried;
  SphereLayout layout(original.limit().mesh(), original.triangles());
  const auto spheres = placed_triangulations(triangles, Symmetry::turns_about_z);
  for (int axis = 0; axis < axes; ++axis, layout.next_axis())
    for (const SphereMesh& sphere : spheres)
    {
      PlacedMesh mesh = layout.lay(sphere);
      spread(mesh, original.limit(), edge_lengths, trial_passes);
      const double angle = mesh_quality(mesh_of(mesh, original.limit())).min_angle_deg;
      tried.push_back({ std::move(mesh), angle * count_merit(sphere.triangles.rows(), triangles) });
    }
  std::ranges::stable_sort(tried, std::ranges::greater(), &Tried::score);
  tried.resize(std::min<std::size_t>(tried.size(), finalists));
  return tried;
}

void consider_spheres(
  Choice& choice, const Original& original, const Eigen::VectorXd& edge_lengths, int triangles)
try
{
  for (Tried& tried : best_triangulations(original, edge_lengths, triangles))
  {
    spread(tried.mesh, original.limit(), edge_lengths, settling_passes);
    choice.consider(tried.mesh);
  }
}
catch (const NumericalError&)
{
  // It can't be spread over a sphere; there are other ways.
}

/// Cut finer, and spread again where that does better.
void consider_refined(Choice& choice, const Original& original, PlacedMesh mesh,
  const Eigen::VectorXd& edge_lengths, int refinements)
{
  for (int level = 0; level < refinements; ++level)
  {
    Choice finer(original);
    mesh = refined(mesh, original.limit());
    finer.consider(mesh);
    spread(mesh, original.limit(), edge_lengths, fine_passes);
    finer.consider(mesh);
    if (!finer.any())
      return;
    mesh = finer.best();
  }
  choice.consider(mesh);
}

}

AdaptedMesh adapted_mesh(const Surface& surface, int triangles)
{
  const Original original(surface);
  const CoarseCount count = coarse_count(triangles);
  const Eigen::VectorXd edge_lengths = original.edge_lengths(count.triangles);
  Choice spheres(original), choice(original);
  consider_spheres(spheres, original, edge_lengths, count.triangles);
  if (spheres.any())
    consider_refined(choice, original, spheres.best(), edge_lengths, count.refinements);
  if (!choice.good())
    choice.consider(
      graded_remeshing(original.limit(), original.edge_lengths(triangles), triangles));
  if (!choice.any())
    throw NumericalError("no mesh fits the surface");
  return { mesh_of(choice.best(), original.limit()), choice.best().places };
}

}
