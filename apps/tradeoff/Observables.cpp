#include "apps/tradeoff/Observables.h"

#include "solver/Errors.h"
#include "solver/dynamics/Diagnostics.h"
#include "solver/flow/FlowKind.h"
#include "solver/scene/NearestName.h"
#include "solver/state/Table.h"

#include <fmt/format.h>

#include <algorithm>

namespace vesicle::tradeoff
{
namespace
{

void require_column(const std::string& name, const char* option)
{
  const auto& names = Diagnostics::names();
  if (std::ranges::find(names, name) != names.end())
    return;
  const std::string nearest = nearest_name(name, names);
  throw InputError(fmt::format("{} {}: a run's table has no such column{}", option, name,
    nearest.empty() ? "" : fmt::format(", did you mean '{}'?", nearest)));
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

std::vector<std::string> chosen_observables(
  const std::vector<std::string>& named, const Scene& scene)
{
  for (const std::string& name : named)
    require_column(name, "--observables");
  return named.empty() ? observables_of(scene) : named;
}

std::map<std::string, KnownValue> exact_values(const std::vector<std::string>& texts)
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
    require_column(text.substr(0, equals), "--exact");
    values[text.substr(0, equals)] = { *value, 0 };
  }
  return values;
}

}
