// Where the power goes: into the fluids outside and inside and into the membrane.

#include "solver/flow/Extension.h"
#include "solver/flow/Shear.h"
#include "solver/simulation/Simulation.h"
#include "tests/solver/support/TestMeshes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace vesicle
{
namespace
{

constexpr double pi = std::numbers::pi;

Scene scene_with(double viscosity_ratio, double surface_viscosity)
{
  Scene scene;
  scene.fluid.viscosity_ratio = viscosity_ratio;
  scene.membrane.surface_viscosity = surface_viscosity;
  scene.time.end = 1;
  return scene;
}

Diagnostics first_instant(const Scene& scene, TriangleMesh mesh)
{
  Simulation simulation(scene, std::move(mesh));
  return simulation.diagnose(simulation.instant());
}

TriangleMesh tilted_body()
{
  return test::mapped(test::smooth_sphere(320),
    [](const Vector3& d) -> Vector3 {
      return { 1.5 * d.x() + 0.2 * d.z(), 0.8 * d.y(), 0.8 * d.z() + 0.1 * d.x() * d.x() };
    });
}

/// With 320 and with 1,280 triangles.
template<class Errors>
std::array<double, 2> on_two_meshes(Errors errors)
{
  return { errors(test::smooth_sphere(320)), errors(test::smooth_sphere(1280)) };
}

// Inside a drop that rises at U is Hill's vortex, α [(2r² − 1) e_z − z x] with α = U/2(1 + λ), which
// dissipates 8π λ α²; all is what the weight does, U 4π/3.
TEST(PowerSplit, ARisingDrop)
{
  for (const double ratio : { 0.2, 5., 50. })
  {
    Scene scene = scene_with(ratio, 0);
    scene.membrane.incompressible = false;
    scene.gravity = Scene::Gravity{};
    scene.gravity->bond_number = 1;
    const double U = 2. / 3 * (1 + ratio) / (2 + 3 * ratio),
                 inside = 2 * pi * ratio * U * U / ((1 + ratio) * (1 + ratio)),
                 outside = U * 4 * pi / 3 - inside;
    const auto error = on_two_meshes(
      [&](const TriangleMesh& mesh)
      {
        const Diagnostics d = first_instant(scene, mesh);
        const double size = std::pow(3 * d.volume / (4 * pi), 5. / 3);
        EXPECT_EQ(d.split->membrane, 0);
        return std::max(std::abs(d.split->inside * size - inside),
                 std::abs(d.split->outside * size - outside)) /
          (inside + outside);
      });
    EXPECT_LT(error[0], 2e-4) << ratio;
    EXPECT_LT(error[1], 5e-5) << ratio;
  }
}

// In a strain E a drop without a surface tension is strained by 5/(2λ + 3) E, and the disturbance on its
// surface is κ E x, κ = 5/(2λ + 3) − 1, whose traction outside is −3κ E x.
TEST(PowerSplit, ADropInStrain)
{
  for (const double ratio : { 0.2, 5., 50. })
  {
    Scene scene = scene_with(ratio, 0);
    scene.membrane.incompressible = false;
    scene.flow = std::make_shared<Extension>(Extension::Type::planar, 1);
    const double square = 2, strained = 5 / (2 * ratio + 3), volume = 4 * pi / 3,
                 inside = 2 * ratio * strained * strained * square * volume,
                 outside = 3 * (strained - 1) * (strained - 1) * square * volume;
    const auto error = on_two_meshes(
      [&](const TriangleMesh& mesh)
      {
        const Diagnostics d = first_instant(scene, mesh);
        const double size = volume / d.volume;
        return std::max(std::abs(d.split->inside * size / inside - 1),
          std::abs(d.split->outside * size / outside - 1));
      });
    EXPECT_LT(error[1], 3e-4) << ratio;
    EXPECT_GT(test::order(error[0], error[1]), 1.6) << ratio << ": " << error[0] << " " << error[1];
  }
}

// All that the membrane's energy loses, in a fluid at rest.
TEST(PowerSplit, AddsUpToTheEnergyLost)
{
  for (const double ratio : { 0., 1., 5. })
    for (const double viscosity : { 0.5, 20. })
    {
      Scene scene = scene_with(ratio, viscosity);
      scene.membrane.bending_rigidity = 1;
      scene.accuracy.mesh_motion = Scene::MeshMotion::material;
      const Diagnostics d = first_instant(scene, tilted_body());
      ASSERT_TRUE(d.split);
      EXPECT_GE(d.split->inside, 0);
      EXPECT_GT(d.split->outside, 0);
      EXPECT_GT(d.split->membrane, 0);
      EXPECT_NEAR((d.split->inside + d.split->outside + d.split->membrane) / d.dissipation, 1, 1e-2)
        << ratio << " " << viscosity;
    }
}

// Scenes of fluids of one viscosity and no other are as before.
TEST(PowerSplit, IsThereWhereItTells)
{
  Scene scene = scene_with(1, 0);
  scene.flow = std::make_shared<Shear>(1);
  EXPECT_FALSE(first_instant(scene, tilted_body()).split);
  scene.membrane.surface_viscosity = 1;
  const Diagnostics d = first_instant(scene, tilted_body());
  ASSERT_TRUE(d.split);
  EXPECT_GT(d.split->outside, 0);
  EXPECT_GT(d.split->inside, 0);
  EXPECT_GT(d.split->membrane, 0);
}

}
}
