#include "solver/scene/TableReader.h"

#include "solver/Errors.h"
#include "solver/Joined.h"
#include "solver/scene/NearestName.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace vesicle
{
namespace
{

bool contains(const std::vector<std::string>& names, const std::string& name)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string listed(const std::vector<std::string>& names)
{
  return joined(names, ", ");
}

/// ` did you mean …?` for a key (quote ') or a word (quote "), if one of them is near.
std::string suggestion(const std::string& name, const std::vector<std::string>& known, char quote)
{
  const std::string nearest = nearest_name(name, known);
  return nearest.empty() ? "" : fmt::format(", did you mean {0}{1}{0}?", quote, nearest);
}

}

std::string in_quotes(const std::vector<std::string>& words)
{
  return fmt::format("\"{}\"", joined(words, "\", \""));
}

Vector3 unit_direction(const Vector3& v)
{
  const double rounding = 4 * std::numeric_limits<double>::epsilon();
  const Vector3 unit = v / v.cwiseAbs().maxCoeff(); // so that no square over- or underflows
  return std::abs(v.squaredNorm() - 1) <= rounding ? v : unit.normalized();
}

TableReader::TableReader(const SceneDocument& document, std::string table)
  : document_(document), table_(std::move(table))
{
}

bool TableReader::given() const
{
  return document_.find_table(table_) != nullptr;
}

bool TableReader::has(const std::string& key) const
{
  return document_.find(table_, key) != nullptr;
}

const SceneValue& TableReader::at(const std::string& key) const
{
  return *document_.find(table_, key);
}

std::string TableReader::path(const std::string& key) const
{
  const auto* entry = document_.find_entry(table_, key);
  const auto* table = document_.find_table(table_);
  const std::string& shown = entry ? entry->shown : table ? table->shown : table_;
  return shown.empty() ? key : shown + "." + key;
}

std::string TableReader::place() const
{
  const auto* table = document_.find_table(table_);
  return table ? table->where : document_.name + ":1";
}

void TableReader::fail_at(const std::string& where, const std::string& key,
  const std::string& problem, const std::string& allowed) const
{
  throw InputError(
    fmt::format("{}: key '{}': {}; allowed: {}", where, path(key), problem, allowed));
}

void TableReader::fail(
  const std::string& key, const std::string& problem, const std::string& allowed) const
{
  const auto* value = document_.find(table_, key);
  fail_at(value ? value->where : place(), key, problem, allowed);
}

void TableReader::check_keys(const std::vector<std::string>& keys) const
{
  check_keys(keys, keys, "");
}

void TableReader::check_keys(const std::vector<std::string>& keys,
  const std::vector<std::string>& known, const std::string& because) const
{
  for (const auto& entry : document_.entries)
  {
    if (entry.table != table_ || contains(keys, entry.key))
      continue;
    if (contains(known, entry.key))
      fail(entry.key, "does not go with " + because, listed(keys));
    fail(entry.key, "unknown key" + suggestion(entry.key, keys, '\''), listed(keys));
  }
}

void TableReader::require(const std::string& key, const std::string& allowed) const
{
  if (!has(key))
    fail(key, "is missing", allowed);
}

double TableReader::number(
  const std::string& key, const SceneValue& value, const NumberRule& rule) const
{
  const auto* integer = std::get_if<std::int64_t>(&value.data);
  const auto* real = std::get_if<double>(&value.data);
  if (!integer && !real)
    fail_at(value.where, key, "must be a number, is " + value.description(), rule.allowed);
  const double number = integer ? static_cast<double>(*integer) : *real;
  if (!std::isfinite(number) || !rule.holds(number))
    fail_at(value.where, key, fmt::format("can't be {}", number), rule.allowed);
  return number;
}

int TableReader::integer(
  const std::string& key, const SceneValue& value, const IntegerRule& rule) const
{
  const auto* integer = std::get_if<std::int64_t>(&value.data);
  if (!integer)
    fail_at(value.where, key, "must be an integer, is " + value.description(), rule.allowed);
  if (!std::in_range<int>(*integer) || !rule.holds(static_cast<int>(*integer)))
    fail_at(value.where, key, fmt::format("can't be {}", *integer), rule.allowed);
  return static_cast<int>(*integer);
}

const SceneValue::Array& TableReader::items(const std::string& key, const SceneValue& value,
  std::size_t size, const std::string& allowed) const
{
  const auto* array = std::get_if<SceneValue::Array>(&value.data);
  if (!array || (size > 0 && array->size() != size))
  {
    const std::string wanted = size > 0 ? fmt::format("an array of {}", size) : "an array";
    fail_at(
      value.where, key, fmt::format("must be {}, is {}", wanted, value.description()), allowed);
  }
  return *array;
}

std::string TableReader::word(
  const std::string& key, const SceneValue& value, const std::string& allowed) const
{
  if (!value.text.empty() && !std::holds_alternative<std::string>(value.data))
    return value.text; // on the command line nobody quotes a name like 2024
  const auto* text = std::get_if<std::string>(&value.data);
  if (!text)
    fail_at(value.where, key, "must be a string, is " + value.description(), allowed);
  return *text;
}

std::size_t TableReader::choose(
  const std::string& key, const SceneValue& value, const std::vector<std::string>& words) const
{
  const std::string allowed = in_quotes(words);
  const std::string name = word(key, value, allowed);
  const auto found = std::find(words.begin(), words.end(), name);
  if (found == words.end())
    fail_at(value.where, key, fmt::format("can't be \"{}\"{}", name, suggestion(name, words, '"')),
      allowed);
  return static_cast<std::size_t>(found - words.begin());
}

void TableReader::read(const std::string& key, bool& target) const
{
  if (!has(key))
    return;
  const auto* flag = std::get_if<bool>(&at(key).data);
  if (!flag)
    fail(key, "must be true or false, is " + at(key).description(), "true, false");
  target = *flag;
}

void TableReader::read(const std::string& key, double& target, const NumberRule& rule) const
{
  if (has(key))
    target = number(key, at(key), rule);
}

void TableReader::read(const std::string& key, int& target, const IntegerRule& rule) const
{
  if (has(key))
    target = integer(key, at(key), rule);
}

void TableReader::read(const std::string& key, Vector3& target) const
{
  std::array<double, 3> values{ target[0], target[1], target[2] };
  read(key, values, any_number);
  target = Vector3(values[0], values[1], values[2]);
}

void TableReader::read(const std::string& key, std::string& target) const
{
  if (has(key))
    target = word(key, at(key), "a string");
}

void TableReader::read(
  const std::string& key, std::string& target, const std::vector<std::string>& words) const
{
  if (!has(key))
    return;
  target = words[choose(key, at(key), words)];
}

void TableReader::read(const std::string& key, std::vector<std::string>& target,
  const std::vector<std::string>& words) const
{
  if (!has(key))
    return;
  target.clear();
  for (const auto& item : items(key, at(key), 0, "an array of " + in_quotes(words)))
    target.push_back(words[choose(key, item, words)]);
}

void TableReader::read_unless(const std::string& key, const std::string& word,
  std::optional<double>& target, const NumberRule& rule) const
{
  if (!has(key))
    return;
  const std::string allowed = fmt::format("{} or \"{}\"", rule.allowed, word);
  const auto* text = std::get_if<std::string>(&at(key).data);
  if (text && *text == word)
  {
    target.reset();
    return;
  }
  if (text)
    fail(key, "can't be " + at(key).description(), allowed);
  target = number(key, at(key), { rule.holds, allowed.c_str() });
}

void TableReader::read_direction(const std::string& key, Vector3& target) const
{
  if (!has(key))
    return;
  read(key, target);
  if (target.isZero(0))
    fail(key, "can't be the zero vector", "[x, y, z], not all 0");
  target = unit_direction(target);
}

}
