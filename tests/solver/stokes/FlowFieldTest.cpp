#include "solver/stokes/MembraneFlow.h"

#include "solver/stokes/StokesOperator.h"
#include "tests/solver/support/TestMeshes.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/task_arena.h>

#include <cmath>
#include <numbers>
#include <random>

namespace vesicle
{
namespace
{

using test::mapped;
using test::smooth_sphere;

// Unit sphere moving with e_z in a fluid of viscosity 1: density, and velocity (Stokes; Happel &
// Brenner 4-17).
const Vector3 translation(0, 0, 1);
const Vector3 drag_density(0, 0, 1.5);

Vector3 stokes_sphere(const Vector3& x)
{
  const double r = std::max(x.norm(), 1.);
  const Vector3 n = x.normalized();
  if (x.norm() <= 1)
    return translation;
  return 0.75 / r * (translation + n * n.dot(translation)) +
    0.25 / (r * r * r) * (translation - 3 * n * n.dot(translation));
}

Points uniform(const TriangleMesh& mesh, const Vector3& density)
{
  return density.transpose().replicate(mesh.points.rows(), 1);
}

const double distances[] = { 2, 0.5, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6 };

// Points over the surface of `panels` at a distance along the normal, at corners, on edges, near
// them and elsewhere.
Points beside(const SurfacePanels& panels, double distance, int count)
{
  std::mt19937 random(17);
  std::uniform_real_distribution<double> share(0, 1);
  Points points(count, 3);
  for (int i = 0; i < count; ++i)
  {
    double u = share(random), v = share(random);
    if (u + v > 1)
      u = 1 - u, v = 1 - v;
    v *= i % 3 == 0 ? 0 : i % 3 == 1 ? 1e-4 : 1;
    const int panel = static_cast<int>(random() % static_cast<std::uint_fast32_t>(panels.size()));
    const auto frame = panels.frame(panel, u, v);
    points.row(i) = (frame.position + distance * frame.cross().normalized()).transpose();
  }
  return points;
}

// The mesh's flat triangles.
SurfacePanels flat_panels(const TriangleMesh& mesh)
{
  const LinearBasis basis(mesh.triangles, static_cast<int>(mesh.points.rows()));
  return { basis, mesh.points, [](const BasisTable& table, const SurfacePoints&) -> RowVectors {
            return RowVectors::Zero(table.rows(), 3);
          } };
}

double largest_error(const FlowField& field, const Points& points)
{
  const Points velocity = field.at(points).velocity;
  double error = 0;
  for (int i = 0; i < points.rows(); ++i)
    error = std::max(
      error, (velocity.row(i).transpose() - stokes_sphere(points.row(i).transpose())).norm());
  return error;
}

struct SphereErrors
{
  double far, near, inside, on;
  SphereErrors(int triangles, SurfaceBasis basis)
  {
    const TriangleMesh mesh = smooth_sphere(triangles);
    const FlowField field = membrane_flow(mesh, basis, uniform(mesh, drag_density));
    const SurfacePanels surface = flat_panels(mesh);
    // The unit sphere's points, whatever the mesh.
    const auto sphere_points = [&](double distance) -> Points
    { return (1 + distance) * beside(surface, 0, 60).rowwise().normalized(); };
    far = near = inside = 0;
    for (double d : distances)
    {
      double& outside = d > 0.2 ? far : near;
      outside = std::max(outside, largest_error(field, sphere_points(d)));
      if (d < 1)
        inside = std::max(inside, largest_error(field, sphere_points(-d)));
    }
    on = largest_error(field, sphere_points(0));
  }
};

TEST(FlowField, RigidSphereByLinearElements)
{
  const SphereErrors coarse(320, SurfaceBasis::linear), fine(1280, SurfaceBasis::linear);
  // Flat triangles are off by h² in position, and so is everything.
  EXPECT_GT(test::order(coarse.far, fine.far), 1.8) << coarse.far << ' ' << fine.far;
  EXPECT_GT(test::order(coarse.near, fine.near), 1.8) << coarse.near << ' ' << fine.near;
  EXPECT_GT(test::order(coarse.inside, fine.inside), 1.8) << coarse.inside << ' ' << fine.inside;
  EXPECT_GT(test::order(coarse.on, fine.on), 1.8) << coarse.on << ' ' << fine.on;
  EXPECT_LT(std::max({ fine.far, fine.near, fine.inside, fine.on }), 8e-3);
}

TEST(FlowField, RigidSphereByLoopSurface)
{
  const SphereErrors coarse(320, SurfaceBasis::loop), fine(1280, SurfaceBasis::loop);
  EXPECT_GT(test::order(coarse.far, fine.far), 3) << coarse.far << ' ' << fine.far;
  // Close by, the surface at the twelve vertices of valence five tells: the order is lower.
  EXPECT_GT(test::order(coarse.near, fine.near), 1.8) << coarse.near << ' ' << fine.near;
  EXPECT_GT(test::order(coarse.inside, fine.inside), 1.8) << coarse.inside << ' ' << fine.inside;
  EXPECT_LT(fine.far, 1e-5);
  EXPECT_LT(std::max({ fine.near, fine.inside, fine.on }), 3e-4);
}

// Whatever surface and density: no jump, and a slope that the density's own scale bounds.
TEST(FlowField, ContinuousAcrossTheSurface)
{
  const TriangleMesh mesh = mapped(smooth_sphere(320), test::ellipsoid_2_1_1);
  Points forces = uniform(mesh, { 1, 0, 0 });
  for (int i = 0; i < mesh.points.rows(); ++i)
    forces.row(i) += mesh.points(i, 2) * mesh.points.row(i);
  const FlowField field = membrane_flow(mesh, SurfaceBasis::linear, forces);
  const SurfacePanels surface = flat_panels(mesh);
  const Points on = field.at(beside(surface, 0, 60)).velocity;
  for (double d : { 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-9 })
    for (double side : { -1., 1. })
    {
      const Points off = field.at(beside(surface, side * d, 60)).velocity;
      EXPECT_LT((off - on).rowwise().norm().maxCoeff(), 4 * d + 2e-7) << side * d;
    }
}

TEST(FlowField, InsideOrOutsideAtEveryDistance)
{
  const TriangleMesh mesh = mapped(smooth_sphere(320), test::ellipsoid_2_1_1);
  for (auto basis : { SurfaceBasis::linear, SurfaceBasis::loop })
  {
    const FlowField field = membrane_flow(mesh, basis, uniform(mesh, drag_density));
    // Loop's surface stands out from the flat triangles by some h²/8R.
    for (double d : { 10., 3., 1., 0.5, 0.1, 1e-3, 1e-5, 1e-6 })
    {
      if (basis == SurfaceBasis::loop && d < 0.05)
        continue;
      const Points outside = beside(flat_panels(mesh), d, 60);
      for (unsigned char inside : field.at(outside).inside)
        EXPECT_EQ(inside, 0) << d;
      if (d > 0.45) // the radius of curvature at the tips is 0.5
        continue;
      for (unsigned char inside : field.at(beside(flat_panels(mesh), -d, 60)).inside)
        EXPECT_EQ(inside, 1) << d;
    }
    const Points axis =
      Eigen::RowVector3d(1, 0, 0).replicate(3, 1).array().colwise() * Eigen::Array3d(0, 1.2, 1.9);
    for (unsigned char inside : field.at(axis).inside)
      EXPECT_EQ(inside, 1);
  }
}

// The same integral by another program: the collocation matrix, at the vertices.
TEST(FlowField, AgreesWithTheSingleLayerAtTheVertices)
{
  const TriangleMesh mesh = mapped(smooth_sphere(320), test::ellipsoid_2_1_1);
  Points forces = uniform(mesh, { 1, 0, 0 });
  for (int i = 0; i < mesh.points.rows(); ++i)
    forces.row(i) += mesh.points(i, 2) * mesh.points.row(i);
  const Points velocity =
    membrane_flow(mesh, SurfaceBasis::linear, forces).at(mesh.points).velocity;
  double error[2];
  for (int level = 0; level < 2; ++level)
  {
    const LinearBasis basis(mesh.triangles, static_cast<int>(mesh.points.rows()));
    const LayerRules rules(basis, { level == 0 ? 3 : 12, 0, 0, 4, 8 });
    const StokesOperator layer({ { &rules, mesh.points, mesh.points } });
    const Eigen::VectorXd u = layer.apply(std::array{ nodal_density(forces) });
    error[level] =
      (u.reshaped<Eigen::RowMajor>(velocity.rows(), 3) - velocity).rowwise().norm().maxCoeff();
  }
  EXPECT_LT(error[1], error[0] / 10); // the layer's own quadrature is what differs
  EXPECT_LT(error[1], 5e-5);
}

TEST(FlowField, PressureMovesNothing)
{
  const TriangleMesh mesh = mapped(smooth_sphere(1280), test::perturbed_sphere);
  const Points normal = [&]
  {
    // n of r = 1 + 0.2 Y20 by the gradient of r − 1 − 0.2 Y20.
    Points n(mesh.points.rows(), 3);
    for (int i = 0; i < n.rows(); ++i)
    {
      const Vector3 x = mesh.points.row(i).transpose();
      const double r = x.norm(), c = 0.2 * std::sqrt(5 / (16 * std::numbers::pi));
      const Vector3 gradient = x / r -
        c * (6 * x.z() / (r * r) * Vector3(0, 0, 1) - 6 * x.z() * x.z() / (r * r * r * r) * x);
      n.row(i) = gradient.normalized().transpose();
    }
    return n;
  }();
  const FlowField field = membrane_flow(mesh, SurfaceBasis::loop, normal);
  for (double d : { -0.3, -1e-3, -1e-6, 0., 1e-6, 1e-3, 0.3 })
    EXPECT_LT(field.at(beside(flat_panels(mesh), d, 40)).velocity.rowwise().norm().maxCoeff(), 2e-4)
      << d;
}

TEST(FlowField, ResultsDontDependOnTheNumberOfThreads)
{
  const TriangleMesh mesh = smooth_sphere(320);
  const FlowField field = membrane_flow(mesh, SurfaceBasis::loop, uniform(mesh, drag_density));
  const Points points = beside(flat_panels(mesh), 1e-2, 100);
  FlowField::Flow alone;
  oneapi::tbb::task_arena(1).execute([&] { alone = field.at(points); });
  const FlowField::Flow together = field.at(points);
  EXPECT_EQ(alone.velocity, together.velocity);
  EXPECT_EQ(alone.inside, together.inside);
}

}
}
