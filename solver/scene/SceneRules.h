#pragma once
// The rules that values of a scene follow: how one is read, written and described. A rule has
//   read(table, key, target), write(value), allowed()
// and, for a number, allows(number).

#include "solver/scene/SceneNames.h"
#include "solver/scene/TableReader.h"
#include "solver/scene/TomlText.h"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace vesicle::rules
{

/// A number; or several of them, each by the same rule.
struct Number
{
  NumberRule rule = any_number;
  const char* form = ""; ///< of several: "[a, b, c]"

  template<class Target>
  void read(const TableReader& table, const std::string& key, Target& target) const
  {
    table.read(key, target, rule);
  }
  template<class Value>
  std::string write(const Value& value) const
  {
    return to_toml(value);
  }
  std::string allowed() const
  {
    return *form ? fmt::format("{}, each {}", form, rule.allowed) : rule.allowed;
  }
  bool allows(double number) const { return rule.holds(number); }
};

struct Integer
{
  IntegerRule rule;

  template<class Target>
  void read(const TableReader& table, const std::string& key, Target& target) const
  {
    table.read(key, target, rule);
  }
  template<class Value>
  std::string write(const Value& value) const
  {
    return to_toml(value);
  }
  std::string allowed() const { return rule.allowed; }
  bool allows(double number) const { return rule.holds(static_cast<int>(number)); }
};

/// A number, or a word that stands for an empty value.
struct NumberOr
{
  const char* word;
  NumberRule rule;

  void read(const TableReader& table, const std::string& key, std::optional<double>& target) const
  {
    table.read_unless(key, word, target, rule);
  }
  std::string write(const std::optional<double>& value) const
  {
    return value ? to_toml(*value) : to_toml(std::string(word));
  }
  std::string allowed() const { return fmt::format("{} or \"{}\"", rule.allowed, word); }
};

struct Flag
{
  void read(const TableReader& table, const std::string& key, bool& target) const
  {
    table.read(key, target);
  }
  std::string write(bool value) const { return to_toml(value); }
  std::string allowed() const { return "true, false"; }
};

struct Point
{
  void read(const TableReader& table, const std::string& key, Vector3& target) const
  {
    table.read(key, target);
  }
  std::string write(const Vector3& value) const { return to_toml(value); }
  std::string allowed() const { return "[x, y, z]"; }
};

/// Brought to length 1.
struct Direction
{
  void read(const TableReader& table, const std::string& key, Vector3& target) const
  {
    table.read_direction(key, target);
  }
  std::string write(const Vector3& value) const { return to_toml(value); }
  std::string allowed() const { return "[x, y, z], not all 0"; }
};

/// One of a list of words.
struct Word
{
  const std::vector<std::string>& words;

  void read(const TableReader& table, const std::string& key, std::string& target) const
  {
    table.read(key, target, words);
  }
  std::string write(const std::string& value) const { return to_toml(value); }
  std::string allowed() const { return in_quotes(words); }
};

/// Any of a list of words.
struct Words
{
  const std::vector<std::string>& words;

  void read(
    const TableReader& table, const std::string& key, std::vector<std::string>& target) const
  {
    table.read(key, target, words);
  }
  std::string write(const std::vector<std::string>& value) const { return to_toml(value); }
  std::string allowed() const { return "any of " + in_quotes(words); }
};

/// A word for each value of an enumeration.
template<class Enumeration, std::size_t n>
struct Choice
{
  std::array<NamedChoice<Enumeration>, n> choices;

  void read(const TableReader& table, const std::string& key, Enumeration& target) const
  {
    table.read(key, target, choices);
  }
  std::string write(Enumeration value) const { return to_toml(name_of(choices, value)); }
  std::string allowed() const
  {
    std::vector<std::string> words;
    for (const auto& choice : choices)
      words.emplace_back(choice.name);
    return in_quotes(words);
  }
};
template<class Enumeration, std::size_t n>
Choice(std::array<NamedChoice<Enumeration>, n>) -> Choice<Enumeration, n>;

/// The path of something, relative to the scene's folder; absolute in memory and as written.
struct Path
{
  const char* what; ///< "the path of a mesh"

  void read(const TableReader& table, const std::string& key,
    std::optional<std::filesystem::path>& target) const
  {
    std::string path;
    table.read(key, path);
    if (path.empty())
      table.fail(key, "can't be empty", what);
    target = std::filesystem::absolute(table.folder() / path).lexically_normal();
  }
  std::string write(const std::optional<std::filesystem::path>& value) const
  {
    return value ? to_toml(std::filesystem::absolute(*value).string()) : "";
  }
  std::string allowed() const { return what; }
};

}
