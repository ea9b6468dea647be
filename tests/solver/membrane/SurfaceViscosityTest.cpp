// What a viscous membrane dissipates, where that is known.

#include "solver/membrane/SurfaceViscosity.h"

#include "tests/solver/support/TestMeshes.h"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <array>
#include <numbers>

namespace vesicle
{
namespace
{

/// Velocities A x of a surface's control points, which are those of all its points.
Eigen::VectorXd affine(const Surface& surface, const Eigen::Matrix3d& A)
{
  return flat(Points(surface.control * A.transpose()));
}

double dissipation(const Surface& surface, const Eigen::VectorXd& velocity)
{
  return velocity.dot(viscosity_matrix(surface, 1) * velocity);
}

TriangleMesh body()
{
  return test::mapped(test::smooth_sphere(320),
    [](const Vector3& d) -> Vector3 {
      return { 1.5 * d.x() + 0.2 * d.z(), 0.8 * d.y(), 0.8 * d.z() + 0.1 * d.x() * d.x() };
    });
}

SurfaceSpace space_of(const TriangleMesh& mesh)
{
  return { SurfaceBasis::loop, mesh.triangles, static_cast<int>(mesh.points.rows()) };
}

// A translation, a turn, a growth of all lengths alike: none of them shears.
TEST(SurfaceViscosity, ResistsShearAlone)
{
  const TriangleMesh mesh = body();
  const SurfaceSpace space = space_of(mesh);
  const Surface surface(space, mesh.points);
  Eigen::Matrix3d turn;
  turn << 0, -3, 2, 3, 0, -1, -2, 1, 0;
  for (const Eigen::VectorXd& u : { flat(Points(Points::Ones(mesh.points.rows(), 3))).eval(),
         affine(surface, turn), affine(surface, Eigen::Matrix3d::Identity()) })
    EXPECT_LT((viscosity_matrix(surface, 1) * u).norm(), 1e-12 * u.norm());
}

TEST(SurfaceViscosity, IsSymmetricAndNeverNegative)
{
  const TriangleMesh mesh = body();
  const SurfaceSpace space = space_of(mesh);
  const SparseMatrix V = viscosity_matrix(Surface(space, mesh.points), 3);
  EXPECT_LT((V - SparseMatrix(V.transpose())).norm(), 1e-13 * V.norm());
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(
    Eigen::MatrixXd(V), Eigen::EigenvaluesOnly);
  EXPECT_GT(eigen.eigenvalues()[0], -1e-12 * eigen.eigenvalues().tail(1)[0]);
}

// On a sphere of radius a the strain E x has P E P less half its trace along the surface, whose square
// is ⅖ E:E on average.
TEST(SurfaceViscosity, ASphereThatIsStrained)
{
  Eigen::Matrix3d E;
  E << 1, 0.5, 0, 0.5, -2, 0.3, 0, 0.3, 1;
  const double radius = 2,
               exact = 2 * 0.4 * E.squaredNorm() * 4 * std::numbers::pi * radius * radius;
  std::array<double, 2> error;
  for (int level = 0; level < 2; ++level)
  {
    const TriangleMesh mesh = test::smooth_sphere(level == 0 ? 320 : 1280);
    const SurfaceSpace space = space_of(mesh);
    const Surface surface(space, radius * mesh.points);
    error[level] = std::abs(dissipation(surface, affine(surface, E)) / exact - 1);
  }
  EXPECT_LT(error[1], 1e-4);
  EXPECT_GT(test::order(error[0], error[1]), 1.8) << error[0] << " " << error[1];
}

}
}
