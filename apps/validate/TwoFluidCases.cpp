// One vesicle between two fluids of unlike viscosities.

#include "apps/validate/Cases.h"
#include "apps/validate/Runs.h"
#include "solver/simulation/StartMesh.h"

#include <fmt/format.h>

#include <array>

namespace vesicle::validation
{
namespace
{

/// The speed of a body that its weight z n has just set in motion, in Bo EB/μ r0².
double first_speed(ShapeRequest::Kind kind, double reduced_volume, int triangles,
  double viscosity_ratio, bool incompressible)
{
  Scene scene;
  scene.vesicle.shape.kind = kind;
  if (kind != ShapeRequest::Kind::sphere)
  {
    scene.vesicle.shape.reduced_volume = reduced_volume;
  }
  scene.vesicle.shape.triangles = triangles;
  scene.gravity = Scene::Gravity{};
  scene.gravity->bond_number = 1;
  scene.membrane.incompressible = incompressible;
  scene.fluid.viscosity_ratio = viscosity_ratio;
  scene.time.end = 1;
  Simulation simulation(scene, make_start_mesh(scene));
  return simulation.diagnose(simulation.start()).velocity[2];
}

void drop(Report& report)
{
  for (const double ratio : { 0., 0.2, 1., 5., 50., 1000. })
  {
    report.add(
      relative(fmt::format("U / Bo at {:g}", ratio), 2. / 3 * (1 + ratio) / (2 + 3 * ratio),
        first_speed(ShapeRequest::Kind::sphere, 1, report.triangles(), ratio, false),
        report.full() ? 4e-5 : 1.2e-4, "Hadamard, Rybczynski"));
  }
  for (const double ratio : { 0., 5., 1000. })
  {
    report.add(relative(fmt::format("inextensible: U / Bo at {:g}", ratio), 2. / 9,
      first_speed(ShapeRequest::Kind::sphere, 1, report.triangles(), ratio, true),
      report.full() ? 4e-5 : 1.2e-4, "rigid"));
  }
}

// Spectral, in spherical harmonics of degree 14.
void prolate(Report& report)
{
  const std::array<std::array<double, 2>, 4> reference{ { { 0.2, 1.09528 }, { 1, 1.07502 },
    { 5, 1.05327 }, { 50, 1.04315 } } };
  for (const auto& [ratio, factor] : reference)
  {
    report.add(relative(fmt::format("U / (2 Bo/9) at {:g}", ratio), factor,
      first_speed(ShapeRequest::Kind::prolate, 0.95, report.triangles(), ratio, true) / (2. / 9),
      report.full() ? 3e-5 : 4e-4));
  }
}

History sheared(const Report& report, double reduced_volume, double viscosity_ratio, double end)
{
  return simulate(scene_of("tank-treading",
    { fmt::format("vesicle.triangles={}", report.triangles()),
      fmt::format("vesicle.reduced_volume={}", reduced_volume),
      fmt::format("fluid.viscosity_ratio={}", viscosity_ratio), fmt::format("time.end={}", end) }));
}

// Spectral.
void steady_tank_treading(Report& report)
{
  const History run = sheared(report, 0.95, 5, 25);
  const Diagnostics& d = run.end();
  report.add(absolute("v = .95: inclination (deg)", 15.672, inclination(d), 0.1));
  report.add(
    relative("frequency / rate", 0.33530, d.tank_treading_frequency, report.full() ? 1e-3 : 3e-3));
  report.add(relative("stresslet xz", 8.082, d.stresslet[2], 1e-3));
  const double axes[] = { 1.3372, 0.9285, 0.8054 };
  for (int i = 0; i < 3; ++i)
  {
    report.add(relative(fmt::format("semi-axis {}", i + 1), axes[i], d.semi_axes[i], 5e-4));
  }
  report.add(at_most("drift of area and volume", 1e-6, largest_drift(run)));
  ChartSpec chart{ "Tank-treading, v = .95, five times as viscous inside", "time · rate",
    "inclination (degrees)",
    { line_of(run, "computed", inclination),
      { "reference", { 0, 25 }, { 15.672, 15.672 }, ChartLine::Style::dashed } } };
  report.chart("two-fluids-tank-treading", { chart });
}

void slow_tank_treading(Report& report)
{
  const Diagnostics d = sheared(report, 0.9, 5, 45).end();
  report.add(
    absolute("v = .9: inclination (deg)", 8.34, inclination(d), report.full() ? 0.1 : 0.15));
  report.add(relative("frequency / rate", 0.2522, d.tank_treading_frequency, 3e-3));
  report.add(relative("stresslet xz", 7.08, d.stresslet[2], 2e-3));
}

// The steady shape is rigid, whatever is inside.
void settling_between(Report& report)
{
  for (const double ratio : { 0.2, 5. })
  {
    const Diagnostics d =
      simulate(scene_of("pear",
                 { fmt::format("vesicle.triangles={}", report.triangles()),
                   fmt::format("fluid.viscosity_ratio={}", ratio),
                   fmt::format("time.end={}", 4 + 2 * ratio), "time.output_every=1" }))
        .end();
    report.add(relative(
      fmt::format("speed U at {:g}", ratio), 2.29870, d.velocity[2], report.full() ? 3e-4 : 1e-3));
  }
}

}

std::vector<Case> two_fluid_cases()
{
  return {
    { "two-fluids/drop",
      "A sphere with and without a membrane rises, at viscosity ratios 0 to 1000", Case::Set::fast,
      drop },
    { "two-fluids/prolate", "A prolate vesicle's first speed, at viscosity ratios .2 to 50",
      Case::Set::fast, prolate },
    { "two-fluids/tank-treading", "Steady tank-treading at a viscosity ratio of 5", Case::Set::fast,
      steady_tank_treading },
    { "two-fluids/slow", "The same at v = .9, near the end of steady tank-treading",
      Case::Set::full, slow_tank_treading },
    { "two-fluids/settling", "A pear's speed doesn't depend on the viscosity inside",
      Case::Set::full, settling_between },
  };
}

}
