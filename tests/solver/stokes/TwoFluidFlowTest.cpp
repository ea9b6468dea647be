// The flow of a rising drop against Hadamard's and Rybczynski's, inside, outside and near it.

#include "solver/stokes/TwoFluidFlow.h"

#include "tests/solver/support/TestMeshes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vesicle
{
namespace
{

/// Of radius 1, its surface loaded with z n: Lamb's solutions to both sides, with the drop's own
/// velocity in the fluid at rest.
struct Drop
{
  double ratio;
  double speed() const { return 2. / 3 * (1 + ratio) / (2 + 3 * ratio); }

  /// Outside a Stokeslet α (e/r + x z/r³) and a source dipole β (e/r³ − 3 x z/r⁵): the normal speed at
  /// the surface is U z, the drag 4π/3 = 8π α.
  Vector3 velocity(const Vector3& x) const
  {
    const double U = speed(), r = x.norm(), z = x.z();
    const Vector3 e = Vector3::UnitZ();
    if (r > 1)
    {
      const double alpha = 1. / 6, beta = alpha - U / 2;
      return alpha * (e / r + z / std::pow(r, 3) * x) +
        beta * (e / std::pow(r, 3) - 3 * z / std::pow(r, 5) * x);
    }
    // Hill's vortex: U e + γ ((1 − 2 r²) e + z x), with the same velocity at the surface.
    const double tangential = 1. / 6 + 1. / 6 - U / 2; // the factor of e at the surface
    const double gamma = U - tangential;
    return (U + gamma) * e + gamma * (z * x - 2 * r * r * e);
  }
};

Points sampled(const Points& at, const std::function<Vector3(const Vector3&)>& field)
{
  Points values(at.rows(), 3);
  for (Eigen::Index i = 0; i < at.rows(); ++i)
    values.row(i) = field(at.row(i).transpose()).transpose();
  return values;
}

TEST(TwoFluidFlow, OfADropIsHadamardsAndRybczynskis)
{
  const double distances[] = { -0.9, -0.3, -1e-2, -1e-4, -1e-7, 1e-7, 1e-4, 1e-2, 0.3, 2 };
  const Vector3 directions[] = { { 0.3, 0.2, 0.9 }, { 1, 0.1, -0.2 }, { -0.5, 0.7, 0.4 } };
  for (const double ratio : { 0.2, 5., 100. })
  {
    const Drop drop{ ratio };
    double error[2];
    for (int level = 0; level < 2; ++level)
    {
      const TriangleMesh mesh = test::smooth_sphere(level == 0 ? 320 : 1280);
      const TwoFluidFlow flow(mesh, SurfaceBasis::loop,
        sampled(mesh.points, [](const Vector3& x) -> Vector3 { return x.z() * x; }),
        sampled(mesh.points, [&](const Vector3& x) { return drop.velocity(x); }), 1, ratio);
      Points points(30, 3);
      int row = 0;
      for (const Vector3& direction : directions)
        for (const double distance : distances)
          points.row(row++) = (1 + distance) * direction.normalized().transpose();
      const FlowField::Flow found = flow.at(points, Points::Zero(30, 3));
      error[level] = 0;
      for (int i = 0; i < 30; ++i)
      {
        const Vector3 x = points.row(i).transpose();
        const bool by_the_mesh = std::abs(x.norm() - 1) < 1e-3; // whose surface isn't the sphere
        EXPECT_TRUE(by_the_mesh || (found.inside[i] != 0) == (x.norm() < 1));
        error[level] = std::max(error[level],
          (found.velocity.row(i).transpose() - drop.velocity(x)).norm() / drop.speed());
      }
    }
    EXPECT_LT(error[1], 5e-4) << ratio;
    EXPECT_GT(test::order(error[0], error[1]), 1.5) << ratio << ": " << error[0] << " " << error[1];
  }
}

TEST(TwoFluidFlow, OfOneFluidNeedsNoVelocities)
{
  const TriangleMesh mesh = test::smooth_sphere(320);
  const Points force = sampled(mesh.points, [](const Vector3& x) -> Vector3 { return x.z() * x; });
  const TwoFluidFlow flow(mesh, SurfaceBasis::loop, force, {}, 2, 1);
  const Points points = Points::Constant(1, 3, 0.9), imposed = Points::Constant(1, 3, 3);
  const Points alone =
    TwoFluidFlow(mesh, SurfaceBasis::loop, force, {}, 1, 1).at(points, Points::Zero(1, 3)).velocity;
  EXPECT_LT((flow.at(points, imposed).velocity - imposed - alone / 2).norm(), 1e-15);
}

// A gas: the fluid inside has no viscosity, and what it does isn't known.
TEST(TwoFluidFlow, AroundAGasIsFinite)
{
  const TriangleMesh mesh = test::smooth_sphere(320);
  const Drop bubble{ 0 };
  const TwoFluidFlow flow(mesh, SurfaceBasis::loop,
    sampled(mesh.points, [](const Vector3& x) -> Vector3 { return x.z() * x; }),
    sampled(mesh.points, [&](const Vector3& x) { return bubble.velocity(x); }), 1, 0);
  Points points(2, 3);
  points << 0, 0.1, 0.2, 0, 0.5, 1.2;
  const Points velocity = flow.at(points, Points::Zero(2, 3)).velocity;
  EXPECT_TRUE(velocity.row(0).isZero());
  const Vector3 exact = bubble.velocity(points.row(1).transpose());
  EXPECT_LT((velocity.row(1).transpose() - exact).norm(), 1e-3 * bubble.speed());
}

}
}
