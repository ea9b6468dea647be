#pragma once
// What is to be said of a key of a scene, and of a table of them.

#include "solver/scene/Scene.h"
#include "solver/scene/TableReader.h"

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vesicle
{

/// One key. Where a table has variants (a shape's, a flow's kinds), a key may go with some of them
/// only; a name may then have several keys.
struct SceneKey
{
  std::string name;
  std::string allowed; ///< what values it may have, in words
  std::string unit;    ///< what it measures; empty: a number without a unit, or no number
  std::string help;
  std::string left_out; ///< what holds without it, in words; empty: its default value tells

  /// Into the scene, from a table that has the key. Throws InputError.
  std::function<void(const TableReader&, Scene&)> read;
  /// The scene's value as TOML; empty: the key is left out.
  std::function<std::string(const Scene&)> write;
  /// Whether the key may have this number, for keys that have one.
  std::function<bool(double)> allows;
  /// Done next after reading, whether the key is given or not: what follows from its value.
  std::function<void(const SceneDocument&, Scene&)> then;

  std::vector<std::string> variants;       ///< those that it goes with; empty: all
  std::vector<std::string> needed_by;      ///< those that can't do without; with `missing`
  std::optional<std::string> missing;      ///< of a key that must be given: what is wanted
  std::function<bool(const Scene&)> shown; ///< whether it is written; empty: always

  bool goes_with(const std::string& variant) const;
  bool is_needed_by(const std::string& variant) const;

  /// The same key with more to be said of it.
  SceneKey with(std::vector<std::string> some_variants) const;
  /// Must be given, in all variants that it goes with or in some. `wanted` is for the message;
  /// empty: what is allowed.
  SceneKey required(std::string wanted = "", std::vector<std::string> by = {}) const;
  SceneKey followed_by(std::function<void(const SceneDocument&, Scene&)> action) const;
  /// What holds where it is left out, in words, for keys without a default value.
  SceneKey otherwise(std::string words) const;
  SceneKey written_if(std::function<bool(const Scene&)> condition) const;
};

struct SceneTable
{
  struct Variant
  {
    std::string name;
    std::string because; ///< for messages: `shape = "sphere"`
  };

  std::string name; ///< empty: the keys at the top
  std::string help;
  std::vector<SceneKey> keys; ///< in the order in which messages list them and they are written

  /// Whether a scene has the table; empty: always. What to do where the file has it is `create`.
  std::function<bool(const Scene&)> present;
  std::function<void(Scene&)> create;
  /// Its variants, for documentation, and which of them a file or a scene has.
  std::vector<std::pair<std::string, std::string>> variants; ///< name, help
  std::function<Variant(const SceneTable&, const TableReader&)> variant_in;
  std::function<std::string(const Scene&)> variant_of;
  /// A scene that has the table in a variant, all else by default, for documentation.
  std::function<void(Scene&, const std::string&)> make_example;
  /// What no key can tell alone. Throws InputError.
  std::function<void(const TableReader&, const Scene&)> check;

  /// Names of the keys that go with a variant, and of all.
  std::vector<std::string> names(const std::string& variant) const;
  std::vector<std::string> names() const;
};

/// The way to a key's value in a scene: at(&Scene::fluid, &Scene::Fluid::viscosity).
template<class... Members>
auto at(Members... members)
{
  return [=](auto& scene) -> auto&
  {
    return (scene.*....*members);
  };
}

/// A key whose value is where `place` finds it and follows `rule` (SceneRules.h).
template<class Place, class Rule>
SceneKey key(const std::string& name, Place place, const Rule& rule, const std::string& unit,
  const std::string& help)
{
  SceneKey key;
  key.name = name;
  key.allowed = rule.allowed();
  key.unit = unit;
  key.help = help;
  key.read = [=](const TableReader& table, Scene& scene) { rule.read(table, name, place(scene)); };
  key.write = [=](const Scene& scene) { return rule.write(place(scene)); };
  if constexpr (requires { rule.allows(1.); })
    key.allows = [=](double value) { return rule.allows(value); };
  return key;
}

}
