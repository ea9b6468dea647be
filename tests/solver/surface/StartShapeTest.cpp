#include "solver/Errors.h"
#include "solver/mesh/MeshIntegrals.h"
#include "solver/mesh/MeshQuality.h"
#include "solver/mesh/SelfCrossing.h"
#include "solver/mesh/shapes/Shapes.h"
#include "solver/surface/LoopEnergy.h"
#include "solver/surface/StartShape.h"
#include "solver/surface/Surface.h"
#include "solver/surface/SurfaceIntegrals.h"
#include "solver/surface/SurfaceMeasures.h"
#include "tests/solver/support/ReferenceProfile.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace vesicle::test
{

using Kind = ShapeRequest::Kind;
using testing::AllOf;
using testing::HasSubstr;

namespace
{

ShapeRequest request(Kind kind, int triangles, double v)
{
  ShapeRequest result;
  result.kind = kind;
  result.triangles = triangles;
  result.reduced_volume = v;
  return result;
}

double loop_reduced_volume(const TriangleMesh& mesh)
{
  const SurfaceMeasures m = surface_measures(SurfaceBasis::loop, mesh);
  return reduced_volume(m.area, m.volume);
}

Vector3 loop_centroid(const TriangleMesh& mesh)
{
  const SurfaceSpace space(
    SurfaceBasis::loop, mesh.triangles, static_cast<int>(mesh.points.rows()));
  return centroid(space.table(), evaluate(space.table(), space.collocation().fit(mesh.points)));
}

void expect_reduced_volume(Kind kind, int triangles, double v)
{
  SCOPED_TRACE(shape_name(kind) + " " + std::to_string(triangles) + " " + std::to_string(v));
  const TriangleMesh mesh = make_start_shape(request(kind, triangles, v), SurfaceBasis::loop);
  EXPECT_EQ(mesh.triangles.rows(), triangles);
  EXPECT_NEAR(loop_reduced_volume(mesh), v, 1e-12);
  EXPECT_NEAR(surface_measures(SurfaceBasis::loop, mesh).volume, 4 * std::numbers::pi / 3, 1e-12);
  EXPECT_LT(loop_centroid(mesh).norm(), 1e-9);
  EXPECT_EQ(find_self_crossing(mesh), std::nullopt);
  EXPECT_GE(mesh_quality(mesh).min_angle_deg, 10);
}

// Of the energy by 12 points against the equilibrium's.
double profile_error(const std::string& branch, double v, int triangles)
{
  const auto surface = reference_profile(branch + (v == 0.5 ? "_v050" : "_v060"));
  const Symmetry symmetry = branch == "stomatocyte" ? Symmetry::turns_about_z : Symmetry::around_z;
  const TriangleMesh mesh = mapped(loop_mesh(surface, triangles, symmetry), surface);
  EXPECT_EQ(mesh.triangles.rows(), triangles);
  EXPECT_GE(mesh_quality(mesh).min_angle_deg, 28);
  EXPECT_EQ(find_self_crossing(mesh), std::nullopt);
  const double energy = loop_energy(mesh).fine / (8 * std::numbers::pi);
  return std::abs(energy / reference_energy(branch, v) - 1);
}

}

void expect_errors(const std::string& branch, double v, std::array<double, 3> bounds)
{
  int triangles = 320;
  for (const double bound : bounds)
  {
    EXPECT_LE(profile_error(branch, v, triangles), bound) << branch << ' ' << v << ' ' << triangles;
    triangles *= 2;
  }
}

// Even meshes: 4.3e-3 / 7.6e-4 / 3.3e-4, and 1.5e-3 / 4.0e-4 / 8.4e-5.
TEST(LoopMesh, HoldsConvexAndBiconcaveEquilibria)
{
  expect_errors("oblate", 0.6, { 1e-3, 4e-4, 2e-4 });
  expect_errors("prolate", 0.5, { 1e-3, 4e-4, 2e-4 });
}

// Even meshes: .40 / 2.9 / 1.4, and .061 / 2.1 / 5.3e-3.
TEST(LoopMesh, HoldsTheNecksOfStomatocytes)
{
  expect_errors("stomatocyte", 0.5, { 2e-3, 4e-3, 2e-4 });
  expect_errors("stomatocyte", 0.6, { 2e-3, 4e-3, 2e-4 });
}

// Fine meshes are cut from coarse ones: 320 triangles have 8e-4, and the error falls as their number
// squared.
TEST(LoopMesh, StaysGradedWhereItIsRefined)
{
  EXPECT_LE(profile_error("oblate", 0.6, 5120), 2e-5 + 1.4e-5);
}

TEST(StartShape, HasTheReducedVolumeOnLoopsSurface)
{
  for (const int triangles : { 80, 320 })
  {
    for (const double v : { 0.9999, 0.8, 0.5, 0.35 })
      expect_reduced_volume(Kind::prolate, triangles, v);
    for (const double v : { 0.99, 0.6, 0.25 })
      expect_reduced_volume(Kind::oblate, triangles, v);
    for (const double v : { 0.9999, 0.8, 0.4 })
      expect_reduced_volume(Kind::discocyte, triangles, v);
  }
  for (const double v : { 0.7, 0.5 })
    expect_reduced_volume(Kind::stomatocyte, 640, v);
  expect_reduced_volume(Kind::prolate, 1280, 0.35);
  expect_reduced_volume(Kind::discocyte, 1280, 0.999999);
}

// The roundest mesh of 20 triangles has 1 − 2.7e-4, of 80 1 − 4e-6 and of 320 1 − 2e-6.
TEST(StartShape, IsAsRoundAsTheTrianglesCanBe)
{
  for (const auto& [triangles, lacking] :
    { std::pair(20, 3e-4), { 80, 5e-6 }, { 100, 4e-5 }, { 320, 2e-6 } })
  {
    const ShapeRequest r = request(Kind::oblate, triangles, 1 - 1e-6);
    const TriangleMesh mesh = make_start_shape(r, SurfaceBasis::loop);
    EXPECT_NEAR(loop_reduced_volume(mesh), 1 - 1e-6, lacking);
    const std::string warning = start_shape_warning(r, SurfaceBasis::loop, mesh);
    if (triangles == 320)
      EXPECT_EQ(warning, "");
    else
      EXPECT_THAT(warning, HasSubstr("the largest that " + std::to_string(triangles)));
  }
}

// Half turns about the axes map the mesh onto itself.
TEST(StartShape, IsAsSymmetricAsTheShape)
{
  for (const Kind kind : { Kind::prolate, Kind::discocyte })
  {
    const TriangleMesh mesh = make_start_shape(request(kind, 320, 0.6), SurfaceBasis::loop);
    const Eigen::Matrix3d moments = mesh.points.transpose() * mesh.points;
    EXPECT_LT(std::abs(moments(0, 1)) + std::abs(moments(1, 2)) + std::abs(moments(0, 2)),
      1e-9 * moments.trace());
  }
}

// Relative errors of the energy: prolate .9 at 80 3e-3, at 320 .4 1.6e-2 and .5 9e-3.
TEST(StartShape, SaysWhatItDoesNotHold)
{
  const auto warning = [](Kind kind, int triangles, double v, SurfaceBasis basis)
  {
    const ShapeRequest r = request(kind, triangles, v);
    return start_shape_warning(r, basis, make_start_shape(r, basis));
  };
  const auto loop = SurfaceBasis::loop, linear = SurfaceBasis::linear;
  EXPECT_EQ(warning(Kind::prolate, 80, 0.9, loop), "");
  EXPECT_EQ(warning(Kind::prolate, 320, 0.5, loop), "");
  EXPECT_THAT(warning(Kind::prolate, 320, 0.4, loop),
    AllOf(HasSubstr("320 triangles are too few for this 'prolate'"),
      HasSubstr("about 640 are needed for 1%")));
  EXPECT_THAT(warning(Kind::oblate, 80, 0.25, loop), HasSubstr("more than 2560 are needed"));
  EXPECT_EQ(warning(Kind::oblate, 80, 0.25, linear), "");
}

TEST(StartShape, TurnsZToTheAxis)
{
  for (const Vector3& axis : { Vector3(0, 0, 2), Vector3(0, 0, -3), Vector3(1, 0, 0),
         Vector3(0, -1, 0), Vector3(1, -2, 0.5), Vector3(1e-4, 0, -1), Vector3(1e-9, 0, -1) })
  {
    const Eigen::Matrix3d turn = turn_z_to(axis);
    EXPECT_LT((turn * Vector3::UnitZ() - axis.normalized()).norm(), 1e-8) << axis.transpose();
    EXPECT_LT((turn.transpose() * turn - Eigen::Matrix3d::Identity()).norm(), 1e-8);
    EXPECT_NEAR(turn.determinant(), 1, 1e-8);
  }
}

// The shortest turn: what is normal to both stays.
TEST(StartShape, TurnsAboutTheNormalOfBoth)
{
  const Vector3 axis(1, -2, 0.5), normal = Vector3::UnitZ().cross(axis);
  EXPECT_LT((turn_z_to(axis) * normal - normal).norm(), 1e-14);
  EXPECT_EQ(turn_z_to(Vector3(0, 0, 2)), Eigen::Matrix3d::Identity());
}

}
