// Capsules: vesicles with an elastic wall.

#include "apps/validate/Cases.h"
#include "apps/validate/Runs.h"

#include <fmt/format.h>

namespace vesicle::validation
{
namespace
{

// Steady, by a spectral method.
void neo_hookean(Report& report)
{
  const History run = simulate(scene_of(
    "capsule", { fmt::format("vesicle.triangles={}", report.triangles()), "time.end=12" }));
  const Diagnostics& d = run.end();
  report.add(relative("Taylor deformation", 0.3981, d.taylor_deformation, 2e-3));
  report.add(absolute("inclination (deg)", 25.18, inclination(d), 0.05));
  const double axes[] = { 1.4186, 1.1544, 0.6108 };
  for (int i = 0; i < 3; ++i)
  {
    report.add(relative(fmt::format("semi-axis {}", i + 1), axes[i], d.semi_axes[i], 1e-3));
  }
  ChartSpec chart{ "Neo-Hookean capsule in shear, Ca = .3", "time · rate", "Taylor deformation",
    { line_of(run, "computed", [](const Diagnostics& row) { return row.taylor_deformation; }),
      { "reference", { 0, 12 }, { 0.3981, 0.3981 }, ChartLine::Style::dashed } } };
  report.chart("capsule", { chart });
}

}

std::vector<Case> capsule_cases()
{
  return { { "capsule/neo-hookean", "A neo-Hookean capsule in shear, Ca = .3", Case::Set::fast,
    neo_hookean } };
}

}
