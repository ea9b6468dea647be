// One vesicle between two fluids, at its first instant, against exact values; and what that costs.

#include "solver/flow/Shear.h"
#include "solver/mesh/shapes/ShapeRequest.h"
#include "solver/mesh/shapes/Shapes.h"
#include "solver/simulation/Simulation.h"
#include "solver/simulation/StartMesh.h"
#include "tests/solver/support/TestMeshes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace vesicle
{
namespace
{

/// Rising by its weight, Bo = 1.
Scene rising(double viscosity_ratio, bool incompressible)
{
  Scene scene;
  scene.gravity = Scene::Gravity{};
  scene.gravity->bond_number = 1;
  scene.time.end = 1;
  scene.membrane.incompressible = incompressible;
  scene.fluid.viscosity_ratio = viscosity_ratio;
  return scene;
}

TriangleMesh sphere(int triangles)
{
  ShapeRequest request;
  request.triangles = triangles;
  return make_shape(request);
}

Diagnostics first_instant(const Scene& scene, TriangleMesh mesh)
{
  Simulation simulation(scene, std::move(mesh));
  return simulation.diagnose(simulation.start());
}

/// In EB/μ r0², of the surface's own r0.
double speed(const Scene& scene, TriangleMesh mesh)
{
  const Diagnostics d = first_instant(scene, std::move(mesh));
  return d.velocity[2] * std::pow(3 * d.volume / (4 * std::numbers::pi), 2. / 3);
}

// A drop rises with Hadamard's and Rybczynski's speed.
TEST(ViscosityRatio, ADropRisesAtItsSpeed)
{
  for (const double ratio : { 0., 0.2, 1., 5., 50., 1000. })
  {
    const double exact = 2. / 3 * (1 + ratio) / (2 + 3 * ratio);
    std::array<double, 2> error;
    for (int level = 0; level < 2; ++level)
      error[level] =
        std::abs(speed(rising(ratio, false), sphere(level == 0 ? 320 : 1280)) / exact - 1);
    EXPECT_LT(error[1], 4e-5) << ratio;
    EXPECT_GT(test::order(error[0], error[1]), 1.6) << ratio << ": " << error[0] << " " << error[1];
  }
}

// Nothing moves within a sphere that can't deform.
TEST(ViscosityRatio, AnInextensibleSphereRisesAsARigidOne)
{
  for (const double ratio : { 0., 0.2, 1., 5., 1000. })
    EXPECT_NEAR(speed(rising(ratio, true), sphere(1280)) / (2. / 9), 1, 1e-4) << ratio;
}

// By a spectral method in spherical harmonics.
TEST(ViscosityRatio, AProlateStartsToRise)
{
  const std::array<std::array<double, 2>, 4> reference{ { { 0.2, 1.09528 }, { 1, 1.07502 },
    { 5, 1.05327 }, { 50, 1.04315 } } };
  for (const auto& [ratio, factor] : reference)
  {
    Scene scene = rising(ratio, true);
    scene.vesicle.shape.kind = ShapeRequest::Kind::prolate;
    scene.vesicle.shape.reduced_volume = 0.95;
    scene.vesicle.shape.triangles = 1280;
    EXPECT_NEAR(speed(scene, make_start_mesh(scene)) / (2. / 9), factor, 3e-5) << ratio;
  }
}

/// In shear, with bending, off the planes of symmetry.
Scene sheared(double viscosity_ratio)
{
  Scene scene;
  scene.membrane.bending_rigidity = 1;
  scene.fluid.viscosity_ratio = viscosity_ratio;
  auto flow = std::make_shared<Shear>();
  flow->rate = 2;
  scene.flow = flow;
  scene.time.end = 1;
  return scene;
}

TriangleMesh tilted_body()
{
  return test::mapped(test::smooth_sphere(320),
    [](const Vector3& d) -> Vector3 {
      return { 1.5 * d.x() + 0.2 * d.z(), 0.8 * d.y(), 0.8 * d.z() + 0.1 * d.x() * d.x() };
    });
}

TEST(ViscosityRatio, TakesFewMoreIterations)
{
  const double same = first_instant(sheared(1), tilted_body()).iterations;
  for (const double ratio : { 0., 1e-3, 0.1, 10., 1e3 })
    EXPECT_LE(first_instant(sheared(ratio), tilted_body()).iterations, 1.5 * same) << ratio;
}

// Whichever way the layers are summed.
TEST(ViscosityRatio, MethodsAgree)
{
  Scene scene = sheared(5);
  const Diagnostics direct = first_instant(scene, tilted_body());
  for (const LayerMethod method : { LayerMethod::dense, LayerMethod::tree })
  {
    scene.accuracy.layer = method;
    const Diagnostics other = first_instant(scene, tilted_body());
    EXPECT_NEAR(other.tension_max, direct.tension_max, 1e-4 * std::abs(direct.tension_max));
    EXPECT_NEAR(other.stresslet[2], direct.stresslet[2], 1e-4 * std::abs(direct.stresslet[2]));
  }
}

}
}
