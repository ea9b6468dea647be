#include "apps/RunPlots.h"

#include "solver/Errors.h"
#include "solver/scene/Quantity.h"

#include <fmt/format.h>

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
  const char* measures; ///< as the schema of scenes says it; empty: no dimension
  std::vector<Line> lines;
};

const std::vector<Subject> subjects{
  { "energy", "Bending energy", "E / 8 pi EB", "", { { "energy_over_8pi", "" } } },
  { "velocity", "Velocity of the centroid", "velocity", "length / time",
    { { "velocity_x", "x" }, { "velocity_y", "y" }, { "velocity_z", "z" } } },
  { "inclination", "Inclination of the long axis", "degrees", "", { { "inclination_deg", "" } } },
  { "tension", "Tension", "tension", "energy / area",
    { { "tension_min", "lowest" }, { "tension_max", "highest" } } },
  { "axes", "Semi-axes", "semi-axes", "length",
    { { "semi_axis_1", "1" }, { "semi_axis_2", "2" }, { "semi_axis_3", "3" } } },
  { "corrections", "Area and volume errors removed so far", "relative", "",
    { { "area_correction", "area" }, { "volume_correction", "volume" } } },
  { "step", "Time step", "dt", "time", { { "dt", "" } } },
};

const Subject& subject_of(const std::string& name)
{
  const auto subject = std::find_if(
    subjects.begin(), subjects.end(), [&](const Subject& s) { return s.name == name; });
  if (subject == subjects.end())
  {
    throw InputError("there is no chart \"" + name + "\"");
  }
  return *subject;
}

bool says_something(const std::string& subject, const Scene& scene)
{
  return subject == "energy"   ? scene.membrane.bending_rigidity.has_value()
    : subject == "velocity"    ? scene.gravity.has_value()
    : subject == "inclination" ? scene.flow != nullptr
    : subject == "tension"     ? scene.membrane.incompressible
    : subject == "step"        ? !scene.time.step.has_value()
                               : true;
}

struct Course
{
  Line line;
  std::size_t vesicle;
  std::vector<double> time;
  std::vector<double> value;
};

Course course_of(const RunTable& table, const Line& line, std::size_t vesicle)
{
  const auto time = table.column("time"), values = table.column(line.column);
  Course course{ line, vesicle, {}, {} };
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    if (time[i] && values[i])
    {
      course.time.push_back(*time[i]);
      course.value.push_back(*values[i]);
    }
  }
  return course;
}

double largest(const Course& course)
{
  double value = 0;
  for (const double y : course.value)
  {
    value = std::max(value, std::abs(y));
  }
  return value;
}

std::string with_unit(const std::string& label, const char* measures, Units units)
{
  const Dimensions dimensions = dimensions_of(measures);
  return units == Units::si && !dimensions.empty()
    ? fmt::format("{} in {}", label, si_unit(dimensions.front()))
    : label;
}

/// In the legend of a chart of so many lines. More than it has room for are told apart by nobody.
std::string label_of(const Course& course, std::size_t vesicles, std::size_t lines)
{
  constexpr std::size_t most_labels = 12;
  if (vesicles == 1)
  {
    return course.line.label;
  }
  const std::string line = course.line.label;
  return lines > most_labels
    ? ""
    : fmt::format("{}{}{}", course.vesicle, line.empty() ? "" : ": ", line);
}

/// Without those that are missing, or nothing but rounding beside the others.
std::vector<Course> courses_of(const Subject& subject, const std::vector<RunTable>& vesicles)
{
  std::vector<Course> courses;
  double scale = 0;
  for (std::size_t v = 0; v < vesicles.size(); ++v)
  {
    for (const Line& line : subject.lines)
    {
      courses.push_back(course_of(vesicles[v], line, v));
      scale = std::max(scale, largest(courses.back()));
    }
  }
  std::erase_if(courses,
    [scale](const Course& course)
    { return course.time.empty() || largest(course) < 1e-6 * scale; });
  return courses;
}

}

std::optional<ChartSpec> run_chart(const std::string& name, const RunTable& table, Units units)
{
  const Subject& subject = subject_of(name);
  const std::vector<RunTable> vesicles = table.by_vesicle();
  const auto courses = courses_of(subject, vesicles);
  if (courses.empty())
  {
    return std::nullopt;
  }
  ChartSpec chart;
  chart.title = subject.title;
  chart.x_label = with_unit("time", "time", units);
  chart.y_label = with_unit(subject.y_label, subject.measures, units);
  for (const Course& course : courses)
  {
    chart.lines.push_back(
      { label_of(course, vesicles.size(), courses.size()), course.time, course.value });
  }
  if (chart.lines.size() == 1 && !chart.lines[0].label.empty())
  {
    chart.y_label += ", " + chart.lines[0].label; // a legend for one line takes room for nothing
    chart.lines[0].label.clear();
  }
  return chart;
}

std::vector<std::string> chart_columns(const std::string& name, const RunTable& table)
{
  std::vector<std::string> columns;
  for (const Course& course : courses_of(subject_of(name), table.by_vesicle()))
  {
    if (std::find(columns.begin(), columns.end(), course.line.column) == columns.end())
    {
      columns.emplace_back(course.line.column);
    }
  }
  return columns;
}

std::vector<RunPlot> run_plots(const Scene& scene, const RunTable& table)
{
  std::vector<RunPlot> plots;
  for (const Subject& subject : subjects)
  {
    auto chart = run_chart(subject.name, table, scene.units);
    if (chart && says_something(subject.name, scene))
    {
      plots.push_back({ subject.name, std::move(*chart) });
    }
  }
  return plots;
}

}
