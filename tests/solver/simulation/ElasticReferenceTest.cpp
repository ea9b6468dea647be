// Elastic sheets whose shape without stress isn't the start's.

#include "solver/Errors.h"
#include "solver/flow/Shear.h"
#include "solver/simulation/Simulation.h"
#include "tests/solver/support/TestMeshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vesicle
{
namespace
{

using Reference = Scene::Membrane::Reference;

Scene sheet(Reference reference)
{
  Scene scene;
  scene.accuracy.mesh_motion = Scene::MeshMotion::material;
  scene.membrane.shear_modulus = 2;
  scene.membrane.elasticity = ElasticLaw::skalak;
  scene.membrane.reference = reference;
  if (reference == Reference::file)
    scene.membrane.reference_file = "/reference.vtu";
  scene.time.end = 1;
  return scene;
}

constexpr double a = 0.8, c = 1.6;

TriangleMesh spheroid(int triangles)
{
  return test::mapped(test::smooth_sphere(triangles),
    [](const Vector3& d) -> Vector3 {
      return { a * d.x(), a * d.y(), c * d.z() };
    });
}

double energy(const Scene& scene, const StartMesh& start)
{
  Simulation simulation(scene, { start });
  return simulation.diagnose(simulation.start()).bending_energy;
}

// Circles of a spheroid go to circles of the sphere with the same area above: they are stretched by λ
// around and by 1/λ across, W = (G/4)(I1² + 2 I1) with I1 = λ² + λ⁻² − 2.
TEST(ElasticReference, ASpheroidThatWasASphere)
{
  constexpr double G = 2, pi = std::numbers::pi;
  constexpr int parts = 4000;
  double area = 0, exact = 0;
  const auto ring = [&](double t) // z = c sin t
  { return 2 * pi * a * std::cos(t) * std::hypot(a * std::sin(t), c * std::cos(t)) * pi / parts; };
  const auto angle = [&](int i) { return -pi / 2 + pi * (i + 0.5) / parts; };
  for (int i = 0; i < parts; ++i)
    area += ring(angle(i));
  double below = 0;
  for (int i = 0; i < parts; ++i)
  {
    const double own = ring(angle(i)), height = 2 * (below + own / 2) / area - 1,
                 radius = std::sqrt(area / (4 * pi) * (1 - height * height)),
                 square = std::pow(a * std::cos(angle(i)) / radius, 2),
                 i1 = square + 1 / square - 2;
    exact += G / 4 * (i1 * i1 + 2 * i1) * own;
    below += own;
  }
  EXPECT_NEAR(energy(sheet(Reference::sphere), { spheroid(1280), {} }) / exact, 1, 2e-3);
}

// A mesh that is the start, smaller, is a prestretch.
TEST(ElasticReference, AMeshThatIsSmaller)
{
  const TriangleMesh mesh = spheroid(320);
  Scene prestretched = sheet(Reference::start);
  prestretched.membrane.prestretch = 1.25;
  StartMesh start{ mesh, {} };
  start.reference = TriangleMesh{ mesh.points / 1.25, mesh.triangles };
  EXPECT_NEAR(energy(sheet(Reference::file), start) / energy(prestretched, { mesh, {} }), 1, 1e-12);
  start.reference = mesh;
  EXPECT_LT(energy(sheet(Reference::file), start), 1e-12);
}

TEST(ElasticReference, AMeshOfOtherTrianglesIsRefused)
{
  StartMesh start{ spheroid(320), {} };
  EXPECT_THROW(Simulation(sheet(Reference::file), { start }), InputError);
  start.reference = spheroid(80);
  EXPECT_THROW(Simulation(sheet(Reference::file), { start }), InputError);
}

// It is made again from the start: a simulation that goes on where another was does the same, bit for bit.
TEST(ElasticReference, IsTheSameAfterARestart)
{
  Scene scene = sheet(Reference::sphere);
  scene.membrane.surface_viscosity = 0.5;
  scene.fluid.viscosity_ratio = 5;
  scene.flow = std::make_shared<Shear>(1);
  const TriangleMesh mesh = spheroid(80);
  Simulation first(scene, mesh), second(scene, mesh);
  const State middle = first.step(first.step(first.start()));
  const State one = first.step(middle), other = second.step(middle);
  EXPECT_EQ(one.vesicles[0].points, other.vesicles[0].points);
  EXPECT_EQ(one.vesicles[0].velocity, other.vesicles[0].velocity);
}

}
}
