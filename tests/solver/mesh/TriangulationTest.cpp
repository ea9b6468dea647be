#include "solver/mesh/Triangulation.h"

#include "solver/Errors.h"
#include "solver/mesh/MeshIntegrals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

namespace vesicle
{
namespace
{

Points ring(const std::vector<std::array<double, 2>>& corners)
{
  Points points(static_cast<Eigen::Index>(corners.size()), 3);
  for (std::size_t i = 0; i < corners.size(); ++i)
    points.row(static_cast<Eigen::Index>(i)) << corners[i][0], corners[i][1], 0;
  return points;
}

PolygonList polygon(std::vector<std::int64_t> corners)
{
  PolygonList list;
  list.add(corners, 5);
  return list;
}

PolygonList whole(const Points& points)
{
  std::vector<std::int64_t> corners(points.rows());
  std::iota(corners.begin(), corners.end(), 0);
  return polygon(corners);
}

TriangleMesh cut(const Points& points, const PolygonList& polygons)
{
  return { points, triangulate(points, polygons, "mesh").triangles };
}

double vector_area(const TriangleMesh& mesh)
{
  Vector3 area = Vector3::Zero();
  for (int t = 0; t < mesh.triangles.rows(); ++t)
  {
    const auto [a, b, c] = corners(mesh, t);
    area += (b - a).cross(c - a) / 2;
  }
  return area.norm();
}

/// All triangles face the same way and fill the ring.
void expect_filled(const Points& points, double area)
{
  const TriangleMesh mesh = cut(points, whole(points));
  EXPECT_EQ(mesh.triangles.rows(), points.rows() - 2);
  EXPECT_NEAR(flat_area(mesh), area, 1e-12 * area);
  EXPECT_NEAR(vector_area(mesh), area, 1e-12 * area);
}

double least_area(const TriangleMesh& mesh)
{
  double least = 1e300;
  for (int t = 0; t < mesh.triangles.rows(); ++t)
  {
    const auto [a, b, c] = corners(mesh, t);
    least = std::min(least, (b - a).cross(c - a).norm() / 2);
  }
  return least;
}

}

TEST(Triangulation, ConcavePolygonsAreFilled)
{
  expect_filled(ring({ { 2, 0 }, { 2, 1 }, { 1, 1 }, { 1, 2 }, { 0, 2 }, { 0, 0 } }), 3);
  expect_filled(ring({ { 0, 0 }, { 1, 0 }, { 0.2, 0.2 }, { 0, 1 } }), 0.2); // a dart
  expect_filled(ring({ { 1, 0 }, { 0.2, 0.2 }, { 0, 1 }, { 0, 0 } }), 0.2);
  // A comb.
  std::vector<std::array<double, 2>> comb{ { 0, 0 }, { 20, 0 } };
  for (int i = 20; i > 0; --i)
  {
    comb.push_back({ i - 0.25, 5. });
    comb.push_back({ i - 0.75, 1. });
  }
  comb.push_back({ 0, 5 });
  const Points points = ring(comb);
  double area = 0;
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    const Eigen::Index j = (i + 1) % points.rows();
    area += (points(i, 0) * points(j, 1) - points(j, 0) * points(i, 1)) / 2;
  }
  expect_filled(points, area);
}

TEST(Triangulation, StarsOfAnySizeAndPlaneAreFilled)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> radius(0.2, 1);
  for (const int n : { 5, 8, 33, 1000 })
  {
    const Vector3 x = Vector3(radius(random), -radius(random), 1).normalized();
    const Vector3 y = x.unitOrthogonal();
    Points points(n, 3);
    double area = 0;
    std::vector<double> r(n);
    for (double& value : r)
      value = radius(random);
    const double angle = 2 * std::numbers::pi / n;
    for (int i = 0; i < n; ++i)
    {
      points.row(i) =
        (Vector3(1e3, 5, 7) + r[i] * (std::cos(i * angle) * x + std::sin(i * angle) * y))
          .transpose();
      area += r[i] * r[(i + 1) % n] * std::sin(angle) / 2;
    }
    const TriangleMesh mesh = cut(points, whole(points));
    EXPECT_EQ(mesh.triangles.rows(), n - 2);
    EXPECT_NEAR(flat_area(mesh), area, 1e-9) << n;
    EXPECT_NEAR(vector_area(mesh), area, 1e-9) << n;
  }
}

// A neighbour has the corner, too.
TEST(Triangulation, CornersOnAStraightSideStayAndNoTriangleIsALine)
{
  const Points points = ring(
    { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 3, 0 }, { 3, 3 }, { 2, 3 }, { 0, 3 }, { 0, 2 }, { 0, 1 } });
  expect_filled(points, 9);
  EXPECT_GT(least_area(cut(points, whole(points))), 0.1);
  const Points triangle = ring({ { 0, 0 }, { 0.3, 0 }, { 1, 0 }, { 0, 1 } });
  expect_filled(triangle, 0.5);
  EXPECT_GT(least_area(cut(triangle, whole(triangle))), 0.1);
}

TEST(Triangulation, RepeatedCornersCountOnce)
{
  const Points points = ring({ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } });
  const auto triangles = [&](std::vector<std::int64_t> corners)
  { return cut(points, polygon(std::move(corners))).triangles.rows(); };
  EXPECT_EQ(triangles({ 0, 1, 1, 2 }), 1);
  EXPECT_EQ(triangles({ 0, 0, 1, 2, 2, 0 }), 1);
  EXPECT_EQ(triangles({ 0, 1, 2, 3, 2 }), 1) << "a side that runs back";
  EXPECT_EQ(triangles({ 2, 0, 1, 2, 3, 3 }), 1) << "around the end";
  EXPECT_EQ(triangles({ 0, 1, 1 }), 0);
  EXPECT_EQ(triangles({ 0, 1 }), 0);
  EXPECT_EQ(triangles({}), 0);
  EXPECT_EQ(triangles(std::vector<std::int64_t>(300000, 2)), 0);
}

TEST(Triangulation, TrianglesOfPolygonsThatComeBackToACornerHaveThree)
{
  std::mt19937 random(1);
  const Points points = ring({ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 }, { 0.5, 0.25 } });
  for (int round = 0; round < 1000; ++round)
  {
    std::vector<std::int64_t> corners(4 + random() % 6);
    for (auto& corner : corners)
      corner = random() % 5;
    const TriangleMesh mesh = cut(points, polygon(corners));
    for (const auto& triangle : mesh.triangles.rowwise())
      EXPECT_TRUE(
        triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0]);
  }
}

TEST(Triangulation, CellsFollowTheirTriangles)
{
  const Points points = ring({ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } });
  PolygonList list = polygon({ 0, 1, 2, 3 });
  list.add(std::array<std::int64_t, 3>{ 0, 1, 2 }, 9);
  EXPECT_EQ(triangulate(points, list, "mesh").cell, (std::vector<std::int64_t>{ 5, 5, 9 }));
}

TEST(Triangulation, SidesThatCrossAndDegeneratePolygonsAreNoHang)
{
  std::mt19937 random(2);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int round = 0; round < 300; ++round)
  {
    const int n = 4 + round % 40;
    Points points(n, 3);
    for (double& x : points.reshaped())
      x = round % 3 == 0 ? std::round(2 * any(random)) : any(random);
    const TriangleMesh mesh = cut(points, whole(points));
    EXPECT_LE(mesh.triangles.rows(), n - 2);
  }
  Points line = Points::Zero(200, 3);
  for (int i = 0; i < 200; ++i)
    line(i, 0) = i;
  EXPECT_EQ(cut(line, whole(line)).triangles.rows(), 198);
  Points noise(100000, 3);
  for (double& x : noise.reshaped())
    x = any(random);
  EXPECT_THROW(cut(noise, whole(noise)), InputError);
}

}
