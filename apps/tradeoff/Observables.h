#pragma once
// What a trade-off looks at: columns of a run's table at its end. Where there are several vesicles,
// `velocity_z[2]` is the one of that number, and `velocity_z` the mean of all; `gap` and `wall_gap` are
// the least.

#include "apps/tradeoff/KnownValues.h"

#include "solver/scene/Scene.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace vesicle::tradeoff
{

std::string of_vesicle(const std::string& column, std::size_t vesicle);
/// The column without the vesicle.
std::string column_of(const std::string& observable);
/// Of a column's values of all vesicles; none where it isn't defined: some have it not, or, of a gap, all.
std::optional<double> of_all(
  const std::string& column, const std::vector<double>& values, std::size_t vesicles);

/// Those named, or, where none is, those that the scene is about: its energy where it bends, its speed
/// under gravity, in flows inclination and frequency or deformation, its long axis where nothing drives it.
/// Throws InputError for a name that is no column of the scene's table, with the nearest one.
std::vector<std::string> chosen_observables(
  const std::vector<std::string>& named, const Scene& scene);

/// Of "name=value" each. Throws InputError for what isn't, or for a name that is no column.
std::map<std::string, KnownValue> exact_values(
  const std::vector<std::string>& texts, const Scene& scene);

}
