#pragma once
// Reads the keys of one table of a scene into plain data, each checked against a rule. Every
// failure is an InputError "where: key 'table.key': what is wrong; allowed: …". A key that isn't
// given leaves its target as it is.

#include "solver/scene/SceneDocument.h"
#include "solver/scene/SceneNames.h"

#include <Eigen/Core>

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace vesicle
{

/// What a finite number must satisfy, and the same in words.
struct NumberRule
{
  bool (*holds)(double);
  const char* allowed;
};
inline constexpr NumberRule any_number{ [](double) { return true; }, "a finite number" };
inline constexpr NumberRule not_negative{ [](double x) { return x >= 0; }, "a number >= 0" };
inline constexpr NumberRule positive{ [](double x) { return x > 0; }, "a number > 0" };

struct IntegerRule
{
  bool (*holds)(int);
  const char* allowed;
};
inline constexpr IntegerRule triangle_count{ [](int n) { return n >= 20 && n <= 5'000'000; },
  "an integer from 20 (an icosahedron) to 5000000" };

/// `v` at length 1; exactly `v` where it already is, so that what was written reads back bit for
/// bit.
Vector3 unit_direction(const Vector3& v);

/// "a", "b", "c"
std::string in_quotes(const std::vector<std::string>& words);

class TableReader
{
public:
  TableReader(const SceneDocument& document, std::string table);

  /// Whether the scene has the table.
  bool given() const;
  bool has(const std::string& key) const;
  /// The folder that relative paths start from.
  const std::filesystem::path& folder() const { return document_.folder; }

  /// Refuses keys that aren't in `keys`, naming the nearest one that is.
  void check_keys(const std::vector<std::string>& keys) const;
  /// The same where the choice `because` (such as `kind = "shear"`) rules out some of the `known`
  /// keys.
  void check_keys(const std::vector<std::string>& keys, const std::vector<std::string>& known,
    const std::string& because) const;
  void require(const std::string& key, const std::string& allowed) const;

  void read(const std::string& key, bool& target) const;
  void read(const std::string& key, double& target, const NumberRule& rule) const;
  void read(const std::string& key, int& target, const IntegerRule& rule) const;
  void read(const std::string& key, Vector3& target) const;
  void read(const std::string& key, std::string& target) const;
  /// One of a list of words.
  void read(
    const std::string& key, std::string& target, const std::vector<std::string>& words) const;
  template<std::size_t n>
  void read(const std::string& key, std::array<double, n>& target, const NumberRule& rule) const;
  template<class Choice, std::size_t n>
  void read(const std::string& key, Choice& target,
    const std::array<NamedChoice<Choice>, n>& choices) const;
  /// Into an optional by the rule of what it holds.
  template<class T, class... Rule>
  void read(const std::string& key, std::optional<T>& target, const Rule&... rule) const;

  /// A number, or `word` for an empty target.
  void read_unless(const std::string& key, const std::string& word, std::optional<double>& target,
    const NumberRule& rule) const;
  /// A direction of any length but 0, brought to length 1.
  void read_direction(const std::string& key, Vector3& target) const;
  /// A list of words, each from `words`.
  void read(const std::string& key, std::vector<std::string>& target,
    const std::vector<std::string>& words) const;

  /// The value of a key that is given.
  const SceneValue& at(const std::string& key) const;
  double number(const std::string& key, const SceneValue& value, const NumberRule& rule) const;
  int integer(const std::string& key, const SceneValue& value, const IntegerRule& rule) const;
  /// The items of an array of `size` (0: any size).
  const SceneValue::Array& items(const std::string& key, const SceneValue& value, std::size_t size,
    const std::string& allowed) const;

  [[noreturn]] void fail(
    const std::string& key, const std::string& problem, const std::string& allowed) const;
  [[noreturn]] void fail_at(const std::string& where, const std::string& key,
    const std::string& problem, const std::string& allowed) const;

private:
  std::string path(const std::string& key) const;
  std::string place() const;
  std::string word(
    const std::string& key, const SceneValue& value, const std::string& allowed) const;
  /// The index of the word that the value is.
  std::size_t choose(
    const std::string& key, const SceneValue& value, const std::vector<std::string>& words) const;

  const SceneDocument& document_;
  std::string table_;
};

template<std::size_t n>
void TableReader::read(
  const std::string& key, std::array<double, n>& target, const NumberRule& rule) const
{
  if (!has(key))
    return;
  const std::string allowed = "an array of " + std::to_string(n) + ", each " + rule.allowed;
  const auto& values = items(key, at(key), n, allowed);
  for (std::size_t i = 0; i < n; ++i)
    target[i] = number(key, values[i], rule);
}

template<class Choice, std::size_t n>
void TableReader::read(
  const std::string& key, Choice& target, const std::array<NamedChoice<Choice>, n>& choices) const
{
  if (!has(key))
    return;
  std::vector<std::string> words;
  words.reserve(n);
  for (const auto& choice : choices)
    words.emplace_back(choice.name);
  target = choices[choose(key, at(key), words)].choice;
}

template<class T, class... Rule>
void TableReader::read(const std::string& key, std::optional<T>& target, const Rule&... rule) const
{
  if (has(key))
  {
    T value{};
    read(key, value, rule...);
    target = value;
  }
}

}
