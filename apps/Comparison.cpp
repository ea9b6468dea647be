#include "apps/Comparison.h"

#include "apps/FoundRun.h"
#include "apps/JsonText.h"

#include "solver/Errors.h"
#include "solver/Joined.h"
#include "solver/mesh/MeshIntegrals.h"
#include "solver/scene/NearestName.h"
#include "solver/scene/SceneFile.h"
#include "solver/surface/LimitTriangles.h"
#include "vtkfilters/Filters/MeshConversion.h"
#include "vtkfilters/Filters/MeshFiles.h"
#include "vtkfilters/Filters/SceneNumbers.h"

#include "vtkFieldData.h"
#include "vtkPolyData.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace vesicle
{
namespace
{

using std::filesystem::path;
using Json = nlohmann::ordered_json;

/// Of the longest time: output times are hit exactly, those of other settings but for rounding.
constexpr double same_time = 1e-9;
/// Flat pieces of Loop's surface a triangle and side, which are within 1/16 of what the triangles
/// are off by.
constexpr int limit_cuts = 4;

const std::vector<std::string>& usual_columns()
{
  static const std::vector<std::string> names{ "area", "volume", "reduced_volume", "bending_energy",
    "energy_over_8pi", "tension_min", "tension_max", "centroid_x", "centroid_y", "centroid_z",
    "velocity_x", "velocity_y", "velocity_z", "inclination_deg", "tilt_deg", "semi_axis_1",
    "semi_axis_2", "semi_axis_3", "taylor_deformation", "tank_treading_frequency", "power_in",
    "dissipation" };
  return names;
}

/// The surface that a file's points stand for.
TriangleMesh surface_in(const path& file, bool centred)
{
  const auto surface = without_ghosts(read_mesh(file));
  TriangleMesh mesh = to_mesh(surface);
  if (mesh.triangles.rows() == 0)
  {
    throw InputError(file.string() + ": has no triangles to compare");
  }
  if (surface_basis(surface->GetFieldData()) == SurfaceBasis::loop)
  {
    mesh = limit_triangles(mesh, limit_cuts);
  }
  if (centred)
  {
    mesh.points.rowwise() -= volume_centroid(mesh).transpose();
  }
  return mesh;
}

SurfaceDistance distance_of(const path& a, const path& b, bool centred)
{
  return surface_distance(surface_in(a, centred), surface_in(b, centred));
}

FoundRun run_of(const path& input)
{
  if (is_series(input))
  {
    const path folder = input.parent_path();
    return { RunFolder(folder, ""), input.string(), read_series(input), run_beside(input) };
  }
  return run_in(input);
}

std::vector<std::string> lines_of(const std::optional<Scene>& scene)
{
  std::vector<std::string> lines;
  std::istringstream text(scene ? write_scene(*scene) : "");
  std::string table, vesicle = "vesicle";
  int vesicles = 0;
  for (std::string line; std::getline(text, line);)
  {
    if (line.starts_with("[["))
    {
      vesicle = fmt::format("vesicle.{}", vesicles++);
      table = vesicle + ".";
    }
    else if (line.starts_with("[vesicle."))
    {
      table = vesicle + line.substr(8, line.size() - 9) + ".";
    }
    else if (line.starts_with('['))
    {
      table = line.substr(1, line.size() - 2) + ".";
    }
    else if (!line.empty())
    {
      lines.push_back(table + line);
    }
  }
  return lines;
}

void add_missing(const std::string& whose, const std::vector<std::string>& lines,
  const std::vector<std::string>& from, std::vector<std::string>& differences)
{
  for (const std::string& line : lines)
  {
    if (std::find(from.begin(), from.end(), line) == from.end())
    {
      differences.push_back(whose + ": " + line);
    }
  }
}

std::vector<std::string> different_settings(
  const std::optional<Scene>& a, const std::optional<Scene>& b)
{
  std::vector<std::string> differences;
  if (a && b)
  {
    add_missing("A", lines_of(a), lines_of(b), differences);
    add_missing("B", lines_of(b), lines_of(a), differences);
  }
  return differences;
}

void require_column(const std::string& column, const RunTable& table, const std::string& run)
{
  if (std::find(table.columns.begin(), table.columns.end(), column) == table.columns.end())
  {
    const std::string nearest = nearest_name(column, table.columns);
    throw InputError(fmt::format("{}: the table of diagnostics has no column '{}'{}", run, column,
      nearest.empty() ? "; its first line lists them"
                      : fmt::format(", did you mean '{}'?", nearest)));
  }
}

std::vector<std::string> columns_of(
  const FoundRun& a, const FoundRun& b, const std::vector<std::string>& wanted)
{
  if (!a.beside.table || !b.beside.table)
  {
    return {};
  }
  for (const std::string& column : wanted)
  {
    require_column(column, *a.beside.table, a.name);
    require_column(column, *b.beside.table, b.name);
  }
  return wanted.empty() ? usual_columns() : wanted;
}

/// Of each vesicle; without a table one without rows.
std::vector<RunTable> tables_of(const FoundRun& run)
{
  return run.beside.table ? run.beside.table->by_vesicle() : std::vector<RunTable>(1);
}

/// The row of that time; empty values where there is none.
std::vector<std::optional<double>> values_at(
  const RunTable& table, double time, double tolerance, const std::vector<std::string>& columns)
{
  std::vector<std::optional<double>> values(columns.size());
  const auto times = table.column("time");
  const auto row = std::find_if(times.begin(), times.end(),
    [&](const auto& t) { return t && std::abs(*t - time) <= tolerance; });
  for (std::size_t i = 0; i < columns.size() && row != times.end(); ++i)
  {
    values[i] = table.column(columns[i])[static_cast<std::size_t>(row - times.begin())];
  }
  return values;
}

std::string difference_text(const ComparedValue& v)
{
  return v.a && v.b ? fmt::format("{:+.3e}", *v.b - *v.a) : "-";
}

std::string value_text(const std::optional<double>& value)
{
  return value ? fmt::format("{:.8g}", *value) : "-";
}

Json json_of(const SurfaceDistance& d)
{
  return { { "mean", d.mean }, { "rms", d.rms }, { "largest", d.largest },
    { "place", { d.place.x(), d.place.y(), d.place.z() } } };
}

std::string distances_text(const RunComparison& c)
{
  std::string text =
    fmt::format("{:>14} {:>14} {:>14} {:>14}\n", "time", "mean distance", "rms", "largest");
  for (const auto& m : c.moments)
  {
    text += fmt::format("{:>14.8g} {:>14.4e} {:>14.4e} {:>14.4e}\n", m.time, m.distance.mean,
      m.distance.rms, m.distance.largest);
  }
  return text;
}

/// At the last common time, and the largest difference at any.
std::string values_text(const RunComparison& c)
{
  if (c.columns.empty())
  {
    return {};
  }
  std::string text = fmt::format("\n{:<24} {:>16} {:>16} {:>12} {:>14} {:>12}\n",
    fmt::format("at t = {:.6g}", c.moments.back().time), "A", "B", "B - A", "largest |B - A|",
    "at t");
  for (std::size_t i = 0; i < c.columns.size(); ++i)
  {
    double largest = -1, when = 0;
    for (const auto& m : c.moments)
    {
      const ComparedValue& v = m.values[i];
      if (v.a && v.b && std::abs(*v.b - *v.a) > largest)
      {
        largest = std::abs(*v.b - *v.a);
        when = m.time;
      }
    }
    const ComparedValue& last = c.moments.back().values[i];
    if (largest >= 0)
    {
      text += fmt::format("{:<24} {:>16} {:>16} {:>12} {:>15.3e} {:>12.6g}\n", c.columns[i],
        value_text(last.a), value_text(last.b), difference_text(last), largest, when);
    }
  }
  return text;
}

}

RunComparison compare_runs(const path& a, const path& b, const CompareSettings& settings)
{
  const FoundRun first = run_of(a), second = run_of(b);
  RunComparison result;
  result.settings = different_settings(first.beside.scene, second.beside.scene);
  const std::vector<std::string> columns = columns_of(first, second, settings.columns);
  const std::vector<RunTable> of_first = tables_of(first), of_second = tables_of(second);
  const std::size_t vesicles = std::min(of_first.size(), of_second.size());
  for (std::size_t v = 0; v < vesicles; ++v)
  {
    for (const std::string& column : columns)
    {
      result.columns.push_back(vesicles == 1 ? column : fmt::format("{} of {}", column, v));
    }
  }
  double longest = 0;
  for (const SeriesFrame& frame : first.frames)
  {
    longest = std::max(longest, std::abs(frame.time));
  }
  const double tolerance = same_time * longest;
  for (const SeriesFrame& frame : first.frames)
  {
    const auto twin = std::find_if(second.frames.begin(), second.frames.end(),
      [&](const SeriesFrame& other) { return std::abs(other.time - frame.time) <= tolerance; });
    if (twin == second.frames.end())
    {
      continue;
    }
    RunComparison::Moment moment{ frame.time, distance_of(frame.file, twin->file, settings.centred),
      {} };
    for (std::size_t v = 0; v < vesicles; ++v)
    {
      const auto here = values_at(of_first[v], frame.time, tolerance, columns);
      const auto there = values_at(of_second[v], frame.time, tolerance, columns);
      for (std::size_t i = 0; i < here.size(); ++i)
      {
        moment.values.push_back({ here[i], there[i] });
      }
    }
    result.moments.push_back(std::move(moment));
  }
  if (result.moments.empty())
  {
    throw InputError(
      fmt::format("{} and {} have no frames of the same time: run both with the same "
                  "time.output_every, or one that divides the other",
        a.string(), b.string()));
  }
  return result;
}

MeshComparison compare_meshes(const path& a, const path& b, bool centred)
{
  const auto report = [](const path& file)
  {
    const auto surface = without_ghosts(read_mesh(file));
    return MeshReport(to_mesh(surface), surface_basis(surface->GetFieldData()));
  };
  return { report(a), report(b), distance_of(a, b, centred) };
}

std::string to_text(const RunComparison& c)
{
  std::string text;
  if (!c.settings.empty())
  {
    text = "settings that differ\n  " + joined(c.settings, "\n  ") + "\n\n";
  }
  return text + distances_text(c) + values_text(c);
}

std::string to_text(const MeshComparison& c)
{
  std::string text = fmt::format("{:<18} {:>16} {:>16} {:>12}\n", "", "A", "B", "B - A");
  const auto add = [&](const char* name, std::optional<double> a, std::optional<double> b)
  {
    const ComparedValue value{ a, b };
    text += fmt::format(
      "{:<18} {:>16} {:>16} {:>12}\n", name, value_text(a), value_text(b), difference_text(value));
  };
  add("triangles", static_cast<double>(c.a.triangles), static_cast<double>(c.b.triangles));
  add("area", c.a.area, c.b.area);
  add("volume", c.a.volume, c.b.volume);
  add("reduced volume", c.a.reduced_volume, c.b.reduced_volume);
  add("energy / 8 pi EB", c.a.energy_over_8pi, c.b.energy_over_8pi);
  add("smallest angle", c.a.quality.min_angle_deg, c.b.quality.min_angle_deg);
  const Vector3& x = c.distance.place;
  return text +
    fmt::format("distance: mean {:.4e}, rms {:.4e}, largest {:.4e} near ({:.4g}, {:.4g}, {:.4g})\n",
      c.distance.mean, c.distance.rms, c.distance.largest, x.x(), x.y(), x.z());
}

nlohmann::ordered_json to_json(const RunComparison& c)
{
  Json moments = Json::array();
  for (const auto& m : c.moments)
  {
    Json values = Json::object();
    for (std::size_t i = 0; i < c.columns.size(); ++i)
    {
      values[c.columns[i]] = { json_number(m.values[i].a), json_number(m.values[i].b) };
    }
    moments.push_back(
      { { "time", m.time }, { "distance", json_of(m.distance) }, { "values", values } });
  }
  return { { "settings", c.settings }, { "moments", moments } };
}

nlohmann::ordered_json to_json(const MeshComparison& c)
{
  return { { "a", to_json(c.a) }, { "b", to_json(c.b) }, { "distance", json_of(c.distance) } };
}

}
