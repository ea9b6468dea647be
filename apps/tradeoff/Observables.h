#pragma once
// What a trade-off looks at.

#include "apps/tradeoff/KnownValues.h"

#include "solver/scene/Scene.h"

#include <map>
#include <string>
#include <vector>

namespace vesicle::tradeoff
{

/// Those named, or, where none is, those that the scene is about: its energy where it bends, its speed
/// under gravity, in flows inclination and frequency or deformation, its long axis where nothing drives it.
/// Throws InputError for a name that is no column of the diagnostics, with the nearest one.
std::vector<std::string> chosen_observables(
  const std::vector<std::string>& named, const Scene& scene);

/// Of "name=value" each. Throws InputError for what isn't, or for a name that is no column.
std::map<std::string, KnownValue> exact_values(const std::vector<std::string>& texts);

}
