#include "apps/ParameterGrid.h"

#include "solver/Errors.h"
#include "solver/Joined.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <set>

namespace vesicle
{
namespace
{

/// What a range's steps may miss its end by, of a step.
constexpr double rounding = 1e-6;
constexpr double most_steps = 1e5;

[[noreturn]] void refuse(const std::string& text, const std::string& why)
{
  throw InputError(
    fmt::format("--over {}: {}; give table.key=0.5,1,2 or table.key=from:to:step", text, why));
}

/// At separators outside of brackets and quotes.
std::vector<std::string> parts_of(const std::string& text, char separator)
{
  std::vector<std::string> parts(1);
  int depth = 0;
  bool quoted = false;
  for (const char c : text)
  {
    quoted = c == '"' ? !quoted : quoted;
    depth += quoted ? 0 : (c == '[') - (c == ']');
    if (c == separator && depth == 0 && !quoted)
    {
      parts.emplace_back();
    }
    else
    {
      parts.back() += c;
    }
  }
  return parts;
}

std::optional<double> number_in(const std::string& word)
{
  double value = 0;
  const char* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  return error == std::errc() && stop == end && std::isfinite(value) ? std::optional(value)
                                                                     : std::nullopt;
}

/// Without what a step of 0.1 leaves behind in the last digits; as an integer where all are.
std::string value_text(double value, bool integers)
{
  const std::string text = fmt::format("{:.12g}", std::abs(value) < 1e-300 ? 0 : value);
  const bool whole = text.find_first_of(".en") == std::string::npos;
  return whole && !integers ? text + ".0" : text;
}

std::vector<std::string> values_between(
  const std::string& text, const std::vector<std::string>& words)
{
  std::vector<double> numbers;
  bool integers = true;
  for (const std::string& word : words)
  {
    const auto number = number_in(word);
    if (!number)
    {
      refuse(text, fmt::format("'{}' is not a number", word));
    }
    numbers.push_back(*number);
    integers = integers && word.find_first_of(".eE") == std::string::npos;
  }
  const double from = numbers[0], to = numbers[1], length = std::abs(numbers[2]);
  if (!(length > 0) || std::abs(to - from) / length > most_steps)
  {
    refuse(
      text, fmt::format("a step of {} doesn't lead from {} to {}", words[2], words[0], words[1]));
  }
  const auto steps = static_cast<int>(std::floor(std::abs(to - from) / length + rounding));
  std::vector<std::string> values;
  for (int i = 0; i <= steps; ++i)
  {
    values.push_back(value_text(from + (to < from ? -i : i) * length, integers));
  }
  return values;
}

/// What may stand in a folder's name.
std::string safe(const std::string& text)
{
  std::string result;
  for (const char c : text)
  {
    const bool usable = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') ||
      (c >= 'A' && c <= 'Z') || c == '.' || c == '-' || c == '+';
    result += usable ? c : '-';
  }
  return result;
}

/// The key without its table, unless another range's is called the same.
std::string short_name(const ParameterRange& range, const std::vector<ParameterRange>& ranges)
{
  const auto leaf = [](const std::string& key) { return key.substr(key.rfind('.') + 1); };
  for (const ParameterRange& other : ranges)
  {
    if (&other != &range && leaf(other.key) == leaf(range.key))
    {
      return range.key;
    }
  }
  return leaf(range.key);
}

}

ParameterRange parse_range(const std::string& text)
{
  const auto equals = text.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == text.size())
  {
    refuse(text, "is not a key with values");
  }
  ParameterRange range{ text.substr(0, equals), {} };
  const std::string values = text.substr(equals + 1);
  const auto ends = parts_of(values, ':');
  range.values = ends.size() == 3 ? values_between(text, ends) : parts_of(values, ',');
  for (const std::string& value : range.values)
  {
    if (value.empty())
    {
      refuse(text, "a value is missing");
    }
  }
  return range;
}

std::vector<GridPoint> parameter_grid(const std::vector<ParameterRange>& ranges, int most)
{
  std::vector<GridPoint> grid(1);
  std::set<std::string> keys;
  for (const ParameterRange& range : ranges)
  {
    if (!keys.insert(range.key).second)
    {
      throw InputError(fmt::format("--over {}: this key is there twice", range.key));
    }
    if (static_cast<double>(grid.size()) * static_cast<double>(range.values.size()) > most)
    {
      throw InputError(fmt::format("--over: more than {} runs; take fewer values", most));
    }
    std::vector<GridPoint> longer;
    for (const GridPoint& point : grid)
    {
      for (const std::string& value : range.values)
      {
        GridPoint next = point;
        next.values.push_back(value);
        next.overrides.push_back(range.key + "=" + value);
        next.name += fmt::format(
          "{}{}={}", next.name.empty() ? "" : "_", short_name(range, ranges), safe(value));
        longer.push_back(std::move(next));
      }
    }
    grid = std::move(longer);
  }
  std::set<std::string> names;
  for (const GridPoint& point : grid)
  {
    if (!names.insert(point.name).second)
    {
      throw InputError(
        fmt::format("--over: two runs would write to {}; give each value once", point.name));
    }
  }
  return grid;
}

}
