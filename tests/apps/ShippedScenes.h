#pragma once
// The scenes of data/scenes, those to come included.

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>
#include <vector>

namespace vesicle::test
{

inline std::vector<std::filesystem::path> shipped_scenes()
{
  std::vector<std::filesystem::path> scenes;
  for (const auto& entry : std::filesystem::directory_iterator(VESICLE_SOURCE_DIR "/data/scenes"))
  {
    if (entry.path().extension() == ".toml")
    {
      scenes.push_back(entry.path());
    }
  }
  std::sort(scenes.begin(), scenes.end());
  return scenes;
}

/// As the name of a test: letters and digits.
inline std::string test_name(const std::filesystem::path& scene)
{
  std::string name = scene.stem().string();
  std::replace_if(
    name.begin(), name.end(), [](unsigned char c) { return !std::isalnum(c); }, '_');
  return name;
}

}
