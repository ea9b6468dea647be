#include "apps/Summary.h"

#include "apps/BuildFacts.h"
#include "apps/JsonText.h"

#include "solver/files/FileBytes.h"
#include "solver/scene/SceneFile.h"
#include "solver/scene/SceneNames.h"
#include "solver/state/RunRows.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <oneapi/tbb/global_control.h>

#include <cmath>

namespace vesicle
{
namespace
{

using Json = nlohmann::ordered_json;

Json versions()
{
  Json result = Json::object();
  for (const auto& [name, value] : build_facts())
  {
    result[name] = value;
  }
  return result;
}

Json number_or_null(const std::optional<double>& value)
{
  return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

/// By the names of the table's columns; null where undefined.
Json observables(const Diagnostics& diagnostics)
{
  Json result = Json::object();
  const auto& names = Diagnostics::names();
  const auto values = diagnostics.values();
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    result[std::string(names[i])] = number_or_null(values[i]);
  }
  if (diagnostics.wall_gap)
  {
    result["wall_gap"] = number_or_null(diagnostics.wall_gap);
    result["lift_speed"] = number_or_null(diagnostics.lift_speed);
  }
  return result;
}

/// Of one vesicle its observables, of several a list of them.
Json final_of(const std::vector<Diagnostics>& last)
{
  if (last.size() == 1)
    return observables(last.front());
  Json all = Json::array();
  for (const Diagnostics& vesicle : last)
  {
    all.push_back(observables(vesicle));
    all.back()["gap"] = number_or_null(vesicle.gap);
  }
  return all;
}

Json numbers(const DimensionlessNumbers& n)
{
  return { { "r0", n.radius }, { "time_unit", n.time_unit }, { "bond", number_or_null(n.bond) },
    { "capillary", number_or_null(n.capillary) } };
}

Json error_estimates(const ErrorEstimate& e)
{
  return { { "space", number_or_null(e.space()) }, { "time", number_or_null(e.time) },
    { "energy_by_6_and_12_points", number_or_null(e.energy) },
    { "energy_by_3_and_12_points", number_or_null(e.energy_coarse) },
    { "layer_by_two_rules", number_or_null(e.layer) } };
}

Json timings(const RunSummary& s)
{
  const auto threads =
    oneapi::tbb::global_control::active_value(oneapi::tbb::global_control::max_allowed_parallelism);
  return { { "wall_seconds", s.wall_seconds }, { "cpu_seconds", s.cpu_seconds },
    { "steps", s.steps },
    { "seconds_per_step", s.steps > 0 ? s.wall_seconds / static_cast<double>(s.steps) : 0 },
    { "threads", threads }, { "resumed", s.resumed } };
}

}

void write_summary(const RunSummary& s, const std::filesystem::path& file)
{
  Json summary{ { "name", s.scene.name }, { "outcome", s.outcome } };
  if (!s.message.empty())
  {
    summary["message"] = s.message;
  }
  if (s.scene.units == Units::si)
    summary["units"] = name_of(units_names, s.scene.units);
  summary["steps"] = s.last.empty() ? 0 : static_cast<std::int64_t>(s.last.front().step);
  summary["time"] = s.last.empty() ? 0 : s.last.front().time;
  summary["frames"] = s.frames;
  summary["triangles"] = s.triangles;
  if (s.scene.vesicles() > 1)
    summary["vesicles"] = s.scene.vesicles();
  if (!s.last.empty())
  {
    summary["drifts"] = { { "area", largest(s.last, &Diagnostics::area_drift) },
      { "volume", largest(s.last, &Diagnostics::volume_drift) } };
    summary["corrections"] = { { "area", largest(s.last, &Diagnostics::area_correction) },
      { "volume", largest(s.last, &Diagnostics::volume_correction) } };
    if (s.errors)
      summary["error_estimates"] = error_estimates(*s.errors);
    summary["numbers"] = numbers(s.numbers);
    summary["final"] = final_of(s.last);
  }
  summary["timings"] = timings(s);
  if (!s.movie_note.empty())
  {
    summary["movie"] = s.movie_note;
  }
  summary["versions"] = versions();
  summary["scene_file"] = s.scene.file.string();
  summary["settings"] = write_scene(s.scene);
  replace_file(file, json_text(summary, 2) + "\n");
}

}
