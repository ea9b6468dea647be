// What the schema promises to those that follow from it.

#include "solver/Errors.h"
#include "solver/scene/SceneFile.h"
#include "solver/scene/SceneSchema.h"

#include <gtest/gtest.h>

#include <set>

using namespace vesicle;

namespace
{

/// A scene in memory that has the table, in a variant of the key.
Scene example(const SceneTable& table, const SceneKey& key)
{
  Scene scene;
  if (table.create)
    table.create(scene);
  if (table.make_example)
    table.make_example(
      scene, key.variants.empty() ? table.variants.front().first : key.variants.front());
  return scene;
}

}

TEST(SceneSchema, EveryKeySaysWhatItIs)
{
  for (const SceneTable& table : scene_schema())
  {
    EXPECT_FALSE(table.help.empty()) << table.name;
    for (const SceneKey& key : table.keys)
    {
      SCOPED_TRACE(table.name + '.' + key.name);
      EXPECT_FALSE(key.allowed.empty());
      EXPECT_FALSE(key.help.empty());
    }
  }
}

TEST(SceneSchema, NoNameTwiceInOneVariant)
{
  for (const SceneTable& table : scene_schema())
  {
    std::vector<std::string> variants{ "" };
    for (const auto& [name, help] : table.variants)
      variants.push_back(name);
    for (const std::string& variant : variants)
    {
      std::set<std::string> names;
      for (const SceneKey& key : table.keys)
        if (key.goes_with(variant) && !names.insert(key.name).second)
          ADD_FAILURE() << table.name << '.' << key.name << ' ' << variant;
    }
  }
}

TEST(SceneSchema, VariantsOfKeysAreThoseOfTheirTable)
{
  for (const SceneTable& table : scene_schema())
  {
    std::set<std::string> known;
    for (const auto& [name, help] : table.variants)
      known.insert(name);
    for (const SceneKey& key : table.keys)
      for (const std::string& variant : key.variants)
        EXPECT_TRUE(known.contains(variant)) << table.name << '.' << key.name << ' ' << variant;
  }
}

// Reading what a key writes gives the same again.
TEST(SceneSchema, DefaultsReadBack)
{
  for (const SceneTable& table : scene_schema())
    for (const SceneKey& key : table.keys)
    {
      SCOPED_TRACE(table.name + '.' + key.name);
      const std::string value = key.write(example(table, key));
      // A scene can't ask for no output at all, nor for no modes: there is no default.
      if (value.empty() || key.missing)
        continue;
      const SceneDocument document = parse_document(
        (table.name.empty() ? "" : "[" + table.name + "]\n") + key.name + " = " + value, "s.toml",
        "/", {});
      Scene scene = example(table, key);
      key.read(TableReader(document, table.name), scene);
      EXPECT_EQ(key.write(scene), value);
    }
}

TEST(SceneSchema, NumbersTellTheirRange)
{
  EXPECT_FALSE(scene_key("fluid", "viscosity").allows(0));
  EXPECT_TRUE(scene_key("fluid", "viscosity").allows(1e-3));
  EXPECT_TRUE(scene_key("flow", "rate").allows(-1));
  EXPECT_FALSE(scene_key("flow", "radius").allows(-1));
  EXPECT_FALSE(scene_key("vesicle", "reduced_volume").allows(1.1));
  EXPECT_TRUE(scene_key("vesicle", "triangles").allows(20));
  EXPECT_FALSE(scene_key("vesicle", "triangles").allows(19));
  EXPECT_FALSE(scene_key("movie", "color").allows);
}
