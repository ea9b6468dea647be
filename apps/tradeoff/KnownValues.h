#pragma once
// Scenes whose exact answers are known.

#include "solver/scene/Scene.h"

#include <map>
#include <string>

namespace vesicle::tradeoff
{

struct KnownValue
{
  double value, uncertainty;
};

/// By the names of the diagnostics' columns, for the last row; empty for scenes of which nothing is known.
/// A scene is known by its physics: that of a shipped scene, whatever its triangles, accuracy, output and
/// pictures, at an end at which that is steady. Where the values come from: docs/validation.md.
std::map<std::string, KnownValue> known_values(const Scene& scene);

}
