#pragma once
// Reading a Scene from TOML.

#include "solver/scene/Scene.h"

#include <filesystem>
#include <string>
#include <vector>

namespace vesicle
{

/// Reads and checks a scene. `overrides` are "table.key=value" with a TOML value (bare words are
/// taken as strings). Throws InputError "file:line: key: what is wrong; what is allowed"; an unknown
/// key names the nearest known one.
Scene read_scene(const std::filesystem::path& file, const std::vector<std::string>& overrides = {});

/// The same from text; `name` stands for the file in messages, relative paths are taken from `folder`.
Scene parse_scene(const std::string& text, const std::string& name,
  const std::filesystem::path& folder = ".", const std::vector<std::string>& overrides = {});

/// The scene as TOML with every setting spelled out: reading it gives the same scene back.
std::string write_scene(const Scene& scene);

}
