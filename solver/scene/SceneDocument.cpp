#include "solver/scene/SceneDocument.h"

#include "solver/Errors.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <iterator>
#include <sstream>
#include <string_view>

namespace vesicle
{
namespace
{

struct Described
{
  std::string operator()(bool value) const { return value ? "true" : "false"; }
  std::string operator()(std::int64_t value) const { return fmt::format("the integer {}", value); }
  std::string operator()(double value) const { return fmt::format("the number {}", value); }
  std::string operator()(const std::string& value) const
  {
    return fmt::format("the string \"{}\"", value);
  }
  std::string operator()(const SceneValue::Array& value) const
  {
    return fmt::format("an array of {}", value.size());
  }
  std::string operator()(const SceneValue::Other& value) const { return value.what; }
};

/// The place of a node that comes from a file.
std::string line_of(const toml::node& node, const std::string& name)
{
  return fmt::format("{}:{}", name, std::max<unsigned>(1, node.source().begin.line));
}

/// `place` gives the "where" of a node.
template<class Place>
SceneValue convert(const toml::node& node, const Place& place)
{
  SceneValue result;
  result.where = place(node);
  if (const auto* flag = node.as_boolean())
    result.data = flag->get();
  else if (const auto* integer = node.as_integer())
    result.data = static_cast<std::int64_t>(integer->get());
  else if (const auto* number = node.as_floating_point())
    result.data = number->get();
  else if (const auto* text = node.as_string())
    result.data = text->get();
  else if (const auto* array = node.as_array())
  {
    SceneValue::Array items;
    for (const toml::node& item : *array)
      items.push_back(convert(item, place));
    result.data = std::move(items);
  }
  else
    result.data = SceneValue::Other{ node.is_table() ? "a table" : "a date or time" };
  return result;
}

unsigned line_number(const toml::node& node)
{
  return node.source().begin.line;
}

/// toml++ sorts its tables by name; people read files from the top.
std::vector<std::pair<std::string, const toml::node*>> in_file_order(const toml::table& table)
{
  std::vector<std::pair<std::string, const toml::node*>> nodes;
  for (const auto& [key, node] : table)
    nodes.emplace_back(std::string(key.str()), &node);
  std::stable_sort(nodes.begin(), nodes.end(),
    [](const auto& a, const auto& b) { return line_number(*a.second) < line_number(*b.second); });
  return nodes;
}

/// What a line of a file begins with: "key" of key = value, "[table]"; empty for others.
std::string beginning_of(std::string line)
{
  std::erase_if(line, [](char c) { return c == ' ' || c == '\t' || c == '"' || c == '\r'; });
  return line.starts_with('[') ? line.substr(0, line.find(']') + 1)
                               : line.substr(0, line.find('='));
}

/// Of a parser's complaint that something is defined again: what, and both lines; else empty.
std::string said_twice(const std::string& text, const std::string& complaint, int line)
{
  if (complaint.find("cannot redefine") == std::string::npos)
    return {};
  std::vector<std::string> beginnings;
  std::istringstream lines(text);
  for (std::string next; static_cast<int>(beginnings.size()) < line && std::getline(lines, next);)
    beginnings.push_back(beginning_of(next));
  if (static_cast<int>(beginnings.size()) < line)
    return {};
  const std::string again = beginnings.back();
  const auto before = std::find(std::next(beginnings.rbegin()), beginnings.rend(), again);
  if (before == beginnings.rend())
    return {};
  return fmt::format(
    "'{}' is in line {} already; allowed: each once", again, beginnings.rend() - before);
}

void add_table(SceneDocument& document, const std::string& name, const toml::table& table)
{
  const auto place = [&](const toml::node& node) { return line_of(node, document.name); };
  document.tables.push_back({ name, place(table) });
  for (const auto& [key, node] : in_file_order(table))
    document.entries.push_back({ name, key, convert(*node, place) });
}

SceneDocument parse_file(const std::string& text, const std::string& name)
{
  SceneDocument document;
  document.name = name;
  const auto place = [&](const toml::node& node) { return line_of(node, name); };
  try
  {
    const toml::table root = toml::parse(text, name);
    for (const auto& [key, node] : in_file_order(root))
      if (const auto* table = node->as_table())
        add_table(document, key, *table);
      else
        document.entries.push_back({ "", key, convert(*node, place) });
  }
  catch (const toml::parse_error& error)
  {
    const int line = static_cast<int>(error.source().begin.line);
    if (const std::string twice = said_twice(text, std::string(error.description()), line);
        !twice.empty())
      throw InputError(fmt::format("{}:{}: {}", name, line, twice));
    throw InputError(
      fmt::format("{}:{}: not valid TOML: {}; allowed: [table] and key = value lines", name, line,
        error.description()));
  }
  return document;
}

struct Override
{
  std::string table;
  std::string key;
  std::string value;
  std::string where;
};

Override split_override(const std::string& text)
{
  const std::string where = "--set " + text;
  const auto equals = text.find('=');
  const std::string path = text.substr(0, equals);
  const auto dot = path.find('.');
  const std::string key = dot == std::string::npos ? path : path.substr(dot + 1);
  const bool split = equals != std::string::npos && equals + 1 < text.size() && dot != 0 &&
    !key.empty() && key.find('.') == std::string::npos;
  if (!split)
    throw InputError(
      where + ": is not an override; allowed: table.key=value, for example flow.rate=2");
  const std::string table = dot == std::string::npos ? "" : path.substr(0, dot);
  return { table, key, text.substr(equals + 1), where };
}

/// Words that aren't TOML are taken as strings, so that nobody has to quote quotes in a shell;
/// something that starts like a quoted string, array or table must be one.
SceneValue override_value(const Override& change)
{
  const auto place = [&](const toml::node&) { return change.where; };
  SceneValue value;
  try
  {
    const toml::table parsed = toml::parse("value = " + change.value);
    if (parsed.size() == 1)
    {
      value = convert(*parsed.get("value"), place);
      value.text = change.value;
      return value;
    }
  }
  catch (const toml::parse_error& error)
  {
    if (std::string_view("\"'[{").find(change.value.front()) != std::string_view::npos)
      throw InputError(fmt::format("{}: the value is not valid TOML: {}; allowed: a number, true, "
                                   "false, a word, or an array like [0, 0, 1]",
        change.where, error.description()));
  }
  value.data = change.value;
  value.where = change.where;
  value.text = change.value;
  return value;
}

void apply_override(SceneDocument& document, const std::string& text)
{
  const Override change = split_override(text);
  SceneValue value = override_value(change);
  if (!change.table.empty() && !document.find_table(change.table))
    document.tables.push_back({ change.table, change.where });
  for (auto& entry : document.entries)
    if (entry.table == change.table && entry.key == change.key)
    {
      entry.value = std::move(value);
      return;
    }
  document.entries.push_back({ change.table, change.key, std::move(value) });
}

}

std::string SceneValue::description() const
{
  return std::visit(Described{}, data);
}

const SceneValue* SceneDocument::find(const std::string& table, const std::string& key) const
{
  for (const auto& entry : entries)
    if (entry.table == table && entry.key == key)
      return &entry.value;
  return nullptr;
}

const SceneDocument::Table* SceneDocument::find_table(const std::string& table) const
{
  for (const auto& candidate : tables)
    if (candidate.name == table)
      return &candidate;
  return nullptr;
}

SceneDocument parse_document(const std::string& text, const std::string& name,
  const std::filesystem::path& folder, const std::vector<std::string>& overrides)
{
  SceneDocument document = parse_file(text, name);
  document.folder = folder;
  for (const auto& change : overrides)
    apply_override(document, change);
  return document;
}

}
