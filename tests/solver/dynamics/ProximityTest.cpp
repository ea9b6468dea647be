// Distances between vesicles, and the repulsion that lives on them.

#include "solver/dynamics/Proximity.h"

#include "solver/Errors.h"
#include "solver/dynamics/System.h"
#include "tests/solver/dynamics/SmallestGap.h"
#include "tests/solver/support/TestMeshes.h"

#include <gtest/gtest.h>

namespace vesicle
{
namespace
{

TriangleMesh turned(TriangleMesh mesh, double angle, const Vector3& to)
{
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, Vector3(1, 2, 3).normalized()).matrix();
  mesh.points = ((mesh.points * turn.transpose()).rowwise() + to.transpose()).eval();
  return mesh;
}

/// Smooth surfaces through meshes, as Proximity takes them.
struct Bodies
{
  std::vector<Vesicle> vesicles;
  std::vector<std::unique_ptr<const Surface>> surfaces;

  explicit Bodies(const std::vector<TriangleMesh>& meshes)
  {
    for (const TriangleMesh& mesh : meshes)
    {
      vesicles.push_back(
        make_vesicle(SurfaceBasis::loop, mesh.triangles, static_cast<int>(mesh.points.rows()), 3));
      surfaces.push_back(std::make_unique<const Surface>(*vesicles.back().space, mesh.points));
    }
  }
  std::vector<Proximity::Side> sides() const
  {
    std::vector<Proximity::Side> sides;
    for (std::size_t v = 0; v < vesicles.size(); ++v)
      sides.push_back({ vesicles[v].layer.get(), surfaces[v].get() });
    return sides;
  }
};

// Wherever the vertices are: the surface through them is within 1e-3 of the sphere at 320 triangles,
// 2e-4 at 1,280; also farther away than the radius of curvature.
TEST(Proximity, TheGapIsThatOfTheSurfaces)
{
  for (const auto& [triangles, tolerance] : { std::pair(320, 1e-3), std::pair(1280, 2e-4) })
    for (const double gap :
      triangles == 320 ? std::vector{ 0.003, 0.05, 0.3 } : std::vector{ 0.05 })
      for (const Vector3& along : { Vector3(0, 0, 1), Vector3(1, 0.3, -0.5) })
      {
        const Bodies bodies({ test::smooth_sphere(triangles),
          turned(test::smooth_sphere(triangles), 0.7, (2 + gap) * along.normalized()) });
        const Gap found = test::smallest_gap(bodies.sides());
        EXPECT_NEAR(found.distance, gap, tolerance) << triangles << ", " << gap;
        EXPECT_EQ(found.vesicle[0] + found.vesicle[1], 1U);
        const std::size_t lower = found.vesicle[0] == 0 ? 0 : 1;
        EXPECT_LT((found.place[lower] - along.normalized()).norm(), 0.05)
          << triangles << ", " << gap;
      }
  const Bodies apart(
    { test::smooth_sphere(320), turned(test::smooth_sphere(320), 0.7, { 0, 0, 4 }) });
  EXPECT_NEAR(test::smallest_gap(apart.sides()).distance, 2, 1e-3);
}

TEST(Proximity, NearestOfManyByTheirNumbers)
{
  std::vector<TriangleMesh> meshes;
  for (const double x : { 0., 2.4, 4.5, 9. })
    meshes.push_back(turned(test::smooth_sphere(80), x, { x, 0, 0 }));
  const Gap found = test::smallest_gap(Bodies(meshes).sides());
  EXPECT_EQ(std::max(found.vesicle[0], found.vesicle[1]), 2U);
  EXPECT_EQ(std::min(found.vesicle[0], found.vesicle[1]), 1U);
  EXPECT_NEAR(found.distance, 0.1, 0.01);
}

TEST(Proximity, CrossingIsANegativeGap)
{
  const Bodies bodies(
    { test::smooth_sphere(320), turned(test::smooth_sphere(320), 0.7, { 0, 0, 1.95 }) });
  EXPECT_NEAR(test::smallest_gap(bodies.sides()).distance, -0.05, 2e-3);
}

TEST(Proximity, NothingIsNearBeyondTheReach)
{
  const Bodies bodies(
    { test::smooth_sphere(80), turned(test::smooth_sphere(80), 0.7, { 0, 0, 2.5 }) });
  EXPECT_TRUE(Proximity(bodies.sides(), 0.3).near().empty());
  EXPECT_FALSE(Proximity(bodies.sides(), 0.3).smallest());
  EXPECT_FALSE(Proximity(bodies.sides(), 0.7).near().empty());
}

struct RepellingPair
{
  std::vector<TriangleMesh> meshes{ test::mapped(test::smooth_sphere(80),
                                      [](const Vector3& d) -> Vector3 {
                                        return { 1.2 * d.x(), d.y(), 0.9 * d.z() };
                                      }),
    turned(test::smooth_sphere(320), 0.3, { 0.1, 0.05, 2 }) };
  Bodies bodies{ meshes };
  Repulsion repulsion{ .strength = 2, .range = 0.4 };

  /// With the control points moved by s times a field.
  double energy(std::size_t vesicle, const Eigen::VectorXd& field, double s) const
  {
    std::vector<TriangleMesh> moved = meshes;
    const Eigen::VectorXd of_vertices =
      bodies.surfaces[vesicle]->collocation().to_vertices(s * field);
    moved[vesicle].points += rows_of_three(of_vertices);
    const Bodies there(moved);
    return repulsion.energy(Proximity(there.sides(), repulsion.range));
  }
};

TEST(Repulsion, GradientIsTheEnergysDerivative)
{
  const RepellingPair pair;
  const auto gradients =
    pair.repulsion.gradients(Proximity(pair.bodies.sides(), pair.repulsion.range));
  for (std::size_t v = 0; v < 2; ++v)
  {
    const Eigen::Index n = gradients[v].size();
    const Eigen::VectorXd field = Eigen::VectorXd::LinSpaced(n, 0, 30).array().sin();
    constexpr double s = 1e-5;
    const double difference = (pair.energy(v, field, s) - pair.energy(v, field, -s)) / (2 * s);
    EXPECT_NEAR(gradients[v].dot(field) / difference, 1, 1e-6) << v;
  }
}

// Moved together, or turned together, the two keep their energy.
TEST(Repulsion, ForcesAreEqualAndOpposite)
{
  const RepellingPair pair;
  const auto gradients =
    pair.repulsion.gradients(Proximity(pair.bodies.sides(), pair.repulsion.range));
  Vector3 force = Vector3::Zero(), torque = Vector3::Zero();
  double size = 0;
  for (std::size_t v = 0; v < 2; ++v)
  {
    const Points& control = pair.bodies.surfaces[v]->control;
    Vector3 own = Vector3::Zero();
    for (Eigen::Index i = 0; i < control.rows(); ++i)
    {
      const Vector3 g = gradients[v].segment<3>(3 * i), x = control.row(i).transpose();
      own += g;
      torque += x.cross(g);
    }
    force += own;
    size = std::max(size, own.norm());
  }
  EXPECT_GT(size, 0.1);
  EXPECT_LT(force.norm(), 1e-8 * size);
  EXPECT_LT(torque.norm(), 1e-8 * size);
}

TEST(Repulsion, CrossingIsAnError)
{
  const Bodies bodies(
    { test::smooth_sphere(80), turned(test::smooth_sphere(80), 0.7, { 0, 0, 1.8 }) });
  const Repulsion repulsion{ .strength = 1, .range = 0.2 };
  EXPECT_THROW(repulsion.energy(Proximity(bodies.sides(), repulsion.range)), NumericalError);
}

}
}
