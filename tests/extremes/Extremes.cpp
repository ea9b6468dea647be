#include "Extremes.h"

#include "solver/Errors.h"
#include "solver/mesh/MeshQuality.h"
#include "solver/mesh/SelfCrossing.h"
#include "solver/scene/SceneFile.h"
#include "solver/simulation/Simulation.h"
#include "solver/simulation/StartMesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vesicle::test
{
namespace
{

/// Area and volume that a projection leaves.
constexpr double most_drift = 1e-6;

std::string time_table(double end, const std::string& more = "")
{
  return fmt::format("[time]\nend = {}\noutput_every = {}\n{}", end, end, more);
}

std::string vesicle(const std::string& shape, double reduced_volume, int triangles)
{
  return fmt::format("[vesicle]\nshape = \"{}\"\nreduced_volume = {}\ntriangles = {}\n", shape,
    reduced_volume, triangles);
}

const std::string bending = "[membrane]\nbending_rigidity = 1.0\n";

void add_shapes(std::vector<Cell>& cells, int triangles)
{
  for (const char* shape : { "prolate", "oblate", "discocyte" })
    for (const double v : { 0.999999, 0.99, 0.8, 0.6, 0.4, 0.25 })
      cells.push_back({ shape, fmt::format("v = {}", v),
        vesicle(shape, v, triangles) + bending + time_table(0.02), 0.1 });
}

/// Loads for the time in which they move a vesicle by its own size, or that of the membrane.
void add_loads(std::vector<Cell>& cells, int triangles)
{
  for (const double bond : { -1e4, -1e2, -1., 0., 1e-3, 1., 1e2, 1e4 })
    cells.push_back({ "gravity", fmt::format("Bo = {:g}", bond),
      vesicle("prolate", 0.9, triangles) + bending +
        fmt::format("[gravity]\nbond_number = {}\n", bond) +
        time_table(std::min(0.1, 1 / std::abs(bond))),
      1 });
}

void add_flows(std::vector<Cell>& cells, int triangles)
{
  const std::pair<const char*, const char*> flows[]{ { "shear", "kind = \"shear\"\nrate = {}\n" },
    { "planar extension", "kind = \"extension\"\ntype = \"planar\"\nrate = {}\n" },
    { "axisymmetric extension", "kind = \"extension\"\ntype = \"axisymmetric\"\nrate = {}\n" },
    { "Poiseuille", "kind = \"poiseuille\"\nvelocity = {}\nradius = 4.0\n" },
    { "Poiseuille, off axis",
      "kind = \"poiseuille\"\nvelocity = {}\nradius = 4.0\ncenter = [0, 0, 1]\n" } };
  for (const auto& [name, keys] : flows)
    for (const double rate : { 1e-3, 1., 1e2, 1e4 })
    {
      const double end = std::min(0.1, 0.3 / rate);
      cells.push_back({ name, fmt::format("Ca = {:g}", rate),
        vesicle("prolate", 0.95, triangles) + bending + "[flow]\n" +
          fmt::format(fmt::runtime(keys), fmt::format("{:.9f}", rate)) + time_table(end),
        1 });
    }
}

void add_steps(std::vector<Cell>& cells, int triangles)
{
  for (const double step : { 1e-6, 1e-4, 1e-2, 0.1, 1. })
    cells.push_back({ "fixed step", fmt::format("dt = {:g}", step),
      vesicle("prolate", 0.8, triangles) + bending +
        time_table(std::min(1., 100 * step), fmt::format("step = {:.9f}\n", step)),
      1 });
}

/// The same vesicle in other units: sizes of r0, EB, μ and the time that goes with them.
void add_units(std::vector<Cell>& cells, int triangles)
{
  struct Units
  {
    const char* name;
    double length, energy, viscosity;
  };
  for (const Units& u :
    { Units{ "SI", 1e-6, 1e-19, 1e-3 }, Units{ "1e-9", 1e-9, 1, 1 }, Units{ "1e9", 1e9, 1, 1 } })
  {
    const double time = u.viscosity * std::pow(u.length, 3) / u.energy;
    cells.push_back({ "units", u.name,
      vesicle("prolate", 0.8, triangles) + fmt::format("radius = {:e}\n", u.length) +
        fmt::format("[membrane]\nbending_rigidity = {:e}\n[fluid]\nviscosity = {:e}\n", u.energy,
          u.viscosity) +
        fmt::format("[time]\nend = {0:e}\noutput_every = {0:e}\n", 0.1 * time),
      1 });
  }
  for (const double away : { 1e3, 1e6 })
    cells.push_back({ "units", fmt::format("{:g} r0 away", away),
      vesicle("prolate", 0.8, triangles) + fmt::format("center = [{0:.1f}, {0:.1f}, 0.0]\n", away) +
        bending + time_table(0.1),
      1 });
}

void add_others(std::vector<Cell>& cells, int triangles)
{
  const std::pair<const char*, const char*> drives[]{ { "at rest", "" },
    { "shear", "[flow]\nkind = \"shear\"\nrate = 1.0\n" },
    { "extension", "[flow]\nkind = \"extension\"\ntype = \"planar\"\nrate = 1.0\n" },
    { "gravity", "[gravity]\nbond_number = 1\n" } };
  for (const auto& [name, drive] : drives)
    cells.push_back({ "exact sphere", name,
      fmt::format("[vesicle]\nshape = \"sphere\"\ntriangles = {}\n", triangles) + bending + drive +
        time_table(0.5),
      1 });
  for (const int few : { 20, 40 })
    cells.push_back({ "triangles", fmt::format("{}", few),
      vesicle("prolate", 0.9, few) + bending + time_table(0.1), 1 });
  cells.push_back({ "no bending", "shear",
    vesicle("prolate", 0.9, triangles) + "[flow]\nkind = \"shear\"\nrate = 1.0\n" + time_table(1),
    1 });
}

void add_fluids_and_sheets(std::vector<Cell>& cells, int triangles)
{
  const std::string shear = "[flow]\nkind = \"shear\"\nrate = 1.0\n";
  for (const double ratio : { 0., 1e-3, 10., 1e3 })
    cells.push_back({ "viscosity ratio", fmt::format("{:g}", ratio),
      vesicle("prolate", 0.9, triangles) + bending + shear +
        fmt::format("[fluid]\nviscosity_ratio = {:.4f}\n", ratio) + time_table(1),
      1 });
  for (const double capillary : { 1e-2, 0.3, 1. })
    cells.push_back({ "capsule", fmt::format("Ca = {:g}", capillary),
      fmt::format("[vesicle]\nshape = \"sphere\"\ntriangles = {}\n[membrane]\nincompressible = "
                  "false\nshear_modulus = {:.3f}\n[accuracy]\nmesh_motion = \"material\"\n",
        triangles, 1 / capillary) +
        shear + time_table(1),
      1 });
}

TriangleMesh mesh_of(const std::string& scene)
{
  return make_start_mesh(parse_scene(scene, "cell"));
}

/// The mesh with another point for each.
template<class Map>
TriangleMesh moved(TriangleMesh mesh, Map map)
{
  for (Eigen::Index i = 0; i < mesh.points.rows(); ++i)
    mesh.points.row(i) = map(i, Vector3(mesh.points.row(i).transpose())).transpose();
  return mesh;
}

/// A sphere whose points are drawn to its equator, all triangles with corners on the sphere, until the
/// smallest angle is that.
TriangleMesh drawn_to_the_equator(const TriangleMesh& sphere, double smallest_angle)
{
  const auto drawn = [&](double factor)
  {
    return moved(sphere,
      [=](Eigen::Index, const Vector3& x)
      { return Vector3(x.x(), x.y(), factor * x.z()).normalized(); });
  };
  double low = 0, high = 1;
  for (int i = 0; i < 60; ++i)
    (mesh_quality(drawn((low + high) / 2)).min_angle_deg < smallest_angle ? low : high) =
      (low + high) / 2;
  return drawn(high);
}

/// Meshes as a file may bring them, taken as they are.
void add_meshes(std::vector<Cell>& cells, int triangles)
{
  const std::string drive = bending + "[flow]\nkind = \"shear\"\nrate = 1.0\n" + time_table(0.1);
  const std::string start = vesicle("prolate", 0.9, triangles) + drive;
  for (const double share : { 0.1, 0.2, 0.3 })
  {
    const double edge = std::sqrt(4 * M_PI / triangles * 4 / std::sqrt(3.));
    const auto jitter = [=](Eigen::Index i, const Vector3& x)
    {
      const Vector3 random(
        std::sin(12.9898 * i + 1), std::sin(78.233 * i + 2), std::sin(37.719 * i + 3));
      return Vector3(x + share * edge * random.normalized());
    };
    cells.push_back({ "mesh", fmt::format("jittered by {:g}", share), start, 1,
      [=] { return moved(mesh_of(start), jitter); } });
  }
  const std::string sphere =
    fmt::format("[vesicle]\nshape = \"sphere\"\ntriangles = {}\n", triangles) + drive;
  for (const double angle : { 10., 1. })
    cells.push_back({ "mesh", fmt::format("angles of {:g}°", angle), sphere, 1,
      [=] { return drawn_to_the_equator(mesh_of(sphere), angle); } });
}

/// Sums what a membrane's energy gains and loses from one state to the next.
class EnergyBooks
{
public:
  void add(const Diagnostics& d)
  {
    if (steps_++ > 0)
    {
      const double half = (d.time - last_.time) / 2;
      gained_ += half * (d.power_in - d.dissipation + last_.power_in - last_.dissipation);
      work_ += half * (d.power_in + last_.power_in);
      moved_ += half *
        (std::abs(d.power_in) + d.dissipation + std::abs(last_.power_in) + last_.dissipation);
    }
    else
      first_ = d;
    last_ = d;
  }
  std::optional<double> imbalance() const
  {
    if (steps_ < 3 || moved_ == 0)
      return {};
    return std::abs(last_.bending_energy - first_.bending_energy - gained_) / moved_;
  }

  /// What the energy has risen by beyond all work that was done, which no membrane does: nothing but
  /// that work makes it rise, and only what is left of it after what the fluid dissipates. Up to the
  /// error of the rule that sums the work.
  double unpaid() const
  {
    const double rise = last_.bending_energy - first_.bending_energy;
    return rise - work_ - 0.1 * moved_ - 1e-6 * last_.bending_energy;
  }

private:
  int steps_ = 0;
  Diagnostics first_, last_;
  double gained_ = 0, work_ = 0, moved_ = 0;
};

CellResult judged(Simulation& simulation, const State& state, CellResult result)
{
  const Diagnostics d = simulation.diagnose(state);
  result.longest = d.semi_axes[0];
  const ErrorEstimate errors = simulation.error_estimate(state);
  result.energy = d.energy_over_8pi;
  result.estimate = errors.space() + errors.time;
  result.time = state.time;
  const auto wrong = [&](const std::string& why)
  {
    result.end = CellResult::End::wrong;
    result.message = why;
    return result;
  };
  for (std::size_t i = 0; i < Diagnostics::names().size(); ++i)
    if (const auto value = d.values()[i]; value && !std::isfinite(*value))
      return wrong(Diagnostics::names()[i] + " isn't finite");
  const bool keeps_area = simulation.scene().membrane.incompressible;
  if ((keeps_area && !(std::abs(d.area_drift) < most_drift)) ||
    !(std::abs(d.volume_drift) < most_drift))
    return wrong(
      fmt::format("area or volume drift by {:.1e}, {:.1e}", d.area_drift, d.volume_drift));
  if (const auto crossing = find_self_crossing(simulation.mesh(state)))
    return wrong(to_text(*crossing));
  return result;
}

CellResult simulated(const Cell& cell)
{
  CellResult result{ CellResult::End::runs, "" };
  const Scene scene = parse_scene(cell.scene, "cell");
  Simulation simulation(scene, cell.mesh ? cell.mesh() : make_start_mesh(scene));
  const bool has_energy = scene.membrane.bending_rigidity || scene.membrane.shear_modulus;
  EnergyBooks books;
  State state;
  try
  {
    state = simulation.start();
    books.add(simulation.diagnose(state));
    while (!simulation.finished(state))
    {
      state = simulation.step(state);
      books.add(simulation.diagnose(state));
      result.steps = static_cast<int>(state.step + state.controller.rejected);
      result.time = state.time;
      if (result.steps > most_steps * cell.strain)
        return { CellResult::End::crawls, "more steps than its strain allows", state.time,
          result.steps };
    }
  }
  catch (const NumericalError& error)
  {
    result.end = CellResult::End::stopped;
    result.message = error.what();
    return result;
  }
  if (has_energy)
    result.imbalance = books.imbalance();
  if (has_energy && books.unpaid() > 0)
    return { CellResult::End::wrong, "its energy rises without any work that pays for it",
      state.time, result.steps };
  return judged(simulation, state, result);
}

}

std::vector<Cell> extremes(int triangles)
{
  std::vector<Cell> cells;
  add_shapes(cells, triangles);
  add_loads(cells, triangles);
  add_flows(cells, triangles);
  add_steps(cells, triangles);
  add_units(cells, triangles);
  add_others(cells, triangles);
  add_fluids_and_sheets(cells, triangles);
  add_meshes(cells, triangles);
  return cells;
}

CellResult run_cell(const Cell& cell)
try
{
  return simulated(cell);
}
catch (const InputError& error)
{
  return { CellResult::End::refused, error.what() };
}
catch (const std::exception& error)
{
  return { CellResult::End::wrong, error.what() };
}

double difference(const CellResult& a, const CellResult& b)
{
  const auto relative = [](double x, double y)
  { return y == 0 ? std::abs(x) : std::abs(x / y - 1); };
  return std::max(relative(a.energy, b.energy), relative(a.longest, b.longest));
}

const char* end_name(CellResult::End end)
{
  constexpr const char* names[]{ "runs", "refused", "stopped", "crawls", "wrong" };
  return names[static_cast<int>(end)];
}

}
