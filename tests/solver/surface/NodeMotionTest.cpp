// How nodes follow the fluid, and that loads are its adjoint.

#include "solver/surface/NodeMotion.h"

#include "tests/solver/support/TestMeshes.h"

#include <gtest/gtest.h>

namespace vesicle
{
namespace
{

struct Case
{
  TriangleMesh mesh = test::mapped(test::smooth_sphere(320), test::ellipsoid_2_1_1);
  SurfaceSpace space{ SurfaceBasis::loop, mesh.triangles, static_cast<int>(mesh.points.rows()) };
  Surface surface{ space, mesh.points };

  /// Q u.
  Eigen::VectorXd moved(const NodeMotion& motion, const Eigen::VectorXd& u) const
  {
    const Eigen::VectorXd at_vertices = surface.collocation().to_vertices(u);
    return motion.velocity(motion.parameters(at_vertices)) +
      surface.to_control(flat(motion.rigid(at_vertices)));
  }
};

Eigen::VectorXd arbitrary(Eigen::Index size, double frequency)
{
  return Eigen::VectorXd::NullaryExpr(
    size, [&](Eigen::Index i) { return std::sin(frequency * static_cast<double>(i) + 1); });
}

Vector3 torque(const Points& forces, const Case& c)
{
  Vector3 sum = Vector3::Zero();
  for (Eigen::Index i = 0; i < forces.rows(); ++i)
    sum += Vector3(c.surface.control.row(i).transpose() - c.surface.center)
             .cross(Vector3(forces.row(i).transpose()));
  return sum;
}

// The gradient of an energy: that of two springs between control points.
Eigen::VectorXd arbitrary_without_torque(const Case& c)
{
  Points forces = Points::Zero(c.space.nodes(), 3);
  for (const auto& [i, j] : { std::pair(3, 90), std::pair(17, 120) })
  {
    const Eigen::RowVector3d pull = c.surface.control.row(j) - c.surface.control.row(i);
    forces.row(i) += pull;
    forces.row(j) -= pull;
  }
  return flat(forces);
}

class Motion : public testing::TestWithParam<NodeMotionKind>
{
};

TEST_P(Motion, LoadsAreTheAdjoint)
{
  const Case c;
  const NodeMotion motion(c.surface, GetParam());
  const Eigen::VectorXd u = arbitrary(3 * c.space.nodes(), 2.3), g = arbitrary(u.size(), 3.7);
  const double power = g.dot(c.moved(motion, u));
  EXPECT_NEAR(motion.adjoint(g).dot(u), power, 1e-11 * g.norm() * u.norm());
}

TEST_P(Motion, FollowsATranslation)
{
  const Case c;
  const NodeMotion motion(c.surface, GetParam());
  const Eigen::VectorXd u = Vector3(1, -2, 0.5).replicate(c.space.nodes(), 1);
  EXPECT_LT((c.moved(motion, u) - u).cwiseAbs().maxCoeff(), 1e-12);
  const Eigen::VectorXd nothing = motion.parameters(u);
  EXPECT_LT(nothing.cwiseAbs().maxCoeff(), 1e-12);
}

// About an axis that moves the surface; what is left of it is ε's.
TEST_P(Motion, FollowsATurn)
{
  const Case c;
  const NodeMotion motion(c.surface, GetParam());
  Points u(c.space.nodes(), 3);
  for (Eigen::Index i = 0; i < u.rows(); ++i)
    u.row(i) = Eigen::RowVector3d(0, 1, 0).cross(c.surface.vertices.row(i));
  const Points moved = rows_of_three(
    c.surface.collocation().to_vertices(c.moved(motion, c.surface.to_control(flat(u)))));
  EXPECT_LT((moved - u).rowwise().norm().maxCoeff(), 0.02 * u.rowwise().norm().maxCoeff());
}

// A functional that no rigid motion changes has a load with no net force and, but for ε, no torque.
TEST_P(Motion, GivesNoNetForce)
{
  const Case c;
  const NodeMotion motion(c.surface, GetParam());
  const Points load =
    rows_of_three(motion.adjoint(volume_gradient(c.space.table(), c.surface.points)));
  EXPECT_LT(load.colwise().sum().norm(), 1e-12 * load.norm());
  const Points elsewhere = rows_of_three(motion.adjoint(arbitrary_without_torque(c)));
  EXPECT_LT(torque(elsewhere, c).norm(), 0.02 * elsewhere.norm());
}

INSTANTIATE_TEST_SUITE_P(Kinds, Motion,
  testing::Values(NodeMotionKind::normal, NodeMotionKind::material),
  [](const auto& kind) { return kind.param == NodeMotionKind::normal ? "normal" : "material"; });

// Twice is once: only the normal part at the vertices is taken.
TEST(NormalMotion, IsAProjection)
{
  const Case c;
  const NodeMotion motion(c.surface, NodeMotionKind::normal);
  const Eigen::VectorXd u = arbitrary(3 * c.space.nodes(), 2.3), once = c.moved(motion, u);
  const Points slip = rows_of_three(c.surface.collocation().to_vertices(u - once));
  EXPECT_LT(slip.cwiseProduct(c.surface.normals).rowwise().sum().cwiseAbs().maxCoeff(), 1e-12);
}

}
}
