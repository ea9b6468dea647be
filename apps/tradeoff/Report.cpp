#include "apps/tradeoff/Report.h"

#include "apps/JsonText.h"
#include "apps/tradeoff/ParetoFront.h"

#include "render/Chart.h"
#include "solver/Errors.h"
#include "solver/files/FileBytes.h"
#include "solver/scene/SceneNames.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace vesicle::tradeoff
{
namespace
{

using Json = nlohmann::ordered_json;

std::string cell(const std::optional<double>& value)
{
  return value ? fmt::format("{}", *value) : "";
}

/// |value − known|, relative to the observable's scale.
std::optional<double> true_error(const Report& report, const Trial& trial, const Reference& r)
{
  const auto known = report.known.find(r.observable);
  const auto value = trial.value(r.observable);
  if (known == report.known.end() || !value || !trial.finished())
    return std::nullopt;
  return std::abs(*value - known->second.value) / r.best.scale;
}

/// In quotes where a comma or a line's end would break the row.
std::string csv_text(std::string text)
{
  std::ranges::replace(text, '"', '\'');
  std::ranges::replace(text, '\n', ' ');
  return text.empty() ? text : '"' + text + '"';
}

std::string header(const Report& report)
{
  std::string line =
    "settings,preset,triangles,time_key,time_value,knob,outcome,cpu_seconds,steps,"
    "rejected,error,dependable_error,space_estimate,time_estimate,on_front,recommended";
  for (const Reference& r : report.references)
  {
    line += fmt::format(",{0},{0}_error,{0}_uncertainty", r.observable);
    if (report.known.contains(r.observable))
      line += fmt::format(",{}_true_error", r.observable);
  }
  return line + ",message\n";
}

std::vector<Choice> choices_of(const std::vector<Trial>& trials, const std::vector<Reference>& of)
{
  std::vector<Choice> choices;
  for (const Trial& t : trials)
    choices.push_back({ t.cpu_seconds, promised_error(t, of) });
  return choices;
}

std::optional<double> finite(double x)
{
  return std::isfinite(x) ? std::optional(x) : std::nullopt;
}

std::string row(const Report& report, std::size_t i, bool on_front)
{
  const Trial& t = report.trials[i];
  const Settings& s = t.settings;
  const bool ran = t.outcome == Trial::Outcome::finished || t.outcome == Trial::Outcome::failed;
  const auto if_ran = [&](double x) { return ran ? cell(x) : ""; };
  std::string line = fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}", s.label(),
    s.preset_name(), s.triangles, s.time.key(), s.time.value, s.knob, outcome_name(t.outcome),
    if_ran(t.cpu_seconds), if_ran(t.steps), if_ran(t.rejected),
    cell(finite(promised_error(t, report.references))),
    cell(finite(dependable_error(t, report.trials, report.references))), cell(t.space_estimate),
    cell(t.time_estimate), on_front ? 1 : 0,
    report.recommendation && report.recommendation->trial == i ? 1 : 0);
  for (const Reference& r : report.references)
  {
    const auto e = estimate(t, r.observable, r.best);
    line += "," + cell(t.value(r.observable)) + "," + (e ? cell(e->error) : "") + "," +
      (e ? cell(e->uncertainty) : "");
    if (report.known.contains(r.observable))
      line += "," + cell(true_error(report, t, r));
  }
  return line + "," + csv_text(t.message) + "\n";
}

const Trial& recommended(const Report& report)
{
  return report.trials[report.recommendation->trial];
}

std::string settings_toml(const Report& report)
{
  const Trial& t = recommended(report);
  return t.settings.toml(t.scene.vesicles());
}

/// How much of a promise is known: a promise of little else than uncertainty may be far too large.
std::string sureness(const Estimate& e)
{
  const double share = e.uncertainty / e.promised();
  return share < 1. / 3 ? "sure" : share < 0.75 ? "fairly sure" : "an upper bound";
}

std::string promise_line(const Report& report, const Reference& r)
{
  const Trial& t = recommended(report);
  const Estimate e = *estimate(t, r.observable, r.best);
  std::string line =
    fmt::format("{} = {:.8g}, promised within {:.1e} of {:.6g} ({}: {:.8g} ± {:.1g})", r.observable,
      *t.value(r.observable), e.promised(), r.best.scale, sureness(e), r.best.value,
      r.best.uncertainty);
  if (const auto known = true_error(report, t, r))
    line +=
      fmt::format("; exact {:.8g}, off by {:.1e}", report.known.at(r.observable).value, *known);
  return line;
}

std::string verdict(const Report& report)
{
  const Trial& t = recommended(report);
  const double error = dependable_error(t, report.trials, report.references);
  return report.recommendation->keeps_tolerance
    ? fmt::format("The cheapest that keeps {:g}: {}, {:.3g} s of CPU", report.tolerance,
        t.settings.label(), t.cpu_seconds)
    : fmt::format("Nothing tried keeps {:g}. The most accurate, to {:.1e}: {}, {:.3g} s of CPU",
        report.tolerance, error, t.settings.label(), t.cpu_seconds);
}

ChartLine points_of(
  const Report& report, const NamedChoice<Scene::Preset>& preset, const std::vector<Reference>& of)
{
  ChartLine line{ std::string(preset.name), {}, {}, ChartLine::Style::points };
  for (const Trial& t : report.trials)
    if (t.settings.preset == preset.choice && t.finished())
    {
      line.x.push_back(t.cpu_seconds);
      line.y.push_back(promised_error(t, of));
    }
  return line;
}

ChartLine front_of(const Report& report, const std::vector<Reference>& of)
{
  ChartLine line{ "best for its time", {}, {}, ChartLine::Style::line, { { 120, 120, 120 } } };
  const auto choices = choices_of(report.trials, of);
  for (const std::size_t i : pareto_front(choices))
  {
    line.x.push_back(choices[i].cost);
    line.y.push_back(choices[i].error);
  }
  return line;
}

ChartLine level(const std::string& label, double y, const std::vector<Trial>& trials)
{
  double from = HUGE_VAL, to = 0;
  for (const Trial& t : trials)
    if (t.finished())
    {
      from = std::min(from, t.cpu_seconds);
      to = std::max(to, t.cpu_seconds);
    }
  return { label, { from, to }, { y, y }, ChartLine::Style::dashed, { { 60, 60, 60 } } };
}

ChartSpec panel(const Report& report, const Reference& r)
{
  const std::vector<Reference> of{ r };
  ChartSpec chart{ r.observable, "CPU time (s)", "error", {}, true, true };
  chart.lines.push_back(front_of(report, of));
  for (const auto& preset : preset_names)
    chart.lines.push_back(points_of(report, preset, of));
  chart.lines.push_back(level("tolerance", report.tolerance, report.trials));
  if (report.recommendation)
  {
    const Trial& t = recommended(report);
    chart.lines.push_back({ "recommended", { t.cpu_seconds }, { promised_error(t, of) },
      ChartLine::Style::cross, { { 0, 0, 0 } } });
  }
  return chart;
}

Json settings_json(const Settings& s)
{
  Json json{ { "preset", s.preset_name() }, { "triangles", s.triangles },
    { fmt::format("time_{}", s.time.key()), s.time.value } };
  if (!s.knob.empty())
  {
    const auto [key, value] = s.knob_halves();
    json[key] = value;
  }
  return json;
}

}

void conclude(Report& report)
{
  report.references.clear();
  for (const std::string& observable : report.observables)
  {
    const auto best = best_value(report.trials, observable);
    if (!best)
      throw NumericalError(fmt::format(
        "{}: no preset has two numbers of triangles whose runs finished with a value of it: "
        "nothing "
        "tells their errors. Give a larger --budget, an earlier --end, or other --observables",
        observable));
    report.references.push_back({ observable, *best });
  }
  report.recommendation = recommend(report.trials, report.references, report.tolerance);
  report.foresight = foresight(report.trials, report.references);
}

void write_table(const Report& report, const std::filesystem::path& file)
{
  const auto front = pareto_front(choices_of(report.trials, report.references));
  std::string text = header(report);
  for (std::size_t i = 0; i < report.trials.size(); ++i)
    text += row(report, i, std::ranges::find(front, i) != front.end());
  replace_file(file, text);
}

void write_recommended(const Report& report, const std::filesystem::path& file)
{
  std::string text = fmt::format("# {}\n# {}.\n", report.scene, verdict(report));
  for (const Reference& r : report.references)
    text += "# " + promise_line(report, r) + "\n";
  replace_file(file, text + settings_toml(report));
}

void write_json(const Report& report, const std::filesystem::path& file)
{
  const Trial& t = recommended(report);
  Json observables = Json::object();
  for (const Reference& r : report.references)
  {
    const Estimate e = *estimate(t, r.observable, r.best);
    Json& json = observables[r.observable];
    json = { { "value", *t.value(r.observable) }, { "promised_error", e.promised() },
      { "error", e.error }, { "uncertainty", e.uncertainty }, { "scale", r.best.scale },
      { "best_value", r.best.value }, { "best_from", r.best.from },
      { "order_in_triangles", r.best.order_in_triangles } };
    if (const auto known = true_error(report, t, r))
      json["true_error"] = *known;
  }
  const Foresight& f = report.foresight;
  const Json json{ { "scene", report.scene }, { "tolerance", report.tolerance },
    { "recommended",
      { { "settings", settings_json(t.settings) }, { "observables", observables },
        { "cpu_seconds", t.cpu_seconds },
        { "keeps_tolerance", report.recommendation->keeps_tolerance } } },
    { "own_estimates",
      { { "runs", f.runs }, { "error_over_estimate", { f.lowest, f.median, f.highest } },
        { "pairs_in_order", f.ordered } } } };
  replace_file(file, json_text(json, 2) + "\n");
}

void draw(const Report& report, const std::filesystem::path& file)
{
  std::vector<ChartSpec> charts;
  for (const Reference& r : report.references)
    charts.push_back(panel(report, r));
  const int columns = charts.size() > 1 ? 2 : 1,
            rows = (static_cast<int>(charts.size()) + columns - 1) / columns;
  constexpr int width = 800, height = 500;
  write_charts(file, charts, columns, { width * columns, height * rows });
}

std::string to_text(const Report& report)
{
  std::string text = verdict(report) + "\n";
  for (const Reference& r : report.references)
    text += "  " + promise_line(report, r) + "\n    by " + r.best.from + "\n";
  text += "\n" + settings_toml(report);
  if (const Foresight& f = report.foresight; f.runs > 1)
    text +=
      fmt::format("\nThe runs' own estimates: error/estimate {:.2g} (from {:.2g} to {:.2g}, {} "
                  "runs); of two runs the one of the larger estimate errs more in {:.0f}%.\n",
        f.median, f.lowest, f.highest, f.runs, 100 * f.ordered);
  return text;
}

}
