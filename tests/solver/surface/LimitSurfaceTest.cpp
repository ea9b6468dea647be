#include "solver/surface/LimitSurface.h"

#include "solver/mesh/Connectivity.h"
#include "solver/surface/Collocation.h"
#include "solver/surface/LoopBasis.h"
#include "solver/surface/SurfaceIntegrals.h"
#include "tests/solver/support/TestMeshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace vesicle
{
namespace
{

// Irregular points on a body without symmetry; valences 5 and 6.
TriangleMesh bumpy()
{
  return test::mapped(test::jittered_sphere(4, 0.15), test::paper_surface);
}

SurfacePlace random_place(std::mt19937& random, int elements)
{
  std::uniform_real_distribution<double> unit(0, 1);
  Vector3 w(-std::log(unit(random)), -std::log(unit(random)), -std::log(unit(random)));
  return { static_cast<int>(random() % elements), w / w.sum() };
}

TEST(LimitSurface, GoesThroughTheVertices)
{
  const TriangleMesh mesh = bumpy();
  const LimitSurface surface(mesh);
  for (int t = 0; t < mesh.triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k)
    {
      const Vector3 x = surface.at({ t, Vector3::Unit(k) }).position;
      // Exactly but at extraordinary vertices, where the last part of 1/64 of an edge is a quartic.
      EXPECT_LT((x.transpose() - mesh.points.row(mesh.triangles(t, k))).norm(), 1e-4);
    }
}

TEST(LimitSurface, IsTheBasisOwnSurface)
{
  const TriangleMesh mesh = bumpy();
  const LimitSurface surface(mesh);
  const LoopBasis basis(mesh.triangles, static_cast<int>(mesh.points.rows()));
  const Points control = Collocation(basis).fit(mesh.points);
  std::mt19937 random(1);
  double largest = 0;
  for (int n = 0; n < 300; ++n)
  {
    const SurfacePlace place = random_place(random, static_cast<int>(mesh.triangles.rows()));
    if (place.weights.maxCoeff() > 0.98) // beyond the halvings
      continue;
    const std::vector<ParametricPoint> point{ { place.element, place.weights[1], place.weights[2],
      1 } };
    const SurfacePoints exact = evaluate(basis.tabulate(point), control);
    const LimitSurface::Point found = surface.at(place);
    largest = std::max({ largest, (found.position.transpose() - exact.position.row(0)).norm(),
      (found.tangent_u.transpose() - exact.tangent_u.row(0)).norm(),
      (found.tangent_v.transpose() - exact.tangent_v.row(0)).norm() });
  }
  // Rounding of twelve terms of size 10, and in derivatives twice as much a halving, of which there are
  // up to six.
  EXPECT_LT(largest, 12 * 10 * 64 * 2.2e-16);
}

// Over an edge between regular vertices the coordinates go on as in a plane: the point outside of one
// triangle is the point inside of the next.
TEST(LimitSurface, CarriesPlacesOverEdges)
{
  const TriangleMesh mesh = bumpy();
  const LimitSurface surface(mesh);
  const SurfacePlace outside{ 7, { 0.5, 0.6, -0.1 } };
  const SurfacePlace inside = surface.carried(outside);
  EXPECT_NE(inside.element, 7);
  EXPECT_NEAR(inside.weights.sum(), 1, 1e-15);
  EXPECT_GE(inside.weights.minCoeff(), 0);
  const SurfacePlace on_edge = surface.carried({ 7, { 0.4, 0.6, 0 } }),
                     beyond = surface.carried({ 7, { 0.4, 0.6 + 1e-9, -1e-9 } });
  EXPECT_LT((surface.at(on_edge).position - surface.at(beyond).position).norm(), 1e-8);
}

TEST(LimitSurface, FindsTheNearestPoint)
{
  const TriangleMesh mesh = bumpy();
  const LimitSurface surface(mesh);
  std::mt19937 random(2);
  for (int n = 0; n < 100; ++n)
  {
    const SurfacePlace place = random_place(random, static_cast<int>(mesh.triangles.rows()));
    const LimitSurface::Point point = surface.at(place);
    const Vector3 x = point.position + 0.02 * point.normal();
    const SurfacePlace start = surface.moved(
      place, 0.1 * point.tangent_u.normalized() - 0.05 * point.tangent_v.normalized());
    EXPECT_LT((surface.at(surface.nearest(x, start)).position - point.position).norm(), 1e-9);
  }
}

}
}
