#include "solver/scene/SceneKey.h"

#include <algorithm>

namespace vesicle
{
namespace
{

bool contains(const std::vector<std::string>& names, const std::string& name)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Names of some keys, each once.
template<class Chosen>
std::vector<std::string> names_of(const std::vector<SceneKey>& keys, const Chosen& chosen)
{
  std::vector<std::string> names;
  for (const SceneKey& key : keys)
    if (chosen(key) && !contains(names, key.name))
      names.push_back(key.name);
  return names;
}

}

bool SceneKey::goes_with(const std::string& variant) const
{
  return variants.empty() || contains(variants, variant);
}

bool SceneKey::is_needed_by(const std::string& variant) const
{
  return missing && (needed_by.empty() || contains(needed_by, variant));
}

SceneKey SceneKey::with(std::vector<std::string> some_variants) const
{
  SceneKey key = *this;
  key.variants = std::move(some_variants);
  return key;
}

SceneKey SceneKey::required(std::string wanted, std::vector<std::string> by) const
{
  SceneKey key = *this;
  if (wanted.empty())
    wanted = allowed;
  key.missing = std::move(wanted);
  key.needed_by = std::move(by);
  return key;
}

SceneKey SceneKey::followed_by(std::function<void(const SceneDocument&, Scene&)> action) const
{
  SceneKey key = *this;
  key.then = std::move(action);
  return key;
}

SceneKey SceneKey::otherwise(std::string words) const
{
  SceneKey key = *this;
  key.left_out = std::move(words);
  return key;
}

SceneKey SceneKey::written_if(std::function<bool(const Scene&)> condition) const
{
  SceneKey key = *this;
  key.shown = std::move(condition);
  return key;
}

std::vector<std::string> SceneTable::names(const std::string& variant) const
{
  return names_of(keys, [&](const SceneKey& key) { return key.goes_with(variant); });
}

std::vector<std::string> SceneTable::names() const
{
  return names_of(keys, [](const SceneKey&) { return true; });
}

}
