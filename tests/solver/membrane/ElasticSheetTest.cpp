// Elastic sheets whose tensions are known.

#include "solver/membrane/ElasticSheet.h"

#include "tests/solver/support/TestMeshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace vesicle
{
namespace
{

struct Law
{
  const char* name;
  ElasticModuli moduli;
  std::function<double(double)>
    inflated; ///< tension of a sphere whose lengths have grown by a factor
};

const Law laws[] = {
  { "neo-Hookean", { ElasticLaw::neo_hookean, 2, 0 },
    [](double l) { return 2 * (1 - std::pow(l, -6)); } },
  { "Skalak", { ElasticLaw::skalak, 2, 3 },
    [](double l) { return 2 * ((l * l - 1) + 3 * l * l * (std::pow(l, 4) - 1)); } },
};

// The work of inflating it, g·x dλ/λ = 2 T A dλ/λ, T the tension and A the area.
TEST(ElasticSheet, AnInflatedSphereHasItsTension)
{
  const TriangleMesh mesh = test::smooth_sphere(320);
  const SurfaceSpace space(
    SurfaceBasis::loop, mesh.triangles, static_cast<int>(mesh.points.rows()));
  for (const Law& law : laws)
    for (const double stretch : { 0.9, 1., 1.05, 1.5 })
    {
      const ElasticSheet sheet(law.moduli, space, mesh.points);
      const Surface surface(space, stretch * mesh.points);
      const double work = sheet.variation(surface).gradient.dot(flat(surface.control));
      EXPECT_NEAR(work / (2 * surface.area), law.inflated(stretch), 1e-12)
        << law.name << ", " << stretch;
    }
}

// Turned and moved, a sheet has no stress.
TEST(ElasticSheet, ARigidMotionTakesNoEnergy)
{
  const TriangleMesh mesh = test::mapped(test::smooth_sphere(320),
    [](const Vector3& d) -> Vector3 {
      return { 1.4 * d.x(), d.y() + 0.2 * d.z(), 0.8 * d.z() };
    });
  const SurfaceSpace space(
    SurfaceBasis::loop, mesh.triangles, static_cast<int>(mesh.points.rows()));
  const Eigen::Matrix3d rotation =
    Eigen::AngleAxisd(0.7, Vector3(1, 2, 3).normalized()).toRotationMatrix();
  const Points moved = (mesh.points * rotation.transpose()).rowwise() + Eigen::RowVector3d(3, 2, 1);
  for (const Law& law : laws)
  {
    const ElasticSheet sheet(law.moduli, space, mesh.points);
    const Surface at_rest(space, mesh.points), surface(space, moved);
    EXPECT_NEAR(sheet.energy(surface), sheet.energy(at_rest), 1e-12);
    EXPECT_LT(sheet.variation(surface).gradient.norm(), 1e-12) << law.name;
  }
}

// A sphere drawn out to a spheroid.
TEST(ElasticSheet, AffineStretchesHaveTheirEnergy)
{
  const TriangleMesh mesh = test::smooth_sphere(1280);
  const SurfaceSpace space(
    SurfaceBasis::loop, mesh.triangles, static_cast<int>(mesh.points.rows()));
  const double stretch = 1.3;
  Points moved = mesh.points;
  moved.col(2) *= stretch;
  // At the polar angle θ the stretches are √(cos²θ + λ² sin²θ) along the meridian and 1 around.
  for (const Law& law : laws)
  {
    const auto density = [&](double sine)
    {
      const double square = 1 - sine * sine + stretch * stretch * sine * sine, i1 = square - 1,
                   i2 = square - 1, G = law.moduli.shear, C = law.moduli.dilation;
      return law.moduli.law == ElasticLaw::skalak
        ? G / 4 * (i1 * i1 + 2 * i1 - 2 * i2 + C * i2 * i2)
        : G / 2 * (i1 - 1 + 1 / (i2 + 1));
    };
    double exact = 0;
    constexpr int parts = 2000; // of the midpoint rule, good for 1e-7
    for (int i = 0; i < parts; ++i)
    {
      const double angle = std::numbers::pi * (i + 0.5) / parts;
      exact += 2 * std::numbers::pi * std::sin(angle) * density(std::sin(angle)) *
        std::numbers::pi / parts;
    }
    const ElasticSheet sheet(law.moduli, space, mesh.points);
    EXPECT_NEAR(sheet.energy(Surface(space, moved)) / exact, 1, 2e-4) << law.name;
  }
}

// Without stress there is nothing else in it: how the gradient follows a displacement.
TEST(ElasticSheet, ItsRatesAreTheSecondVariationAtRest)
{
  const TriangleMesh mesh = test::mapped(test::smooth_sphere(320),
    [](const Vector3& d) -> Vector3 {
      return { 1.4 * d.x(), d.y() + 0.2 * d.z(), 0.8 * d.z() };
    });
  const SurfaceSpace space(
    SurfaceBasis::loop, mesh.triangles, static_cast<int>(mesh.points.rows()));
  const Points direction = test::mapped(mesh,
    [](const Vector3& x) -> Vector3 {
      return { x.y() * x.z(), x.x() - x.z() * x.z(), 0.5 * x.x() * x.y() + x.z() };
    }).points;
  const double step = 1e-5;
  for (const Law& law : laws)
  {
    const ElasticSheet sheet(law.moduli, space, mesh.points);
    const auto gradient = [&](double t)
    { return sheet.variation(Surface(space, mesh.points + t * direction)).gradient; };
    const Eigen::VectorXd difference = (gradient(step) - gradient(-step)) / (2 * step);
    const Surface at_rest(space, mesh.points);
    const Eigen::VectorXd predicted =
      gauss_newton_matrix(space.table(), sheet.variation(at_rest).rates) *
      at_rest.to_control(flat(direction));
    EXPECT_LT((difference - predicted).norm(), 1e-7 * predicted.norm()) << law.name;
  }
}

}
}
