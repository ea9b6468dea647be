#include "apps/EquilibriumSweep.h"

#include "apps/Commands.h"
#include "apps/EquilibriumText.h"
#include "apps/Interrupt.h"
#include "apps/StandardOutput.h"
#include "apps/Warning.h"

#include "render/Chart.h"
#include "render/RenderBackend.h"
#include "solver/Errors.h"
#include "solver/equilibrium/BranchEquilibrium.h"
#include "solver/files/FileBytes.h"
#include "solver/mesh/SelfCrossing.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <cmath>
#include <limits>
#include <map>
#include <vector>

namespace vesicle
{
namespace
{

constexpr double sphere = 1;

/// Multiples of the step from the first to the last, both in the list.
std::vector<double> reduced_volumes(const EquilibriumSweep& sweep)
{
  constexpr double rounding = 1e-9;
  std::vector<double> result;
  for (int i = 0; sweep.from + i * sweep.step < sweep.to - rounding; ++i)
  {
    // As decimals are meant: 0.3 + 2 · 0.05 is 0.4.
    result.push_back(std::round((sweep.from + i * sweep.step) * 1e12) / 1e12);
  }
  result.push_back(sweep.to);
  return result;
}

std::string line_of(const EquilibriumReport& r, bool crossing)
{
  return fmt::format("{},{},{},{},{},{},{},{},{},{}\n", *r.branch, r.reduced_volume, r.triangles,
    r.energy_over_8pi, *r.energy_error, r.tension, r.pressure, r.stable ? 1 : 0,
    r.lowest_eigenvalues.front(), crossing ? 1 : 0);
}

/// A branch's energies: where it is stable as a line, elsewhere dashed.
struct BranchLines
{
  ChartLine stable, unstable;

  explicit BranchLines(EquilibriumBranch branch)
  {
    constexpr std::array<std::array<int, 3>, 3> colors{ { { 31, 119, 180 }, { 214, 39, 40 },
      { 44, 160, 44 } } };
    stable.label = branch_name(branch);
    unstable.label = branch_name(branch) + ", unstable";
    unstable.style = ChartLine::Style::dashed;
    stable.color = unstable.color = colors[static_cast<std::size_t>(branch)];
  }
  /// Where stability changes the lines meet.
  void add(double v, double energy, bool is_stable)
  {
    constexpr double gap = std::numeric_limits<double>::quiet_NaN();
    const bool changes = !stable.x.empty() && was_stable_ != is_stable;
    stable.x.push_back(v);
    stable.y.push_back(is_stable || changes ? energy : gap);
    unstable.x.push_back(v);
    unstable.y.push_back(is_stable && !changes ? gap : energy);
    was_stable_ = is_stable;
  }

private:
  bool was_stable_ = true;
};

void add_line(ChartSpec& chart, const ChartLine& line)
{
  if (std::ranges::any_of(line.y, [](double y) { return std::isfinite(y); }))
  {
    chart.lines.push_back(line);
  }
}

void draw(const ChartSpec& chart, const std::filesystem::path& file)
{
  try
  {
    render_backend();
  }
  catch (const NothingToDrawWith& error)
  {
    warn(fmt::format("no diagram: {}", error.what()));
    return;
  }
  write_chart(file, chart);
  print("{}\n", file.string());
}

}

int sweep_equilibria(const EquilibriumSweep& sweep, const std::filesystem::path& folder)
{
  spdlog::set_level(spdlog::level::warn);
  watch_for_interrupts();
  make_folder(folder);
  std::string table =
    "branch,reduced_volume,triangles,energy_over_8pi,energy_error,tension,pressure,"
    "stable,lowest_eigenvalue,self_crossing\n";
  const auto file = folder / "equilibria.csv";
  ChartSpec chart{ "Equilibria", "reduced volume", "E / 8 pi EB", {} };
  for (const EquilibriumBranch branch : equilibrium_branches())
  {
    BranchLines lines(branch);
    for (const double v : reduced_volumes(sweep))
    {
      if (interrupted())
      {
        return exit_code::interrupted;
      }
      if (v == sphere)
      {
        if (branch != EquilibriumBranch::stomatocyte)
        {
          lines.add(v, 1, branch == EquilibriumBranch::prolate);
        }
        continue;
      }
      try
      {
        const BranchEquilibrium found = branch_equilibrium({ branch, v, sweep.triangles, false });
        EquilibriumReport report = report_of(found.equilibrium, found.mesh);
        report.branch = branch_name(branch);
        report.energy_error = found.equilibrium.energy / found.axisymmetric_energy - 1;
        const bool crossing = find_self_crossing(found.mesh).has_value();
        table += line_of(report, crossing);
        if (!crossing)
        {
          lines.add(v, report.energy_over_8pi, report.stable);
        }
        print("{:<12}{:<7g}{:.7f}  {}{}\n", *report.branch, v, report.energy_over_8pi,
          report.stable ? "stable" : "unstable", crossing ? ", passes through itself" : "");
      }
      catch (const InputError&)
      {
        print("{:<12}{:<7g}none\n", branch_name(branch), v);
      }
      catch (const NumericalError& error)
      {
        print("{:<12}{:<7g}not found: {}\n", branch_name(branch), v, error.what());
      }
      replace_file(file, table);
    }
    add_line(chart, lines.stable);
    add_line(chart, lines.unstable);
  }
  print("{}\n", file.string());
  draw(chart, folder / "equilibria.png");
  return exit_code::done;
}

}
