// Fig. 5 of the paper: an ellipsoid in shear, without bending.

#include "apps/validate/Cases.h"
#include "apps/validate/Runs.h"
#include "solver/mesh/Connectivity.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vesicle::validation
{
namespace
{

/// How far a tension's values lie from the mean of their neighbours', rms, relative to the
/// tension's range: a checkerboard has about 1, a smooth tension of wave length 1 falls with h².
double roughness(const History& run)
{
  const Eigen::VectorXd tension = run.simulation->fields(run.last).at("Tension");
  const auto count = static_cast<int>(tension.size());
  const Connectivity connectivity(run.last.vesicles[0].triangles, count);
  double sum = 0;
  for (int i = 0; i < count; ++i)
  {
    const auto& around = connectivity.vertex_neighbours;
    double mean = 0;
    for (const int* j = around.begin(i); j != around.end(i); ++j)
    {
      mean += tension[*j] / around.size(i);
    }
    sum += std::pow(tension[i] - mean, 2);
  }
  return std::sqrt(sum / count) / (tension.maxCoeff() - tension.minCoeff());
}

PictureSettings tension_picture()
{
  PictureSettings settings;
  settings.color = "Tension";
  return settings;
}

std::string axis_at(double degrees)
{
  const double angle = degrees * std::numbers::pi / 180;
  return fmt::format("vesicle.axis=[{}, 0.0, {}]", std::cos(angle), std::sin(angle));
}

// Every start ends at one angle; 33.2° is the paper's, whose aspect ratio isn't printed (v = .9563
// fits it).
void limit_angle(Report& report)
{
  ChartSpec chart{ "Inclination of an inextensible drop in shear, v = .9563", "time · rate",
    "degrees", {} };
  double lowest = 90, highest = -90;
  for (const double start : { 0., 45., 90. })
  {
    const History run = simulate(scene_of("inextensible-drop",
      { fmt::format("vesicle.triangles={}", report.triangles()), "time.end=10", axis_at(start) }));
    const double angle = inclination(run.end());
    lowest = std::min(lowest, angle);
    highest = std::max(highest, angle);
    report.add(absolute(fmt::format("angle from {} deg", start), 33.2, angle, 0.1));
    chart.lines.push_back(line_of(run, fmt::format("from {} deg", start), inclination));
    if (start == 45)
    {
      report.add(at_most("roughness of the tension", report.full() ? 0.0125 : 0.05, roughness(run),
        "smooth: falls as 1/N"));
      report.picture("fig5-tension", *run.simulation, run.last, tension_picture());
    }
  }
  report.add(at_most("spread of the three", 0.05, highest - lowest));
  chart.lines.push_back({ "paper", { 0, 10 }, { 33.2, 33.2 }, ChartLine::Style::dashed });
  report.chart("fig5-angle", { chart });
}

// Steady tank-treading at v = .95, independent computation: 32.424° ± .003.
void tank_treading(Report& report)
{
  const int end = report.full() ? 100 : 30;
  const History run = simulate(scene_of("tank-treading",
    { fmt::format("vesicle.triangles={}", report.triangles()), fmt::format("time.end={}", end) }));
  const Diagnostics& d = run.end();
  report.add(absolute("inclination (deg)", 32.424, inclination(d), report.full() ? 0.1 : 0.15));
  report.add(
    relative("frequency / rate", 0.44502, d.tank_treading_frequency, report.full() ? 1e-3 : 2e-3));
  const double axes[] = { 1.33701, 0.92861, 0.80544 };
  for (int i = 0; i < 3; ++i)
  {
    report.add(relative(fmt::format("semi-axis {}", i + 1), axes[i], d.semi_axes[i], 5e-4));
  }
  report.add(relative("lowest tension", 3.82, d.tension_min, report.full() ? 0.01 : 0.03));
  report.add(relative("highest tension", 6.38, d.tension_max, report.full() ? 0.01 : 0.03));
  double wander = 0, angle = 90;
  for (const Diagnostics& row : run.rows)
  {
    angle = std::min(angle, row.min_angle_deg);
    if (row.time > 15)
    {
      wander = std::max(wander, std::abs(inclination(row) - inclination(d)));
    }
  }
  report.add(at_most("angle's wandering after t = 15", 0.05, wander));
  report.add(at_least("smallest angle of the mesh", 20, angle));
  report.add(at_most("drift of area and volume", 1e-6, largest_drift(run)));
  ChartSpec chart{ "Tank-treading, v = .95", "time · rate", "inclination (degrees)",
    { line_of(run, "computed", inclination),
      { "reference", { 0, 1. * end }, { 32.424, 32.424 }, ChartLine::Style::dashed } } };
  ChartSpec corrections{ "", "time · rate", "removed by the projection",
    { line_of(run, "area", [](const Diagnostics& row) { return row.area_correction; }),
      line_of(run, "volume", [](const Diagnostics& row) { return row.volume_correction; }) } };
  report.chart("tank-treading", { chart, corrections });
  PictureSettings settings = tension_picture();
  settings.arrows = true;
  report.picture("tank-treading-tension", *run.simulation, run.last, settings);
}

/// What projections took from area and volume, relative, until t = 1.
double removed(int triangles, double dt)
{
  const History run = simulate(scene_of("tank-treading",
    { fmt::format("vesicle.triangles={}", triangles), fmt::format("time.step={}", dt), "time.end=1",
      "time.output_every=1" }));
  return run.end().area_correction + run.end().volume_correction;
}

void corrections(Report& report)
{
  const int triangles = report.triangles();
  const double coarse = removed(triangles, 0.05), fine = removed(triangles, 0.025);
  report.add(at_least("order in the step, 0.05 and 0.025", 1.8, std::log2(coarse / fine),
    fmt::format("{:.1e}, {:.1e}", coarse, fine)));
  // The constraint's rows are the real area's, so that nothing is left to the mesh.
  const double few = removed(triangles / 4, 0.025);
  report.add(at_most(fmt::format("largest of {} and {} / smallest", triangles / 4, triangles), 1.25,
    std::max(few, fine) / std::min(few, fine),
    fmt::format("{:.1e}, {:.1e} at a step of 0.025", few, fine)));
}

}

std::vector<Case> shear_cases()
{
  return { { "fig5/limit-angle",
             "Drop with an inextensible membrane in shear, from 0, 45 and 90 degrees: 33.2 degrees",
             Case::Set::fast, limit_angle },
    { "fig5/tank-treading",
      "The same at v = .95 over a long time, against an independent computation", Case::Set::fast,
      tank_treading },
    { "fig5/corrections",
      "What the projection removes from area and volume falls with the step, on any mesh",
      Case::Set::fast, corrections } };
}

}
