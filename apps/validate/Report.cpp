#include "apps/validate/Report.h"
#include "apps/StandardOutput.h"

#include "apps/Progress.h"

#include "render/SceneGuides.h"
#include "solver/simulation/Simulation.h"
#include "solver/files/FileBytes.h"
#include "vtkfilters/Filters/MeshConversion.h"

#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace vesicle::validation
{
namespace
{

using Json = nlohmann::ordered_json;

const char* kind_name(Row::Kind kind)
{
  static constexpr const char* names[] = { "relative", "absolute", "at most", "at least" };
  return names[static_cast<int>(kind)];
}

bool is_bound(const Row& row)
{
  return row.kind == Row::Kind::at_most || row.kind == Row::Kind::at_least;
}

std::string number(double value)
{
  return std::isfinite(value) ? fmt::format("{:.6g}", value) : "-";
}

std::string reference_cell(const Row& row)
{
  const std::string text = number(row.reference);
  return row.kind == Row::Kind::at_most ? "<= " + text
    : row.kind == Row::Kind::at_least   ? ">= " + text
                                        : text;
}

// Bounds have no error but the number itself.
std::string error_cell(const Row& row, double value)
{
  return is_bound(row) || !std::isfinite(value) ? "-"
    : row.kind == Row::Kind::relative           ? fmt::format("{:.2g}%", 100 * value)
                                                : fmt::format("{:.2g}", value);
}

Json json_number(double value)
{
  return std::isfinite(value) ? Json(value) : Json();
}

Json to_json(const Row& row)
{
  return { { "name", row.name }, { "reference", json_number(row.reference) },
    { "computed", json_number(row.computed) }, { "kind", kind_name(row.kind) },
    { "error", json_number(row.error) }, { "tolerance", row.tolerance }, { "passed", row.passed },
    { "seconds", row.seconds }, { "note", row.note } };
}

double seconds(std::chrono::steady_clock::duration duration)
{
  return std::chrono::duration<double>(duration).count();
}

constexpr const char* line_format = "  {:<38} {:>11} {:>11} {:>9} {:>9}  {:<4} {:>7}\n";

}

Report::Report(Options options) : options_(std::move(options)), began_(Clock::now()), last_(began_)
{
  write_json();
  if (options_.plots)
  {
    make_folder(*options_.plots);
  }
  print(line_format, "", "reference", "computed", "error", "tolerance", "", "time");
}

void Report::begin(const std::string& name, const std::string& about)
{
  case_ = name;
  last_ = Clock::now();
  print("{}: {}\n", name, about);
  flush_standard_output();
}

void Report::add(Row row)
{
  const auto now = Clock::now();
  row.seconds = seconds(now - last_);
  last_ = now;
  print(line_format, row.name, reference_cell(row), number(row.computed),
    error_cell(row, row.error), error_cell(row, row.tolerance), row.passed ? "ok" : "FAIL",
    fmt::format("{:.1f} s", row.seconds));
  if (!row.note.empty())
  {
    print("    {}\n", row.note);
  }
  flush_standard_output();
  row.name = case_ + "/" + row.name;
  rows_.push_back(std::move(row));
  write_json();
}

int Report::failures() const
{
  return static_cast<int>(
    std::count_if(rows_.begin(), rows_.end(), [](const Row& row) { return !row.passed; }));
}

void Report::print_total() const
{
  print("{} rows, {} failed, {}\n", rows_.size(), failures(),
    duration_text(seconds(Clock::now() - began_)));
}

void Report::write_json() const
{
  if (!options_.json)
  {
    return;
  }
  auto list = Json::array();
  for (const Row& row : rows_)
  {
    list.push_back(to_json(row));
  }
  const Json document{ { "version", VESICLE_VERSION }, { "set", full() ? "full" : "fast" },
    { "failed", failures() }, { "seconds", seconds(Clock::now() - began_) }, { "rows", list } };
  replace_file(*options_.json, document.dump(2) + "\n");
}

void Report::chart(const std::string& name, const std::vector<ChartSpec>& charts, int columns) const
{
  if (draws())
  {
    write_charts(*options_.plots / (name + ".png"), charts, columns);
  }
}

void Report::picture(const std::string& name, Simulation& simulation, const State& state,
  PictureSettings settings) const
{
  if (!draws())
  {
    return;
  }
  const auto surface = to_polydata(simulation.mesh(state));
  for (const auto& [array, values] : simulation.fields(state))
  {
    surface->GetPointData()->AddArray(to_array(array, values));
  }
  settings.smooth = true;
  settings.guides = scene_guides(simulation.scene(), View::named(settings.view));
  Picture picture(std::move(settings));
  picture.draw(surface, simulation.time(state));
  picture.write_png(*options_.plots / (name + ".png"));
}

}
