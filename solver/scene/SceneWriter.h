#pragma once
// A scene's settings as TOML, with a remark at each.

#include "solver/scene/SceneKey.h"

#include <functional>
#include <optional>
#include <string>

namespace vesicle
{

/// What is to be said of a key of a vesicle (0 where it is the scene's), in a comment behind it;
/// empty: nothing. Without a value the key is left out.
using KeyRemark = std::function<std::optional<std::string>(
  const SceneTable&, const SceneKey&, std::size_t vesicle)>;

/// write_scene() with remarks.
std::string write_scene(const Scene& scene, const KeyRemark& remark);

}
