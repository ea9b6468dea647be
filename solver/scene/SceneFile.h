#pragma once
// Reading a Scene from TOML.

#include "solver/scene/Scene.h"

#include <filesystem>
#include <string>
#include <vector>

namespace vesicle
{

/// Reads and checks a scene. `overrides` are "table.key=value" with a TOML value; what isn't TOML
/// is taken as a string, so that words need no quotes. Relative paths (vesicle.file,
/// output.directory) are taken from the scene's folder and stored absolute; directions are stored
/// with length 1. Throws InputError "file:line: key 'table.key': what is wrong; allowed: …" ("--set
/// table.key=value: key …" where an override is at fault); an unknown key names the nearest known
/// one.
Scene read_scene(const std::filesystem::path& file, const std::vector<std::string>& overrides = {});

/// The same from text; `name` stands for the file in messages, relative paths are taken from
/// `folder`. Unlike read_scene it doesn't ask whether the mesh file exists: a run that goes on
/// doesn't need it.
Scene parse_scene(const std::string& text, const std::string& name,
  const std::filesystem::path& folder = ".", const std::vector<std::string>& overrides = {});

/// The scene as TOML with every setting spelled out: reading it gives the same scene back, every
/// number bit for bit (`file` and, for start shapes, `edge_length` aren't part of the format).
std::string write_scene(const Scene& scene);

/// The same without what the preset stands for, so that another preset can be put in its place.
std::string write_editable_scene(const Scene& scene);

/// The same of a scene as read_scene() reads it, with a comment at each key: its unit, and whether
/// it was left out ("by default").
std::string annotated_scene(
  const std::filesystem::path& file, const std::vector<std::string>& overrides = {});

}
