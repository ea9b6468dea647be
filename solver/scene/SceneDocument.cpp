#include "solver/scene/SceneDocument.h"

#include "solver/Errors.h"
#include "solver/Joined.h"
#include "solver/mesh/io/TextScanner.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <charconv>
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
  return fmt::format("'{}' is in line {} already; allowed: each once{}", again,
    beginnings.rend() - before,
    again == "[vesicle]" ? ", or [[vesicle]] for each of several vesicles" : "");
}

constexpr const char* vesicle_name = "vesicle";

std::string numbered(std::size_t vesicle, std::size_t count)
{
  return count == 1 ? std::string(vesicle_name) : fmt::format("{}.{}", vesicle_name, vesicle);
}

bool is_own_table(const std::string& name)
{
  return std::find(own_tables().begin(), own_tables().end(), name) != own_tables().end();
}

/// Of a document or of a vesicle.
template<class Tables>
void add_table(Tables& to, const std::string& name, const std::string& shown,
  const toml::table& table, const std::string& file)
{
  const auto place = [&](const toml::node& node) { return line_of(node, file); };
  to.tables.push_back({ name, place(table), shown });
  for (const auto& [key, node] : in_file_order(table))
    if (name != vesicle_name || !node->is_table() || !is_own_table(key))
      to.entries.push_back({ name, key, convert(*node, place), shown });
}

SceneDocument::Vesicle vesicle_of(
  const toml::table& table, const std::string& shown, const std::string& file)
{
  SceneDocument::Vesicle vesicle{ shown, {}, {} };
  add_table(vesicle, vesicle_name, shown, table, file);
  for (const auto& [key, node] : in_file_order(table))
    if (const auto* own = node->as_table(); own && is_own_table(key))
      add_table(vesicle, key, fmt::format("{}.{}", shown, key), *own, file);
  for (const auto& entry : vesicle.entries)
    if (is_of_the_scene(entry.table, entry.key))
      throw InputError(fmt::format("{}: key '{}.{}': is one for all vesicles; allowed: [{}] {}",
        entry.value.where, entry.shown, entry.key, entry.table, entry.key));
  return vesicle;
}

/// [vesicle], or [[vesicle]] once or several times; nothing for what is neither.
std::vector<SceneDocument::Vesicle> vesicles_of(const toml::node& node, const std::string& file)
{
  std::vector<SceneDocument::Vesicle> vesicles;
  if (const auto* table = node.as_table())
    vesicles.push_back(vesicle_of(*table, vesicle_name, file));
  else if (const auto* array = node.as_array(); array && array->is_array_of_tables())
    for (const toml::node& item : *array)
      vesicles.push_back(
        vesicle_of(*item.as_table(), numbered(vesicles.size(), array->size()), file));
  return vesicles;
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
    {
      if (key == vesicle_name)
        document.vesicles = vesicles_of(*node, name);
      if (key == vesicle_name && !document.vesicles.empty())
        continue;
      if (const auto* table = node->as_table())
        add_table(document, key, key, *table, name);
      else
        document.entries.push_back({ "", key, convert(*node, place), "" });
    }
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
  if (document.vesicles.empty())
    document.vesicles.push_back({ vesicle_name, {}, {} });
  return document;
}

struct Override
{
  std::string table;
  std::string key;
  std::string value;
  std::string where;
};

bool is_of_vesicles(const std::string& table)
{
  return table == vesicle_name || table.starts_with(std::string(vesicle_name) + ".");
}

Override split_override(const std::string& text)
{
  const std::string where = "--set " + text;
  const auto equals = text.find('=');
  const std::string path = text.substr(0, equals);
  const auto dot = path.rfind('.');
  const std::string key = dot == std::string::npos ? path : path.substr(dot + 1);
  const std::string table = dot == std::string::npos ? "" : path.substr(0, dot);
  const bool split = equals != std::string::npos && equals + 1 < text.size() && dot != 0 &&
    !key.empty() && (table.find('.') == std::string::npos || is_of_vesicles(table));
  if (!split)
    throw InputError(
      where + ": is not an override; allowed: table.key=value, for example flow.rate=2");
  return { table, key, text.substr(equals + 1), where };
}

/// Words that aren't TOML are numbers (".3", "5.") or strings, so that nobody has to quote quotes in a
/// shell; something that starts like a quoted string, array or table must be one.
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
  value.where = change.where;
  value.text = change.value;
  if (const auto number = number_of<double>(change.value))
    value.data = *number;
  else
    value.data = change.value;
  return value;
}

/// Of a document or of a vesicle.
template<class Tables>
void set(Tables& in, const std::string& table, const std::string& shown, const std::string& key,
  const SceneValue& value)
{
  const auto has_name = [&](const auto& candidate) { return candidate.name == table; };
  if (!table.empty() && std::none_of(in.tables.begin(), in.tables.end(), has_name))
    in.tables.push_back({ table, value.where, shown });
  for (auto& entry : in.entries)
    if (entry.table == table && entry.key == key)
    {
      entry.value = value;
      return;
    }
  in.entries.push_back({ table, key, value, shown });
}

/// Which vesicles "vesicle", "vesicle.1", "vesicle.1.membrane" means, and the table of theirs.
struct VesiclePath
{
  std::size_t first, last;
  std::string table;
};

VesiclePath vesicle_path(const SceneDocument& document, const Override& change)
{
  const auto count = document.vesicles.size();
  VesiclePath path{ 0, count, vesicle_name };
  std::string rest = change.table.substr(std::min(change.table.size(), sizeof("vesicle.") - 1));
  if (!rest.empty() && rest.find_first_not_of("0123456789.") != 0)
  {
    const std::string number = rest.substr(0, rest.find('.'));
    rest = rest.substr(std::min(rest.size(), number.size() + 1));
    const auto [end, error] =
      std::from_chars(number.data(), number.data() + number.size(), path.first);
    if (error != std::errc() || end != number.data() + number.size() || path.first >= count)
      throw InputError(fmt::format("{}: there is no vesicle {}; allowed: {}", change.where, number,
        count == 1 ? std::string("0, the only one") : fmt::format("0 to {}", count - 1)));
    path.last = path.first + 1;
  }
  if (!rest.empty())
    path.table = rest;
  if (path.table != vesicle_name && !is_own_table(path.table))
    throw InputError(fmt::format("{}: a vesicle has no table '{}' of its own; allowed: {}",
      change.where, path.table, joined(own_tables(), ", ")));
  if (is_of_the_scene(path.table, change.key))
    throw InputError(fmt::format(
      "{}: is one for all vesicles; allowed: {}.{}", change.where, path.table, change.key));
  return path;
}

/// A table of its own that a vesicle gets on the command line differs from the scene's in that key.
void set_of_vesicle(SceneDocument& document, std::size_t number, const std::string& table,
  const std::string& key, const SceneValue& value)
{
  auto& vesicle = document.vesicles[number];
  const bool own = table != vesicle_name;
  const std::string shown = own ? vesicle.shown + "." + table : vesicle.shown;
  const auto has_name = [&](const auto& candidate) { return candidate.name == table; };
  if (own && std::none_of(vesicle.tables.begin(), vesicle.tables.end(), has_name))
    for (const auto& entry : document.entries)
      if (entry.table == table && !is_of_the_scene(table, entry.key))
        set(vesicle, table, shown, entry.key, entry.value);
  set(vesicle, table, shown, key, value);
}

void apply_override(SceneDocument& document, const std::string& text)
{
  const Override change = split_override(text);
  const SceneValue value = override_value(change);
  if (!is_of_vesicles(change.table))
  {
    set(document, change.table, change.table, change.key, value);
    return;
  }
  const VesiclePath path = vesicle_path(document, change);
  for (std::size_t v = path.first; v < path.last; ++v)
    set_of_vesicle(document, v, path.table, change.key, value);
}

}

std::string SceneValue::description() const
{
  return std::visit(Described{}, data);
}

const SceneDocument::Entry* SceneDocument::find_entry(
  const std::string& table, const std::string& key) const
{
  for (const auto& entry : entries)
    if (entry.table == table && entry.key == key)
      return &entry;
  return nullptr;
}

const SceneValue* SceneDocument::find(const std::string& table, const std::string& key) const
{
  const Entry* entry = find_entry(table, key);
  return entry ? &entry->value : nullptr;
}

const SceneDocument::Table* SceneDocument::find_table(const std::string& table) const
{
  for (const auto& candidate : tables)
    if (candidate.name == table)
      return &candidate;
  return nullptr;
}

SceneDocument SceneDocument::of_vesicle(std::size_t number) const
{
  const Vesicle& vesicle = vesicles.at(number);
  const auto has_own = [&](const std::string& table)
  {
    return std::any_of(vesicle.tables.begin(), vesicle.tables.end(),
      [&](const Table& own) { return own.name == table; });
  };
  SceneDocument document{ name, folder, {}, {}, {} };
  for (const Table& table : tables)
    if (!has_own(table.name))
      document.tables.push_back(table);
  for (const Entry& entry : entries)
    if (!has_own(entry.table) || is_of_the_scene(entry.table, entry.key))
      document.entries.push_back(entry);
  document.tables.insert(document.tables.end(), vesicle.tables.begin(), vesicle.tables.end());
  document.entries.insert(document.entries.end(), vesicle.entries.begin(), vesicle.entries.end());
  return document;
}

bool is_of_the_scene(const std::string& table, const std::string& key)
{
  return table == "fluid" && (key == "viscosity" || key == "temperature");
}

const std::vector<std::string>& own_tables()
{
  static const std::vector<std::string> names{ "membrane", "fluid", "gravity" };
  return names;
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
