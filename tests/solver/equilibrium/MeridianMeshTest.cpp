#include "solver/equilibrium/MeridianMesh.h"

#include "solver/Errors.h"
#include "solver/mesh/MeshQuality.h"
#include "solver/mesh/Topology.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vesicle
{
namespace
{

double distance(const Meridian& meridian, double r, double z)
{
  double least = INFINITY;
  constexpr int samples = 4000;
  for (int i = 0; i <= samples; ++i)
  {
    const Meridian::Point p = meridian.at(i * std::numbers::pi / samples);
    least = std::min(least, std::hypot(p.r - r, p.z - z));
  }
  return least;
}

TEST(MeridianMesh, LiesOnTheSurfaceWithGoodTriangles)
{
  struct Case
  {
    EquilibriumBranch branch;
    double reduced_volume, least_angle; // of 320 triangles, less than measured by a few degrees
  };
  for (const Case& c :
    { Case{ EquilibriumBranch::prolate, 0.5, 40 }, Case{ EquilibriumBranch::oblate, 0.6, 33 },
      Case{ EquilibriumBranch::stomatocyte, 0.6, 30 } })
  {
    const AxisymmetricShape shape = axisymmetric_equilibrium(c.branch, c.reduced_volume);
    const TriangleMesh mesh = meridian_mesh(shape.meridian, c.branch, 320);
    SCOPED_TRACE(branch_name(c.branch));
    EXPECT_EQ(mesh.triangles.rows(), 320);
    EXPECT_TRUE(topology(mesh).closed && topology(mesh).oriented && topology(mesh).manifold);
    EXPECT_GT(mesh_quality(mesh).min_angle_deg, c.least_angle);
    for (const auto x : mesh.points.rowwise())
      ASSERT_LT(distance(shape.meridian, x.head<2>().norm(), x[2]), 2e-3);
  }
}

TEST(MeridianMesh, HasTheNearestNumberOfTriangles)
{
  const AxisymmetricShape shape = axisymmetric_equilibrium(EquilibriumBranch::prolate, 0.9);
  const auto count = [&](int triangles)
  { return meridian_mesh(shape.meridian, EquilibriumBranch::prolate, triangles).triangles.rows(); };
  EXPECT_EQ(count(500), 500);
  EXPECT_EQ(count(503), 504);
  EXPECT_THROW(count(20), InputError);
}

}
}
