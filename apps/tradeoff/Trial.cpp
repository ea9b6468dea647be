#include "apps/tradeoff/Trial.h"

#include "apps/RunFolder.h"
#include "apps/RunTable.h"
#include "apps/tradeoff/Observables.h"

#include "solver/Errors.h"
#include "solver/files/FileBytes.h"
#include "solver/scene/SceneFile.h"
#include "solver/simulation/Cost.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace vesicle::tradeoff
{
namespace
{

using Json = nlohmann::ordered_json;

/// Of the pears of 80 to 1,280 triangles: program and start mesh, and what a step takes beside the
/// pairs of triangles, which Cost.h counts.
constexpr double loop_start_seconds = 0.8, flat_start_seconds = 0.15;
constexpr double loop_seconds_a_triangle = 1.5e-4, flat_seconds_a_triangle = 5.5e-5;

/// The summary of a run of this scene, or null.
Json summary_of(const RunFolder& files, const Scene& scene)
{
  if (!is_file(files.summary()))
    return nullptr;
  const Json summary = Json::parse(read_file(files.summary()), nullptr, false);
  const bool same = summary.is_object() && summary.value("settings", "") == write_scene(scene);
  return same ? summary : Json(nullptr);
}

std::optional<double> number_at(const Json& json, const char* table, const char* key)
{
  if (!json.contains(table) || !json[table].contains(key) || !json[table][key].is_number())
    return std::nullopt;
  return json[table][key].get<double>();
}

/// `vesicle`: what the names of observables have behind that of their column.
void read_scales(const RunTable& table, const std::string& vesicle, Trial& trial)
{
  for (std::size_t i = 0; i < table.columns.size(); ++i)
  {
    double& scale = trial.scales[table.columns[i] + vesicle];
    for (const Row& row : table.rows)
      scale = std::max(scale, std::abs(row[i].value_or(0)));
  }
}

void read_scales(const RunTable& table, Trial& trial)
{
  read_scales(table, "", trial);
  if (trial.scene.vesicles() == 1)
    return;
  const auto vesicles = table.by_vesicle();
  for (std::size_t v = 0; v < vesicles.size(); ++v)
    read_scales(vesicles[v], of_vesicle("", v), trial);
}

/// Of all vesicles and, where there are several, of each.
void read_values(const Json& rows, Trial& trial)
{
  std::map<std::string, std::vector<double>> columns;
  for (std::size_t v = 0; v < rows.size(); ++v)
    for (const auto& [column, value] : rows[v].items())
      if (value.is_number())
      {
        columns[column].push_back(value.get<double>());
        if (rows.size() > 1)
          trial.values[of_vesicle(column, v)] = columns[column].back();
      }
  for (const auto& [column, values] : columns)
    if (const auto value = of_all(column, values, rows.size()))
      trial.values[column] = *value;
}

}

const char* outcome_name(Trial::Outcome outcome)
{
  switch (outcome)
  {
    case Trial::Outcome::finished:
      return "finished";
    case Trial::Outcome::failed:
      return "failed";
    case Trial::Outcome::refused:
      return "refused";
    case Trial::Outcome::left_out:
      return "left out";
    case Trial::Outcome::waiting:
      break;
  }
  return "not run";
}

std::filesystem::path TrialFolder::scene_file(const Settings& settings) const
{
  return folder_ / (settings.label() + ".toml");
}

std::filesystem::path TrialFolder::run_folder(const Settings& settings) const
{
  return folder_ / settings.label();
}

bool read_trial(const TrialFolder& folder, Trial& trial)
{
  const RunFolder files(folder.run_folder(trial.settings), trial.scene.name);
  const Json summary = summary_of(files, trial.scene);
  if (!summary.is_object())
    return false;
  const std::string outcome = summary.value("outcome", "");
  trial.message = summary.value("message", "");
  trial.cpu_seconds = number_at(summary, "timings", "cpu_seconds").value_or(0);
  trial.steps = summary.value("steps", 0.);
  trial.end = summary.value("time", 0.);
  if (outcome != "finished" && outcome != "failed")
    return false;
  trial.outcome = outcome == "finished" ? Trial::Outcome::finished : Trial::Outcome::failed;
  trial.space_estimate = number_at(summary, "error_estimates", "space");
  trial.time_estimate = number_at(summary, "error_estimates", "time");
  if (!trial.finished())
    return true;
  const Json& last = summary["final"];
  read_values(last.is_array() ? last : Json::array({ last }), trial);
  trial.rejected = trial.value("rejected").value_or(0);
  read_scales(read_run_table(files.table()), trial);
  return true;
}

double expected_seconds(const Scene& scene, double triangles, double steps)
{
  Scene timed = scene;
  timed.time.output_every = 0;
  timed.time.end = 1;
  timed.time.step = 1 / steps;
  const bool flat = scene.accuracy.basis == Scene::Basis::linear;
  return (flat ? flat_start_seconds : loop_start_seconds) +
    (flat ? flat_seconds_a_triangle : loop_seconds_a_triangle) * triangles * steps +
    cost_of(timed, triangles).seconds;
}

}
