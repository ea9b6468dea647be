// Fig. 6 and 7 of the paper: axisymmetric equilibria, against integration of the Euler–Lagrange
// equations.

#include "apps/DataFiles.h"
#include "apps/validate/Cases.h"
#include "apps/validate/Runs.h"
#include "solver/equilibrium/BranchEquilibrium.h"
#include "solver/simulation/StartMesh.h"

#include "solver/state/Table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace vesicle::validation
{
namespace
{

// Relaxation ends when the shape no longer moves, or here at the latest (in μr0³/EB): at 320
// triangles slow modes can go on for ever within the energy's own error.
constexpr double latest = 20;

struct Shape
{
  std::string branch;
  double v;
  auto operator<=>(const Shape&) const = default;
};

double reference_energy(const Shape& shape)
{
  const Table table = parse_table(data_file("reference/equilibria.csv"));
  const auto v = table.column("reduced_volume"), energy = table.column("energy_over_8pi_kappa");
  for (std::size_t i = 0; i < v.size(); ++i)
  {
    if (table.rows[i][0] == shape.branch && std::abs(v[i] - shape.v) < 1e-9)
    {
      return energy[i];
    }
  }
  return std::nan("");
}

Scene relaxation_scene(const Shape& shape, int triangles)
{
  Scene scene;
  scene.name = shape.branch;
  scene.vesicle.shape.kind =
    shape.branch == "oblate" ? ShapeRequest::Kind::discocyte : shape_kind(shape.branch);
  if (shape.branch == "oblate" && shape.v > 0.7)
  {
    scene.vesicle.shape.kind = ShapeRequest::Kind::oblate;
  }
  scene.vesicle.shape.reduced_volume = shape.v;
  scene.vesicle.shape.triangles = triangles;
  scene.membrane.bending_rigidity = 1;
  // Not "steady": at its speed the softest mode would still have a thousandth of r0 to go. The wider
  // stomatocyte's mouth goes on closing, slowly.
  scene.time.end = shape.branch == "stomatocyte" && shape.v > 0.55 ? 12 : 4;
  return scene;
}

/// Relaxed shapes so far, by their number of triangles.
std::map<std::pair<Shape, int>, History>& relaxed_shapes()
{
  static std::map<std::pair<Shape, int>, History> done;
  return done;
}

/// Computed once.
const History& relaxed(const Shape& shape, int triangles)
{
  auto& done = relaxed_shapes();
  const auto key = std::pair(shape, triangles);
  if (const auto found = done.find(key); found != done.end())
  {
    return found->second;
  }
  const Scene scene = relaxation_scene(shape, triangles);
  return done.emplace(key, simulate(scene, make_start_mesh(scene), latest)).first->second;
}

/// A meridian (r, z), z from the volume's centroid.
struct Profile
{
  std::vector<double> r, z;
};

Profile reference_profile(const std::string& name)
{
  const Table table = parse_table(data_file("reference/profiles/" + name + ".csv"));
  Profile p{ table.column("r"), table.column("z") };
  double volume = 0, moment = 0; // ∫ r² dz, ∫ z r² dz
  for (std::size_t i = 1; i < p.r.size(); ++i)
  {
    const double slice = (p.r[i - 1] * p.r[i - 1] + p.r[i] * p.r[i]) / 2 * (p.z[i] - p.z[i - 1]);
    volume += slice;
    moment += slice * (p.z[i - 1] + p.z[i]) / 2;
  }
  for (double& z : p.z)
  {
    z -= moment / volume;
  }
  return p;
}

double distance(const Profile& profile, const Eigen::Vector2d& x)
{
  double least = INFINITY;
  for (std::size_t i = 1; i < profile.r.size(); ++i)
  {
    const Eigen::Vector2d a(profile.r[i - 1], profile.z[i - 1]), b(profile.r[i], profile.z[i]);
    const double s = std::clamp((x - a).dot(b - a) / (b - a).squaredNorm(), 0., 1.);
    least = std::min(least, (x - a - s * (b - a)).norm());
  }
  return least;
}

/// The other way up.
Profile mirrored(Profile profile)
{
  for (double& z : profile.z)
  {
    z *= -1;
  }
  return profile;
}

/// The vertices as points of the half plane about the axis z.
Profile computed_profile(const History& run)
{
  const Points points = run.simulation->points(run.last);
  const double r0 = run.simulation->scales().length, center = run.end().centroid[2];
  Profile profile;
  for (int i = 0; i < points.rows(); ++i)
  {
    profile.r.push_back(std::hypot(points(i, 0), points(i, 1)) / r0);
    profile.z.push_back((points(i, 2) - center) / r0);
  }
  return profile;
}

double largest_distance(const Profile& computed, const Profile& reference)
{
  double largest = 0;
  for (std::size_t i = 0; i < computed.r.size(); ++i)
  {
    largest = std::max(largest, distance(reference, { computed.r[i], computed.z[i] }));
  }
  return largest;
}

/// Deviation of the two nearest semi-axes: 0 where the shape is axisymmetric.
double asymmetry(const Diagnostics& d)
{
  return std::min(d.semi_axes[0] / d.semi_axes[1], d.semi_axes[1] / d.semi_axes[2]) - 1;
}

/// Tolerances with 320 and with 1,280 triangles.
struct Tolerance
{
  double fast, full;
};

struct Equilibrium
{
  Shape shape;
  Case::Set set;
  Tolerance energy;
  const char* note = "";
  const char* profile = nullptr;
  Tolerance distance = {}; ///< of r0
};

void equilibrium(Report& report, const Equilibrium& e)
{
  const History& run = relaxed(e.shape, report.triangles());
  const Diagnostics& end = run.end();
  const auto tolerance = [&](const Tolerance& t) { return report.full() ? t.full : t.fast; };
  report.add(
    relative("E/8pi", reference_energy(e.shape), end.energy_over_8pi, tolerance(e.energy), e.note));
  report.add(at_most("rise of E in a step", 1e-6, largest_energy_rise(run)));
  if (e.profile)
  {
    Profile reference = reference_profile(e.profile);
    const Profile computed = computed_profile(run);
    if (largest_distance(computed, mirrored(reference)) < largest_distance(computed, reference))
    {
      reference = mirrored(reference);
    }
    report.add(at_most(
      "distance to the profile", tolerance(e.distance), largest_distance(computed, reference)));
    report.chart(fmt::format("fig7-{}", e.profile),
      { { fmt::format("{}, v = {}", e.shape.branch, e.shape.v), "r", "z",
        { { "Euler-Lagrange", reference.r, reference.z },
          { "computed", computed.r, computed.z, ChartLine::Style::points } } } });
  }
  PictureSettings settings;
  report.picture(
    fmt::format("fig6-{}-{}", e.shape.branch, e.shape.v), *run.simulation, run.last, settings);
}

// E(v) of all branches and what was computed so far.
void energies(Report& report)
{
  const int triangles = report.triangles();
  ChartSpec chart{ "Equilibrium shapes", "reduced volume", "E / 8 pi EB", {} };
  const Table table = parse_table(data_file("reference/equilibria.csv"));
  const auto v = table.column("reduced_volume"), energy = table.column("energy_over_8pi_kappa");
  for (const std::string branch : { "prolate", "oblate", "stomatocyte" })
  {
    ChartLine line{ branch, {}, {} };
    for (std::size_t i = 0; i < v.size(); ++i)
    {
      if (table.rows[i][0] == branch)
      {
        line.x.push_back(v[i]);
        line.y.push_back(energy[i]);
      }
    }
    chart.lines.push_back(line);
  }
  const auto energy_of = [&](const Shape& shape)
  { return relaxed(shape, triangles).end().energy_over_8pi; };
  // Differences are several times the energies' errors.
  const auto above = [&](const std::string& upper, const std::string& lower, double at, double by)
  {
    report.add(at_least(fmt::format("v = {:.2f}: {} above {} by", at, upper, lower), by,
      energy_of({ upper, at }) / energy_of({ lower, at }) - 1));
  };
  above("oblate", "prolate", 0.66, 0.003);
  above("prolate", "oblate", 0.64, 0.003);
  above("stomatocyte", "oblate", 0.6, 0.005);
  above("oblate", "stomatocyte", 0.58, 0.005);
  ChartLine computed{ "computed", {}, {}, ChartLine::Style::points };
  for (const auto& [key, run] : relaxed_shapes())
  {
    if (key.second == triangles)
    {
      computed.x.push_back(key.first.v);
      computed.y.push_back(run.end().energy_over_8pi);
    }
  }
  chart.lines.push_back(computed);
  report.chart("fig6", { chart });
}

// Three different axes at the start.
void triaxial(Report& report, const std::string& branch, double v)
{
  const bool prolate = branch == "prolate";
  Scene scene = relaxation_scene({ branch, v }, report.triangles());
  scene.vesicle.shape.kind = ShapeRequest::Kind::ellipsoid;
  scene.vesicle.shape.semi_axes = prolate ? std::array{ 2., 1.3, 1. } : std::array{ 1.5, 1.2, 0.5 };
  if (!prolate)
    scene.time.end = 20;
  const History run = simulate(scene, make_start_mesh(scene), latest);
  const Diagnostics& end = run.end();
  report.add(at_least("asymmetry at the start", 0.1, asymmetry(run.rows.front())));
  // The mesh, laid for three axes, holds the softest mode: the prolate's by 2.5% and .05% at 320 and
  // 1,280 triangles, the oblate's, softer still, by 4.7% and .9%.
  const double held = prolate ? 1 : 2;
  report.add(at_most("asymmetry at the end", held * (report.full() ? 0.01 : 0.03), asymmetry(end)));
  report.add(relative(
    "E/8pi", reference_energy({ branch, v }), end.energy_over_8pi, report.full() ? 1e-3 : 1e-2));
  report.add(at_most("rise of E in a step", 1e-6, largest_energy_rise(run)));
  report.chart(fmt::format("fig6-from-three-axes-{}", branch),
    { { "Relaxation from three different axes", "time", "semi-axes",
      { line_of(run, "1", [](const Diagnostics& d) { return d.semi_axes[0]; }),
        line_of(run, "2", [](const Diagnostics& d) { return d.semi_axes[1]; }),
        line_of(run, "3", [](const Diagnostics& d) { return d.semi_axes[2]; }) } } });
}

// Newton's method without a fluid; the oblate loses its stability between the last two.
void without_fluid(Report& report)
{
  const double tolerance = report.full() ? 1e-4 : 1e-3;
  for (const Shape& shape : { Shape{ "prolate", 0.6 }, Shape{ "prolate", 0.8 },
         Shape{ "oblate", 0.6 }, Shape{ "oblate", 0.8 }, Shape{ "stomatocyte", 0.6 } })
  {
    const BranchEquilibrium found =
      branch_equilibrium({ equilibrium_branch(shape.branch), shape.v, report.triangles() });
    report.add(relative(fmt::format("{}, v = {}: E/8pi", shape.branch, shape.v),
      reference_energy(shape), found.equilibrium.energy / (8 * std::numbers::pi), tolerance));
    const double lowest = found.equilibrium.modes.eigenvalues[0];
    if (shape.branch == "oblate")
    {
      const std::string name = fmt::format("{}, v = {}: lowest eigenvalue", shape.branch, shape.v);
      report.add(shape.v < 0.75 ? at_least(name, 1, lowest) : at_most(name, -1, lowest));
    }
  }
}

constexpr auto fast = Case::Set::fast, full = Case::Set::full;

}

std::vector<Case> equilibrium_cases()
{
  // 0.1% is asked for at 1,280 triangles.
  static const char* const neck = "its mouth, of radius 0.097 in the end, is still closing (t = 4)";
  static const char* const mouth = "its mouth still moves at the end (t = 12)";
  static const std::vector<Equilibrium> equilibria{
    { { "prolate", 0.65 }, full, { 2e-3, 1e-3 } },
    { { "prolate", 0.7 }, full, { 2e-3, 1e-3 } },
    { { "prolate", 0.8 }, fast, { 2e-3, 1e-3 }, "", "prolate_v080", { 2e-3, 1e-3 } },
    { { "prolate", 0.9 }, fast, { 2e-3, 1e-3 }, "", "prolate_v090", { 2e-3, 1e-3 } },
    { { "prolate", 0.95 }, fast, { 2e-3, 1e-3 }, "", "prolate_v095", { 2e-3, 1e-3 } },
    { { "oblate", 0.6 }, fast, { 1e-2, 1e-3 }, "", "oblate_v060", { 2e-2, 1e-3 } },
    { { "oblate", 0.65 }, full, { 5e-3, 1e-3 }, "", "oblate_v065", { 2e-2, 1e-3 } },
    { { "stomatocyte", 0.5 }, full, { 3e-2, 3e-2 }, neck, "stomatocyte_v050", { 0.2, 0.2 } },
    { { "stomatocyte", 0.6 }, full, { 3e-2, 5e-3 }, mouth },
  };
  std::vector<Case> cases;
  for (const Equilibrium& e : equilibria)
  {
    cases.push_back({ fmt::format("fig6/{}-{}", e.shape.branch, e.shape.v),
      fmt::format("Relaxed {}, v = {}", e.shape.branch, e.shape.v), e.set,
      [&e](Report& report) { equilibrium(report, e); } });
  }
  cases.push_back({ "fig6/without-fluid",
    "Equilibria without a fluid, and whether oblates are stable", fast, without_fluid });
  cases.push_back({ "fig6/crossings", "Which branch is lower on either side of v = .6511 and .5912",
    full, energies });
  cases.push_back(
    { "fig6/axisymmetric-prolate", "Three different axes at the start, v = .8: ends as a prolate",
      fast, [](Report& report) { triaxial(report, "prolate", 0.8); } });
  cases.push_back(
    { "fig6/axisymmetric-oblate", "Three different axes at the start, v = .6: ends as an oblate",
      full, [](Report& report) { triaxial(report, "oblate", 0.6); } });
  return cases;
}

}
