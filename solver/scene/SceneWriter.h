#pragma once
// A scene's settings as TOML, with a remark at each.

#include "solver/scene/SceneKey.h"

#include <functional>
#include <string>

namespace vesicle
{

/// What is to be said of a key, in a comment behind it; empty: nothing.
using KeyRemark = std::function<std::string(const SceneTable&, const SceneKey&)>;

/// write_scene() with remarks.
std::string write_scene(const Scene& scene, const KeyRemark& remark);

}
