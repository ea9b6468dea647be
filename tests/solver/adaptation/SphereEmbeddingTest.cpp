#include "solver/adaptation/SphereEmbedding.h"

#include "solver/mesh/MeshQuality.h"
#include "tests/solver/support/TestMeshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vesicle
{
namespace
{

// Two balls and a neck of a fifth of their radius.
TriangleMesh dumbbell()
{
  const auto shape = [](const Vector3& n) -> Vector3
  {
    const double radius = 0.2 + 0.8 * n.z() * n.z();
    return { radius * n.x(), radius * n.y(), 2.5 * n.z() };
  };
  return test::mapped(test::smooth_sphere(1280), shape);
}

Eigen::VectorXd ones(const TriangleMesh& mesh)
{
  return Eigen::VectorXd::Ones(mesh.points.rows());
}

TEST(SphereEmbedding, KeepsTheSphereButForATurn)
{
  const TriangleMesh mesh = test::smooth_sphere(320);
  const Points directions = SphereEmbedding(mesh, ones(mesh)).directions();
  for (const auto t : mesh.triangles.rowwise())
    for (int k = 0; k < 3; ++k)
    {
      const int i = t[k], j = t[(k + 1) % 3];
      EXPECT_NEAR(directions.row(i).dot(directions.row(j)),
        mesh.points.row(i).normalized().dot(mesh.points.row(j).normalized()), 0.02);
    }
}

TEST(SphereEmbedding, CoversTheSphereOnceAndBalanced)
{
  const std::vector<TriangleMesh> meshes{ dumbbell(),
    test::mapped(test::jittered_sphere(4, 0.15), test::paper_surface) };
  for (const TriangleMesh& mesh : meshes)
  {
    const SphereEmbedding embedding(mesh, ones(mesh));
    EXPECT_LT(embedding.directions().colwise().mean().norm(), 1e-9);
    double solid_angle = 0; // A. van Oosterom, J. Strackee (1983)
    for (const auto t : mesh.triangles.rowwise())
    {
      const Vector3 a = embedding.directions().row(t[0]), b = embedding.directions().row(t[1]),
                    c = embedding.directions().row(t[2]);
      EXPECT_GT(a.dot(b.cross(c)), 0);
      solid_angle += 2 * std::atan2(a.dot(b.cross(c)), 1 + a.dot(b) + b.dot(c) + c.dot(a));
    }
    EXPECT_NEAR(solid_angle, 4 * std::numbers::pi, 1e-9);
  }
}

TEST(SphereEmbedding, FindsTheTriangleUnderADirection)
{
  const TriangleMesh mesh = dumbbell();
  SphereEmbedding embedding(mesh, ones(mesh));
  embedding.permute_axes();
  const Points sphere = test::smooth_sphere(1280).points;
  for (const auto d : sphere.rowwise())
  {
    const Vector3 direction = Vector3(d.transpose()).normalized();
    const SurfacePlace place = embedding.place(direction, 0);
    Vector3 found = Vector3::Zero();
    for (int k = 0; k < 3; ++k)
      found += place.weights[k] * embedding.directions().row(mesh.triangles(place.element, k));
    EXPECT_LT((found.normalized() - direction).norm(), 1e-9);
  }
}

}
}
