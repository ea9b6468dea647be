// Vesicles beside each other.

#include "apps/validate/Cases.h"
#include "apps/validate/Runs.h"
#include "solver/simulation/StartMesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace vesicle::validation
{
namespace
{

/// Two unit spheres one above the other, their centres `distance` apart.
Scene spheres(double distance, int triangles, bool incompressible)
{
  Scene scene;
  scene.vesicle.shape.kind = ShapeRequest::Kind::sphere;
  scene.vesicle.shape.triangles = triangles;
  scene.membrane.incompressible = incompressible;
  scene.gravity = Scene::Gravity{};
  scene.gravity->bond_number = 1;
  scene.time.end = 1;
  scene.companions.push_back(scene.companion());
  scene.companions[0].vesicle.center = { 0, 0, distance };
  return scene;
}

/// How fast both rise at the first instant, in Bo EB/μ r0².
std::vector<Diagnostics> first_instant(const Scene& scene)
{
  Simulation simulation(scene, make_start_meshes(scene));
  return simulation.diagnose_all(simulation.instant());
}

// Spheres of fluid without a membrane: U/U0 = 1 + 5/(4d) − 1/(2d³), U0 = 4/15 of one alone.
void blobs(Report& report)
{
  for (const double gap : { 1., 0.1, 0.01 })
  {
    const double d = 2 + gap, alone = 4. / 15;
    const auto both = first_instant(spheres(d, report.triangles(), false));
    for (const Diagnostics& one : both)
      report.add(relative(fmt::format("gap {:g}: U / Bo", gap),
        alone * (1 + 5 / (4 * d) - 1 / (2 * d * d * d)), one.velocity[2],
        report.full() ? 4e-5 : 1.5e-4, "closed form"));
  }
}

// Along their line of centres inextensible spheres are rigid ones (M. Stimson, G. Jeffery, 1926).
void inextensible(Report& report)
{
  const std::array<std::array<double, 2>, 3> drag{ { { 2.1, 0.6509001445 }, { 2.5, 0.6729155138 },
    { 4, 0.7422582851 } } };
  for (const auto& [distance, factor] : drag)
  {
    const auto both = first_instant(spheres(distance, report.triangles(), true));
    report.add(relative(fmt::format("d = {:g}: U / (2 Bo/9)", distance), 1 / factor,
      both[0].velocity[2] / (2. / 9), report.full() ? 3e-5 : 1.2e-4, "rigid spheres"));
  }
}

const Diagnostics& at_time(const History& run, double time)
{
  return *std::min_element(run.rows.begin(), run.rows.end(),
    [=](const Diagnostics& a, const Diagnostics& b)
    { return std::abs(a.time - time) < std::abs(b.time - time); });
}

// Spectral, each started with the shape that it would keep alone; ours start as ellipsoids of its axes.
void pair(Report& report)
{
  const History run =
    simulate(scene_of("pair", { fmt::format("vesicle.triangles={}", report.full() ? 320 : 120) }));
  const double reference[][3] = { { 1, -1.2459, 0.2778 }, { 2, -0.9865, 0.3430 },
    { 3, -0.7001, 0.4856 } };
  const double tolerance = report.full() ? 1e-3 : 1e-2;
  for (const auto& [time, x, z] : reference)
  {
    const Diagnostics& d = at_time(run, time);
    report.add(absolute(fmt::format("t = {:g}: centre x", time), x, d.centroid[0], tolerance));
    report.add(absolute(fmt::format("t = {:g}: centre z", time), z, d.centroid[2], tolerance));
  }
  report.add(absolute("inclination (deg)", 38.99, inclination(run.end()), 0.2));
}

}

std::vector<Case> several_cases()
{
  return {
    { "several/blobs", "Two spheres of fluid rise one above the other, down to a gap of .01 r0",
      Case::Set::fast, blobs },
    { "several/inextensible",
      "Two spheres with inextensible membranes rise along their line of "
      "centres as rigid ones",
      Case::Set::fast, inextensible },
    { "several/pair", "Two vesicles pass each other in shear", Case::Set::full, pair },
  };
}

}
