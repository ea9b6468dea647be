#include "apps/RunReport.h"

#include "apps/FoundRun.h"
#include "apps/JsonText.h"

#include "solver/files/FileLock.h"
#include "solver/scene/SceneFile.h"
#include "solver/state/RunFile.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <vector>

namespace vesicle
{
namespace
{

using Json = nlohmann::ordered_json;

/// Of the last sitting that came to its end; an empty object if there is none.
Json read_summary(const std::filesystem::path& file)
{
  std::ifstream in(file);
  Json json = Json::parse(in, nullptr, false);
  return json.is_object() ? json : Json::object();
}

std::string word(const Json& json, const char* key)
{
  return json.contains(key) && json[key].is_string() ? json[key].get<std::string>() : "";
}

void take_last_row(const RunTable& table, RunReport& report)
{
  if (table.rows.empty())
  {
    return;
  }
  std::vector<RunReport::LastRow> rows;
  for (const RunTable& own : table.by_vesicle())
  {
    RunReport::LastRow& row = rows.emplace_back();
    for (std::size_t i = 0; i < own.columns.size(); ++i)
    {
      row[own.columns[i]] = own.rows.back()[i];
    }
  }
  report.last = rows.front();
  report.others.assign(rows.begin() + 1, rows.end());
  report.time = report.last["time"].value_or(0);
}

/// A sitting that ended by itself tells how in summary.json; a later one that was killed left rows
/// behind that it knows nothing of.
void find_state(const FoundRun& run, const Json& summary, RunReport& report)
{
  const std::string holder = lock_holder(run.folder.lock());
  const std::string outcome = word(summary, "outcome");
  const double told =
    summary.contains("steps") && summary["steps"].is_number() ? summary["steps"].get<double>() : -1;
  if (!holder.empty())
  {
    report.state = "running";
    report.reason = "under way in " + holder;
  }
  else if (outcome.empty() || (report.last.contains("step") && report.last["step"] > told))
  {
    report.state = "killed";
    report.reason = "it ended without a word: killed, or the machine went down";
  }
  else
  {
    report.state = outcome;
    report.reason = outcome == "finished" ? "time.end was reached"
      : outcome == "steady"               ? "the shape is steady"
      : outcome == "interrupted"          ? "Ctrl-C, or a signal to end"
                                          : word(summary, "message");
  }
}

/// Before a sitting has ended only the run file has the scene, and it may just be being written.
std::optional<Scene> scene_of_run(const FoundRun& run)
{
  if (run.beside.scene)
  {
    return run.beside.scene;
  }
  try
  {
    const auto file = run.folder.checkpoint();
    return parse_scene(RunFile::open(file).header().scene, file.string());
  }
  catch (const std::exception&) // the report can do without
  {
    return std::nullopt;
  }
}

std::string remedy(const RunReport& report, const Json& summary)
{
  if (report.state == "running" || report.state == "steady")
  {
    return {};
  }
  const std::string scene = word(summary, "scene_file");
  const std::string longer = report.state == "finished" ? " --set time.end=…" : "";
  return fmt::format("vesicle run {} -o {} --resume{}", scene.empty() ? "SCENE.toml" : scene,
    report.folder.string(), longer);
}

std::string progress_text(const RunReport& r)
{
  std::string text = fmt::format("t = {:.6g}", r.time);
  if (r.end)
  {
    text += fmt::format(" of {:.6g} ({:.0f}%)", *r.end, *r.end > 0 ? 100 * r.time / *r.end : 100);
  }
  const auto step = r.last.find("step");
  return step == r.last.end() ? text : text + fmt::format(", step {}", step->second.value_or(0));
}

struct Line
{
  const char* name;
  std::vector<const char*> columns;
};

/// Of the last row: what tells how good it is, then what it is.
const std::vector<Line>& lines_of_last_row()
{
  static const std::vector<Line> lines{ { "last step", { "dt" } },
    { "drifts", { "area_drift", "volume_drift" } },
    { "corrections", { "area_correction", "volume_correction" } },
    { "divergence", { "divergence" } }, { "mesh", { "min_angle_deg", "edge_ratio" } },
    { "solver", { "iterations", "rejected" } }, { "remeshings", { "remeshings" } },
    { "shape", { "reduced_volume", "energy_over_8pi", "taylor_deformation" } },
    { "angles", { "inclination_deg", "tilt_deg" } },
    { "tension", { "tension_min", "tension_max" } },
    { "velocity", { "velocity_x", "velocity_y", "velocity_z" } },
    { "centroid", { "centroid_x", "centroid_y", "centroid_z" } } };
  return lines;
}

/// Of several vesicles from the least to the largest.
std::string values_text(const RunReport& r, const char* column)
{
  std::vector<double> values;
  const auto add = [&](const RunReport::LastRow& row)
  {
    const auto found = row.find(column);
    if (found != row.end() && found->second)
    {
      values.push_back(*found->second);
    }
  };
  add(r.last);
  std::for_each(r.others.begin(), r.others.end(), add);
  if (values.empty())
  {
    return {};
  }
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return *least == *most ? fmt::format("{} {:.6g}", column, *least)
                         : fmt::format("{} {:.6g} to {:.6g}", column, *least, *most);
}

std::string last_row_text(const RunReport& r)
{
  std::string text;
  if (!r.others.empty())
  {
    text += fmt::format("  {:<16} {}\n", "vesicles", r.others.size() + 1);
  }
  for (const Line& line : lines_of_last_row())
  {
    std::string values;
    for (const char* column : line.columns)
    {
      const std::string value = values_text(r, column);
      values += (values.empty() || value.empty() ? "" : ", ") + value;
    }
    if (!values.empty())
    {
      text += fmt::format("  {:<16} {}\n", line.name, values);
    }
  }
  return text;
}

}

RunReport report_of_run(const std::filesystem::path& folder)
{
  const FoundRun run = run_in(folder);
  const Json summary = read_summary(run.folder.summary());
  RunReport report;
  report.folder = folder;
  report.name = run.name;
  if (run.beside.table)
  {
    take_last_row(*run.beside.table, report);
  }
  if (const auto scene = scene_of_run(run))
  {
    report.end = scene->time.end;
  }
  report.frames = run.frames.size();
  if (!run.frames.empty())
  {
    report.last_frame_time = run.frames.back().time;
    report.last_frame = run.frames.back().file;
  }
  find_state(run, summary, report);
  report.remedy = remedy(report, summary);
  return report;
}

std::string to_text(const RunReport& r)
{
  std::string text = fmt::format("{}: run {}\n  {:<16} {}\n  {:<16} {}\n  {:<16} {}\n",
    r.folder.string(), r.name, "state", r.state, "why", r.reason, "progress", progress_text(r));
  if (!r.remedy.empty())
  {
    text += fmt::format("  {:<16} {}\n", "go on with", r.remedy);
  }
  text += r.frames == 0 ? fmt::format("  {:<16} none\n", "frames")
                        : fmt::format("  {:<16} {}, the last at t = {:.6g}: {}\n", "frames",
                            r.frames, r.last_frame_time, r.last_frame.string());
  return text + last_row_text(r);
}

nlohmann::ordered_json to_json(const RunReport& r)
{
  const auto object_of = [](const RunReport::LastRow& row)
  {
    Json object = Json::object();
    for (const auto& [column, value] : row)
    {
      object[column] = json_number(value);
    }
    return object;
  };
  Json last = object_of(r.last);
  if (!r.others.empty()) // a list of all vesicles
  {
    last = Json::array({ last });
    for (const RunReport::LastRow& row : r.others)
    {
      last.push_back(object_of(row));
    }
  }
  return { { "folder", r.folder.string() }, { "name", r.name }, { "state", r.state },
    { "reason", r.reason }, { "go_on_with", r.remedy }, { "time", r.time },
    { "end", json_number(r.end) }, { "frames", r.frames },
    { "last_frame",
      r.frames == 0 ? Json(nullptr)
                    : Json{ { "time", r.last_frame_time }, { "file", r.last_frame.string() } } },
    { "last", last } };
}

}
