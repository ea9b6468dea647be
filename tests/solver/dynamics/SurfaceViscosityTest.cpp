// Vesicles with a viscous membrane at their first instant, against exact values; and what that costs.

#include "solver/flow/Extension.h"
#include "solver/flow/Shear.h"
#include "solver/mesh/shapes/ShapeRequest.h"
#include "solver/mesh/shapes/SphericalHarmonics.h"
#include "solver/simulation/Simulation.h"
#include "solver/surface/StartShape.h"
#include "tests/solver/support/TestMeshes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>

namespace vesicle
{
namespace
{

struct Viscosities
{
  double ratio, membrane;
};

constexpr Viscosities viscosities[] = { { 1, 0 }, { 1, 1 }, { 1, 100 }, { 5, 0 }, { 5, 1 },
  { 5, 100 } };

Scene scene_with(const Viscosities& viscosities)
{
  Scene scene;
  scene.fluid.viscosity_ratio = viscosities.ratio;
  scene.membrane.surface_viscosity = viscosities.membrane;
  scene.time.end = 1;
  return scene;
}

/// r = 1 + Σ amplitude Y_lm.
TriangleMesh perturbed(const std::vector<ShapeMode>& modes, int triangles)
{
  ShapeRequest request;
  request.kind = ShapeRequest::Kind::perturbed;
  request.modes = modes;
  request.triangles = triangles;
  return make_start_shape(request, SurfaceBasis::loop);
}

/// At the first instant.
class Instant
{
public:
  Instant(const Scene& scene, const TriangleMesh& mesh)
    : space_(SurfaceBasis::loop, mesh.triangles, static_cast<int>(mesh.points.rows())),
      state_(Simulation(scene, mesh).instant()), surface_(space_, state_.vesicles[0].points)
  {
  }

  /// Of the normal speed: its part along a function of the direction.
  double rate(const std::function<double(const Vector3&)>& function) const
  {
    const VesicleState& vesicle = state_.vesicles[0];
    double product = 0, square = 0;
    for (Eigen::Index i = 0; i < vesicle.points.rows(); ++i)
    {
      const double f = function(vesicle.points.row(i).normalized().transpose()),
                   speed = vesicle.velocity.row(i).dot(surface_.normals.row(i));
      product += surface_.vertex_area[i] * speed * f;
      square += surface_.vertex_area[i] * f * f;
    }
    return product / square;
  }
  double mean_tension() const
  {
    return surface_.vertex_area.dot(state_.vesicles[0].tension) / surface_.area;
  }

private:
  SurfaceSpace space_;
  State state_;
  Surface surface_;
};

/// (2l³ + 3l² + 4) + λ (2l³ + 3l² − 5) + 4 (l − 1)(l + 2) η
double resistance(int l, const Viscosities& v)
{
  const double cubic = 2 * l * l * l + 3 * l * l;
  return cubic + 4 + v.ratio * (cubic - 5) + 4 * (l - 1) * (l + 2) * v.membrane;
}

// How a nearly spherical vesicle of excess area takes up a strain, x² − z²: by 60/(23λ + 32 + 16η). Of
// shapes that are bent the other way about the tension's part is the opposite one.
TEST(SurfaceViscosity, ANearlySphericalVesicleIsStrained)
{
  for (const Viscosities& v : viscosities)
  {
    Scene scene = scene_with(v);
    scene.flow = std::make_shared<Extension>(Extension::Type::planar, 1);
    const auto strain = [](const Vector3& n) { return n.x() * n.x() - n.z() * n.z(); };
    double rate = 0;
    for (const double amplitude : { -0.02, 0.02 })
      rate += Instant(scene, perturbed({ { 2, -2, amplitude } }, 320)).rate(strain) / 2;
    EXPECT_NEAR(rate * resistance(2, v) / 60, 1, 5e-3) << v.ratio << " " << v.membrane;
  }
}

// du_l/dt = −l(l + 1)(l − 1)(l + 2) [l(l + 1) + σ] u_l over the resistance, σ the tension. Of shapes that are
// bent the other way about the linear part is the opposite one.
TEST(SurfaceViscosity, ANearlySphericalVesicleRelaxes)
{
  const std::vector<ShapeMode> modes{ { 2, 0, 0.015 }, { 4, 0, 0.005 } };
  const std::array<double, 2> signs{ -1, 1 };
  std::vector<TriangleMesh> meshes;
  for (const double sign : signs)
    meshes.push_back(perturbed({ { 2, 0, sign * 0.015 }, { 4, 0, sign * 0.005 } }, 1280));
  for (const Viscosities& v : viscosities)
  {
    Scene scene = scene_with(v);
    scene.membrane.bending_rigidity = 1;
    std::array<double, 2> rate{}, exact{};
    for (int side = 0; side < 2; ++side)
    {
      const Instant instant(scene, meshes[side]);
      for (int k = 0; k < 2; ++k)
      {
        const int l = modes[k].l, squared = l * (l + 1);
        rate[k] += signs[side] *
          instant.rate([l](const Vector3& n) { return real_spherical_harmonic(l, 0, n); });
        exact[k] -= squared * (l - 1) * (l + 2) * (squared + instant.mean_tension()) /
          resistance(l, v) * modes[k].amplitude;
      }
    }
    for (int k = 0; k < 2; ++k)
      EXPECT_NEAR(rate[k] / exact[k], 1, 1e-2)
        << modes[k].l << ", " << v.ratio << " " << v.membrane;
  }
}

Diagnostics first_instant(const Scene& scene, TriangleMesh mesh)
{
  Simulation simulation(scene, std::move(mesh));
  return simulation.diagnose(simulation.start());
}

// The flow along a rising drop's surface is the gradient of a function without nodes but one: it
// stretches every patch alike in all directions, so that a membrane's resistance to shear has no part
// in it (Boussinesq's drop without a dilational viscosity).
TEST(SurfaceViscosity, ADropRisesAsWithoutIt)
{
  for (const Viscosities& v : viscosities)
  {
    Scene scene = scene_with(v);
    scene.membrane.incompressible = false;
    scene.gravity = Scene::Gravity{};
    scene.gravity->bond_number = 1;
    const Diagnostics d = first_instant(scene, test::smooth_sphere(320));
    const double exact = 2. / 3 * (1 + v.ratio) / (2 + 3 * v.ratio),
                 size = std::pow(3 * d.volume / (4 * std::numbers::pi), 2. / 3);
    EXPECT_NEAR(d.velocity[2] * size / exact, 1, 2e-4) << v.ratio << " " << v.membrane;
  }
}

/// In shear, with bending, off the planes of symmetry.
Diagnostics sheared(const Viscosities& viscosities, Scene::MeshMotion motion)
{
  Scene scene = scene_with(viscosities);
  scene.membrane.bending_rigidity = 1;
  scene.accuracy.mesh_motion = motion;
  scene.flow = std::make_shared<Shear>(2);
  return first_instant(scene,
    test::mapped(test::smooth_sphere(320),
      [](const Vector3& d) -> Vector3 {
        return { 1.5 * d.x() + 0.2 * d.z(), 0.8 * d.y(), 0.8 * d.z() + 0.1 * d.x() * d.x() };
      }));
}

TEST(SurfaceViscosity, TakesFewMoreIterations)
{
  for (const auto motion : { Scene::MeshMotion::equidistribute, Scene::MeshMotion::material })
  {
    const double without = sheared({ 1, 0 }, motion).iterations;
    for (const double ratio : { 1., 10. })
      for (const double viscosity : { 0.01, 1., 100. })
        EXPECT_LE(sheared({ ratio, viscosity }, motion).iterations, 2 * without)
          << ratio << " " << viscosity;
  }
}

}
}
