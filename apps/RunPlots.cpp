#include "apps/RunPlots.h"

#include "render/Chart.h"
#include "solver/dynamics/Diagnostics.h"

#include <algorithm>
#include <cmath>

namespace vesicle
{
namespace
{

struct Subject
{
  const char* file;
  const char* title;
  const char* y_label;
  std::vector<const char*> columns;
  bool wanted;
};

std::vector<Subject> subjects_of(const Scene& scene)
{
  return {
    { "energy", "Bending energy", "E / 8 pi EB", { "energy_over_8pi" },
      scene.membrane.bending_rigidity.has_value() },
    { "speed", "Velocity of the centroid", "velocity", { "velocity_x", "velocity_y", "velocity_z" },
      scene.gravity.has_value() },
    { "inclination", "Inclination of the long axis", "degrees", { "inclination_deg" },
      scene.flow.has_value() },
    { "tension", "Tension", "smallest and largest", { "tension_min", "tension_max" },
      scene.membrane.incompressible },
    { "axes", "Semi-axes", "semi-axes", { "semi_axis_1", "semi_axis_2", "semi_axis_3" }, true },
    { "corrections", "Area and volume errors removed so far", "relative",
      { "area_correction", "volume_correction" }, true },
    { "step", "Time step", "dt", { "dt" }, !scene.time.step },
  };
}

std::size_t column_of(const std::string& name)
{
  const auto& names = Diagnostics::names();
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

ChartLine line_of(const std::vector<Row>& rows, const std::string& name)
{
  const std::size_t time = column_of("time"), column = column_of(name);
  ChartLine line;
  line.label = name;
  for (const Row& row : rows)
  {
    if (row[column])
    {
      line.x.push_back(*row[time]);
      line.y.push_back(*row[column]);
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
  std::erase_if(lines, [scale](const ChartLine& line) { return largest(line) < 1e-6 * scale; });
}

}

void write_run_plots(
  const Scene& scene, const std::vector<Row>& rows, const std::filesystem::path& folder)
{
  for (const Subject& subject : subjects_of(scene))
  {
    ChartSpec chart;
    chart.title = subject.title;
    chart.x_label = "time";
    chart.y_label = subject.y_label;
    for (const char* column : subject.columns)
    {
      ChartLine line = line_of(rows, column);
      if (!line.x.empty())
      {
        chart.lines.push_back(std::move(line));
      }
    }
    remove_idle_lines(chart.lines);
    if (subject.wanted && !chart.lines.empty())
    {
      write_chart(folder / (std::string(subject.file) + ".png"), chart);
    }
  }
}

}
