#include "apps/tradeoff/Observables.h"

#include "apps/RunTable.h"

#include "solver/Errors.h"
#include "solver/flow/FlowKind.h"
#include "solver/scene/NearestName.h"
#include "solver/state/Table.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace vesicle::tradeoff
{
namespace
{

bool is_gap(const std::string& column)
{
  return column == "gap" || column == "wall_gap";
}

void require_vesicle(const std::string& observable, const Scene& scene, const char* option)
{
  const std::size_t count = scene.vesicles();
  if (count == 1)
    throw InputError(
      fmt::format("{} {}: the scene has one vesicle; leave out the brackets", option, observable));
  for (std::size_t v = 0; v < count; ++v)
    if (observable == of_vesicle(column_of(observable), v))
      return;
  throw InputError(
    fmt::format("{} {}: the scene has vesicles 0 to {}", option, observable, count - 1));
}

void require_observable(const std::string& observable, const Scene& scene, const char* option)
{
  std::vector<std::string> columns = run_columns(rows_of(scene));
  std::erase(columns, "vesicle");
  const std::string column = column_of(observable);
  if (std::ranges::find(columns, column) == columns.end())
  {
    const std::string nearest = nearest_name(column, columns);
    throw InputError(fmt::format("{} {}: a run's table has no such column{}", option, column,
      nearest.empty() ? "" : fmt::format(", did you mean '{}'?", nearest)));
  }
  if (observable != column)
    require_vesicle(observable, scene, option);
}

std::vector<std::string> observables_of(const Scene& scene)
{
  std::vector<std::string> names;
  const bool bends = scene.membrane.bending_rigidity.has_value();
  if (scene.gravity)
    names.push_back("velocity_z");
  if (scene.flow && scene.flow->kind().name == "shear")
    names.insert(names.end(), { "inclination_deg", "tank_treading_frequency" });
  else if (scene.flow)
    names.push_back("taylor_deformation");
  if (bends)
    names.push_back("energy_over_8pi");
  if (names.empty() || (bends && !scene.gravity && !scene.flow))
    names.push_back("semi_axis_1");
  return names;
}

}

std::string of_vesicle(const std::string& column, std::size_t vesicle)
{
  return fmt::format("{}[{}]", column, vesicle);
}

std::string column_of(const std::string& observable)
{
  return observable.substr(0, observable.find('['));
}

std::optional<double> of_all(
  const std::string& column, const std::vector<double>& values, std::size_t vesicles)
{
  if (values.empty())
    return std::nullopt;
  if (is_gap(column))
    return *std::ranges::min_element(values);
  if (values.size() < vesicles)
    return std::nullopt;
  return std::reduce(values.begin(), values.end()) / static_cast<double>(vesicles);
}

std::vector<std::string> chosen_observables(
  const std::vector<std::string>& named, const Scene& scene)
{
  for (const std::string& name : named)
    require_observable(name, scene, "--observables");
  return named.empty() ? observables_of(scene) : named;
}

std::map<std::string, KnownValue> exact_values(
  const std::vector<std::string>& texts, const Scene& scene)
{
  std::map<std::string, KnownValue> values;
  for (const std::string& text : texts)
  {
    const std::size_t equals = text.find('=');
    const auto value =
      equals == std::string::npos ? std::nullopt : number_in(text.substr(equals + 1));
    if (!value)
      throw InputError(
        fmt::format("--exact {}: wants an observable and its value, as velocity_z=2.2987", text));
    require_observable(text.substr(0, equals), scene, "--exact");
    values[text.substr(0, equals)] = { *value, 0 };
  }
  return values;
}

}
