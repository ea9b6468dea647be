#include "solver/mesh/SizingLaw.h"

#include "tests/solver/support/TestMeshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vesicle
{
namespace
{

struct Ellipsoid
{
  TriangleMesh mesh = test::mapped(test::smooth_sphere(1280), test::ellipsoid_2_1_1);
  Connectivity around{ mesh.triangles, static_cast<int>(mesh.points.rows()) };
  Eigen::VectorXd area = Eigen::VectorXd::Zero(mesh.points.rows());
  Eigen::VectorXd curvature{ mesh.points.rows() };

  // x²/4 + y² + z² = 1: with s = x²/16 + y² + z², the meridian's curvature is 1/(4 s^(3/2)) and
  // the parallel's 1/√s.
  Ellipsoid()
  {
    for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t)
    {
      const Eigen::RowVector3d a = mesh.points.row(mesh.triangles(t, 0)),
                               b = mesh.points.row(mesh.triangles(t, 1)),
                               c = mesh.points.row(mesh.triangles(t, 2));
      for (int k = 0; k < 3; ++k)
        area[mesh.triangles(t, k)] += (b - a).cross(c - a).norm() / 6;
    }
    for (Eigen::Index i = 0; i < curvature.size(); ++i)
    {
      const Eigen::RowVector3d x = mesh.points.row(i);
      const double s = x[0] * x[0] / 16 + x[1] * x[1] + x[2] * x[2];
      curvature[i] = 1 / (16 * s * s * s) + 1 / s;
    }
  }
  Eigen::VectorXd wanted(const SizingLaw& law, int triangles) const
  {
    return wanted_edge_lengths(
      law, mesh.points, around.vertex_neighbours, curvature, area, triangles);
  }
};

TEST(SizingLaw, HasTheNumberOfTrianglesAndTheLawsRatios)
{
  const Ellipsoid e;
  for (const int triangles : { 80, 1280, 20480 })
    for (const double exponent : { 0.33, 0.5, 0.67 })
    {
      const Eigen::VectorXd h = e.wanted({ exponent, INFINITY, 1 }, triangles);
      const double count = 4 / std::numbers::sqrt3 * e.area.dot(h.cwiseAbs2().cwiseInverse());
      EXPECT_NEAR(count, triangles, 1e-3 * triangles);
      const Eigen::ArrayXd law = (e.curvature.array() + 1).pow(-exponent / 2);
      EXPECT_LT((h.array() / law / (h[0] / law[0]) - 1).abs().maxCoeff(), 1e-12);
    }
}

TEST(SizingLaw, GrowsNowhereFasterAndKeepsTheCount)
{
  const Ellipsoid e;
  const int triangles = 80;
  const Eigen::VectorXd h = e.wanted({ 2, 0.1, 1 }, triangles);
  for (const auto& [i, j] : e.around.edges)
    EXPECT_LE(std::abs(h[i] - h[j]),
      0.1 * (e.mesh.points.row(i) - e.mesh.points.row(j)).norm() * (1 + 1e-12));
  const double count = 4 / std::numbers::sqrt3 * e.area.dot(h.cwiseAbs2().cwiseInverse());
  EXPECT_NEAR(count, triangles, 1e-3 * triangles);
}

TEST(SizingLaw, ScalesAndDoesNotDependOnTheOrderOfTheVertices)
{
  const Ellipsoid e;
  const Eigen::VectorXd h = e.wanted({}, 320);
  const Eigen::VectorXd large = wanted_edge_lengths({ 0.5, 0.25, 7 }, 7 * e.mesh.points,
    e.around.vertex_neighbours, e.curvature / 49, 49 * e.area, 320);
  EXPECT_LT((large / 7 - h).cwiseAbs().maxCoeff(), 1e-12);

  const Eigen::Index n = h.size();
  TriangleMesh turned = e.mesh;
  turned.points = e.mesh.points.colwise().reverse().eval();
  turned.triangles = (static_cast<int>(n) - 1 - e.mesh.triangles.array()).matrix();
  const Connectivity around(turned.triangles, static_cast<int>(n));
  const Eigen::VectorXd other = wanted_edge_lengths(
    {}, turned.points, around.vertex_neighbours, e.curvature.reverse(), e.area.reverse(), 320);
  EXPECT_LT((other.reverse() - h).cwiseAbs().maxCoeff(), 1e-12);
}

// A sphere whose wanted length doubles from pole to pole, passes until nothing moves.
TEST(SizingLaw, EdgesFollowItsPowerThreeHalves)
{
  const TriangleMesh sphere = test::smooth_sphere(720);
  const Connectivity around(sphere.triangles, static_cast<int>(sphere.points.rows()));
  const auto length = [](const Eigen::RowVector3d& x) { return 1.5 - 0.5 * x[2]; };
  Points points = sphere.points;
  for (int pass = 0; pass < 1000; ++pass)
  {
    Eigen::VectorXd h(points.rows());
    for (Eigen::Index i = 0; i < h.size(); ++i)
      h[i] = length(points.row(i));
    points += towards_wanted(points, sphere.triangles, h);
    points.rowwise().normalize();
  }
  double mean_x = 0, mean_y = 0, xx = 0, xy = 0;
  const double count = static_cast<double>(around.edges.size());
  for (const auto& [i, j] : around.edges)
  {
    const double x = std::log(length(0.5 * (points.row(i) + points.row(j)))),
                 y = std::log((points.row(i) - points.row(j)).norm());
    mean_x += x / count;
    mean_y += y / count;
    xx += x * x / count;
    xy += x * y / count;
  }
  EXPECT_NEAR((xy - mean_x * mean_y) / (xx - mean_x * mean_x), 1.5, 0.1);
}

}
}
