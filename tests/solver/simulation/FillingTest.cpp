// Vesicles at random in a region: inside of it, apart from each other, the same for the same seed.

#include "solver/Errors.h"
#include "solver/mesh/SurfaceDistance.h"
#include "solver/mesh/TriangleTree.h"
#include "solver/simulation/Filling.h"
#include "solver/simulation/StartMesh.h"
#include "solver/simulation/StartOverlap.h"

#include <gtest/gtest.h>

#include <string>

using namespace vesicle;

namespace
{

TriangleMesh prolate()
{
  Scene scene;
  scene.vesicle.shape.kind = ShapeRequest::Kind::prolate;
  scene.vesicle.shape.reduced_volume = 0.8;
  scene.vesicle.shape.triangles = 80;
  return make_start_mesh(scene);
}

std::vector<TriangleMesh> copies(
  const TriangleMesh& shape, const std::vector<Placement>& placements)
{
  std::vector<TriangleMesh> meshes;
  for (const Placement& p : placements)
  {
    Points points = shape.points * p.turn.toRotationMatrix().transpose();
    points.rowwise() += p.center.transpose();
    meshes.push_back({ points, shape.triangles });
  }
  return meshes;
}

/// Of the points of each from the triangles of the other.
double gap(const TriangleMesh& a, const TriangleMesh& b)
{
  double least = HUGE_VAL;
  const TriangleTree to_a(a), to_b(b);
  for (const auto& x : a.points.rowwise())
    least = std::min(least, std::sqrt(to_b.nearest(x.transpose()).squared_distance));
  for (const auto& x : b.points.rowwise())
    least = std::min(least, std::sqrt(to_a.nearest(x.transpose()).squared_distance));
  return least;
}

std::vector<FillRegion> regions()
{
  return { { FillRegion::Kind::box, { 6, 5, 7 }, 1 }, { FillRegion::Kind::tube, { 12, 0, 0 }, 2.5 },
    { FillRegion::Kind::ball, Vector3::Zero(), 4 } };
}

}

TEST(Filling, KeepsVesiclesInsideAndApart)
{
  const TriangleMesh shape = prolate();
  for (const FillRegion& region : regions())
  {
    const FillSettings settings{ 8, region, 0.1, 7, true };
    const auto meshes = copies(shape, fill(shape, settings));
    ASSERT_EQ(meshes.size(), 8u);
    EXPECT_FALSE(find_overlap(meshes));
    for (std::size_t i = 0; i < meshes.size(); ++i)
    {
      for (const auto& x : meshes[i].points.rowwise())
        EXPECT_TRUE(region.contains(x.transpose()));
      for (std::size_t j = 0; j < i; ++j)
        EXPECT_GE(gap(meshes[i], meshes[j]), 0.1);
    }
  }
}

TEST(Filling, TakesARegionAnywhere)
{
  const TriangleMesh shape = prolate();
  for (FillRegion region : regions())
  {
    const auto about_origin = fill(shape, { 3, region, 0.1, 7, true });
    region.center = { 100, -20, 3 };
    const auto there = fill(shape, { 3, region, 0.1, 7, true });
    for (std::size_t i = 0; i < there.size(); ++i)
      EXPECT_LT((there[i].center - about_origin[i].center - region.center).norm(), 1e-12);
  }
}

TEST(Filling, KeepsVesiclesAboveAWall)
{
  const TriangleMesh shape = prolate();
  const Wall wall{ { 0, 0, -1 }, Vector3(1, 0, 3).normalized() };
  FillSettings settings{ 12, { FillRegion::Kind::box, { 8, 8, 8 }, 1 }, 0.1, 7, true, wall };
  for (const TriangleMesh& copy : copies(shape, fill(shape, settings)))
    EXPECT_GE(wall.heights(copy.points).minCoeff(), 0.1);

  settings.wall->point = { 0, 0, 9 }; // all of the box is behind it
  EXPECT_THROW(fill(shape, settings), InputError);
}

TEST(Filling, FollowsTheSeed)
{
  const TriangleMesh shape = prolate();
  FillSettings settings{ 3, regions()[0], 0.1, 7, true };
  const auto first = fill(shape, settings), again = fill(shape, settings);
  settings.seed = 8;
  const auto other = fill(shape, settings);
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    EXPECT_EQ(first[i].center, again[i].center);
    EXPECT_EQ(first[i].turn.coeffs(), again[i].turn.coeffs());
    EXPECT_NE(first[i].center, other[i].center);
  }
}

TEST(Filling, LeavesShapesAsTheyAreWhereTheyAreAligned)
{
  const TriangleMesh shape = prolate();
  const FillSettings settings{ 3, regions()[0], 0.1, 7, false };
  for (const Placement& placement : fill(shape, settings))
    EXPECT_EQ(placement.turn.coeffs(), Eigen::Quaterniond::Identity().coeffs());
}

// A mean of random turns of a vector is 0: of n of them to about 1/√n.
TEST(Filling, TurnsAreUniform)
{
  const TriangleMesh shape = prolate();
  const FillSettings settings{ 200, { FillRegion::Kind::box, { 60, 60, 60 }, 1 }, 0.1, 7, true };
  Vector3 mean = Vector3::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  for (const Placement& placement : fill(shape, settings))
  {
    const Vector3 axis = placement.turn * Vector3::UnitZ();
    mean += axis / 200;
    second += axis * axis.transpose() / 200;
  }
  EXPECT_LT(mean.norm(), 3 / std::sqrt(200.));
  EXPECT_LT((second - Eigen::Matrix3d::Identity() / 3).norm(), 3 / std::sqrt(200.));
}

TEST(Filling, SaysHowManyFitted)
{
  const TriangleMesh shape = prolate();
  const FillSettings settings{ 20, { FillRegion::Kind::ball, Vector3::Zero(), 1.8 }, 0, 7, true };
  try
  {
    fill(shape, settings);
    FAIL() << "no error";
  }
  catch (const InputError& error)
  {
    EXPECT_NE(std::string(error.what()).find("of 20 vesicles fitted"), std::string::npos)
      << error.what();
  }
}
