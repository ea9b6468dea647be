#include "solver/adaptation/AdaptedMesh.h"
#include "solver/adaptation/GradedRemeshing.h"
#include "solver/adaptation/SettledShape.h"

#include "solver/membrane/HelfrichBending.h"
#include "solver/mesh/Connectivity.h"
#include "solver/mesh/MeshQuality.h"
#include "solver/mesh/SizingLaw.h"
#include "solver/surface/LoopEnergy.h"
#include "tests/solver/support/TestMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace vesicle
{
namespace
{

struct Shape
{
  explicit Shape(const TriangleMesh& mesh)
    : space(SurfaceBasis::loop, mesh.triangles, static_cast<int>(mesh.points.rows())),
      surface(space, mesh.points)
  {
    terms.push_back(make_bending(space, 0));
  }

  SurfaceSpace space;
  Surface surface;
  MembraneTerms terms;
};

// A ball with a bud on a neck of a quarter of its radius, about z.
Vector3 budded(const Vector3& n)
{
  const double t = std::clamp((-n.z() - 0.6) / 0.4, 0., 1.), ball = std::hypot(n.x(), n.y());
  return { n.x() * (1 - 0.3 * t), n.y() * (1 - 0.3 * t), n.z() - 0.7 * t * t * (2 - ball) };
}

std::vector<int> valences(const TriangleMesh& mesh)
{
  const Connectivity connectivity(mesh.triangles, static_cast<int>(mesh.points.rows()));
  std::vector<int> result;
  for (int i = 0; i < mesh.points.rows(); ++i)
    result.push_back(connectivity.vertex_neighbours.size(i));
  return result;
}

// The prototype's errors of E12 on equilibria of 640 and 1,280 triangles laid by the sizing law were up
// to 4e-4 and 2e-4.
TEST(AdaptedMesh, HoldsTheShapeWithTwelveFives)
{
  const TriangleMesh mesh = test::mapped(test::smooth_sphere(320), test::ellipsoid_2_1_1);
  const Shape shape(mesh);
  const double energy = loop_energy(mesh).fine;
  for (const int triangles : { 320, 640, 1280 })
  {
    const AdaptedMesh adapted = adapted_mesh(shape.surface, triangles);
    EXPECT_NEAR(static_cast<double>(adapted.mesh.triangles.rows()) / triangles, 1, 0.02);
    EXPECT_NEAR(loop_energy(adapted.mesh).fine / energy, 1, 5e-4) << triangles;
    EXPECT_GT(mesh_quality(adapted.mesh).min_angle_deg, 35) << triangles;
    EXPECT_EQ(std::ranges::count(valences(adapted.mesh), 5), 12);
    const LimitSurface limit(mesh);
    for (std::size_t i = 0; i < adapted.places.size(); ++i)
      EXPECT_LT((limit.at(adapted.places[i]).position.transpose() -
                  adapted.mesh.points.row(static_cast<int>(i)))
                  .norm(),
        1e-14);
  }
}

TEST(AdaptedMesh, IsTheSameEachTime)
{
  const Shape shape(test::mapped(test::smooth_sphere(320), test::paper_surface));
  const AdaptedMesh once = adapted_mesh(shape.surface, 400),
                    again = adapted_mesh(shape.surface, 400);
  EXPECT_EQ(once.mesh.points, again.mesh.points);
  EXPECT_TRUE(same_triangles(once.mesh.triangles, again.mesh.triangles));
}

TEST(GradedRemeshing, FollowsTheSizingLawIntoABud)
{
  const TriangleMesh mesh = test::mapped(test::smooth_sphere(1280), budded);
  const Shape shape(mesh);
  const LimitSurface limit(mesh);
  const Connectivity connectivity(mesh.triangles, static_cast<int>(mesh.points.rows()));
  const Eigen::VectorXd wanted =
    wanted_edge_lengths(SizingLaw{}, mesh.points, connectivity.vertex_neighbours,
      squared_curvature(shape.surface), shape.surface.vertex_area, 1280);
  const PlacedMesh placed = graded_remeshing(limit, wanted, 1280);
  const TriangleMesh fresh = mesh_of(placed, limit);
  EXPECT_NEAR(static_cast<double>(fresh.triangles.rows()) / 1280, 1, 0.1);
  EXPECT_FALSE(folds_over(fresh));
  EXPECT_GT(mesh_quality(fresh).min_angle_deg, 25);
  const std::vector<int> n = valences(fresh);
  EXPECT_GE(*std::ranges::min_element(n), 4);
  EXPECT_LE(*std::ranges::max_element(n), 8);
  for (const auto& [a, b] :
    Connectivity(fresh.triangles, static_cast<int>(fresh.points.rows())).edges)
  {
    const double h = (linear(placed.places[a], mesh.triangles, wanted) +
                       linear(placed.places[b], mesh.triangles, wanted)) /
      2,
                 ratio = (fresh.points.row(a) - fresh.points.row(b)).norm() / h;
    EXPECT_GT(ratio, 0.4);
    EXPECT_LT(ratio, 2);
  }
}

TEST(SettledShape, KeepsAreaAndVolumeAndBooksTheEnergy)
{
  const TriangleMesh mesh = test::mapped(test::smooth_sphere(320), test::ellipsoid_2_1_1);
  const Shape shape(mesh);
  const double energy = shape.terms[0]->energy(shape.surface);
  for (const int triangles : { 320, 640 })
  {
    const AdaptedMesh adapted = adapted_mesh(shape.surface, triangles);
    const Shape laid(adapted.mesh);
    const SettledShape settled = settle_shape(laid.space, laid.terms, adapted,
      { shape.surface, shape.terms, shape.surface.area, shape.surface.volume });
    const Surface surface(laid.space, settled.points);
    EXPECT_NEAR(surface.area / shape.surface.area, 1, 1e-12);
    EXPECT_NEAR(surface.volume / shape.surface.volume, 1, 1e-12);
    EXPECT_NEAR(laid.terms[0]->energy(surface) - energy, settled.energy_change, 1e-9);
    // A vertex moves by less than a fiftieth of an edge (of about 5.7/√n).
    EXPECT_LT((settled.points - adapted.mesh.points).rowwise().norm().maxCoeff(),
      0.1 / std::sqrt(triangles));
  }
}

}
}
