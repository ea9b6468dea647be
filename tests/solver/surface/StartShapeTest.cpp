#include "solver/surface/StartShape.h"

#include <gtest/gtest.h>

namespace vesicle::test
{

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
