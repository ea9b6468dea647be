#include "apps/RunPlots.h"

#include "solver/Errors.h"

#include <algorithm>
#include <cmath>

namespace vesicle
{
namespace
{

struct Line
{
  const char* column;
  const char* label; ///< beside others
};

struct Subject
{
  const char* name;
  const char* title;
  const char* y_label;
  std::vector<Line> lines;
};

const std::vector<Subject> subjects{
  { "energy", "Bending energy", "E / 8 pi EB", { { "energy_over_8pi", "" } } },
  { "velocity", "Velocity of the centroid", "velocity",
    { { "velocity_x", "x" }, { "velocity_y", "y" }, { "velocity_z", "z" } } },
  { "inclination", "Inclination of the long axis", "degrees", { { "inclination_deg", "" } } },
  { "tension", "Tension", "tension",
    { { "tension_min", "lowest" }, { "tension_max", "highest" } } },
  { "axes", "Semi-axes", "semi-axes",
    { { "semi_axis_1", "1" }, { "semi_axis_2", "2" }, { "semi_axis_3", "3" } } },
  { "corrections", "Area and volume errors removed so far", "relative",
    { { "area_correction", "area" }, { "volume_correction", "volume" } } },
  { "step", "Time step", "dt", { { "dt", "" } } },
};

bool says_something(const std::string& subject, const Scene& scene)
{
  return subject == "energy"   ? scene.membrane.bending_rigidity.has_value()
    : subject == "velocity"    ? scene.gravity.has_value()
    : subject == "inclination" ? scene.flow.has_value()
    : subject == "tension"     ? scene.membrane.incompressible
    : subject == "step"        ? !scene.time.step.has_value()
                               : true;
}

ChartLine line_of(const RunTable& table, const Line& column)
{
  const auto time = table.column("time"), values = table.column(column.column);
  ChartLine line;
  line.label = column.label;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    if (time[i] && values[i])
    {
      line.x.push_back(*time[i]);
      line.y.push_back(*values[i]);
    }
  }
  return line;
}

double largest(const ChartLine& line)
{
  double value = 0;
  for (double y : line.y)
  {
    value = std::max(value, std::abs(y));
  }
  return value;
}

// A line that is nothing but rounding beside the others hides what there is to see.
void remove_idle_lines(std::vector<ChartLine>& lines)
{
  double scale = 0;
  for (const ChartLine& line : lines)
  {
    scale = std::max(scale, largest(line));
  }
  std::erase_if(lines,
    [scale](const ChartLine& line) { return line.x.empty() || largest(line) < 1e-6 * scale; });
}

}

std::optional<ChartSpec> run_chart(const std::string& name, const RunTable& table)
{
  const auto subject = std::find_if(
    subjects.begin(), subjects.end(), [&](const Subject& s) { return s.name == name; });
  if (subject == subjects.end())
  {
    throw InputError("there is no chart \"" + name + "\"");
  }
  ChartSpec chart;
  chart.title = subject->title;
  chart.x_label = "time";
  chart.y_label = subject->y_label;
  for (const Line& line : subject->lines)
  {
    chart.lines.push_back(line_of(table, line));
  }
  remove_idle_lines(chart.lines);
  if (chart.lines.size() == 1 && !chart.lines[0].label.empty())
  {
    chart.y_label += ", " + chart.lines[0].label; // a legend for one line takes room for nothing
    chart.lines[0].label.clear();
  }
  return chart.lines.empty() ? std::nullopt : std::optional(chart);
}

void write_run_plots(const Scene& scene, const RunTable& table, const std::filesystem::path& folder)
{
  for (const Subject& subject : subjects)
  {
    const auto chart = run_chart(subject.name, table);
    if (chart && says_something(subject.name, scene))
    {
      write_chart(folder / (std::string(subject.name) + ".png"), *chart);
    }
  }
}

}
