// The keys of [flow]: they are what the kinds of flow say of themselves (flow/FlowKinds.h).

#include "solver/Joined.h"
#include "solver/flow/FlowKinds.h"
#include "solver/scene/SceneRules.h"
#include "solver/scene/SceneSchema.h"

#include <fmt/format.h>

#include <algorithm>

namespace vesicle
{
namespace
{

/// The kinds that a scene calls `name`.
std::vector<const FlowKind*> kinds_named(const std::string& name)
{
  std::vector<const FlowKind*> kinds;
  for (const FlowKind* kind : flow_kinds())
    if (kind->name == name)
      kinds.push_back(kind);
  return kinds;
}

/// The first of each name.
std::vector<const FlowKind*> kinds_by_name()
{
  std::vector<const FlowKind*> kinds;
  for (const FlowKind* kind : flow_kinds())
    if (kinds_named(kind->name).front() == kind)
      kinds.push_back(kind);
  return kinds;
}

std::vector<std::string> names()
{
  std::vector<std::string> names;
  for (const FlowKind* kind : kinds_by_name())
    names.push_back(kind->name);
  return names;
}

std::vector<std::string> types_of(const std::string& name)
{
  std::vector<std::string> types;
  for (const FlowKind* kind : kinds_named(name))
    types.push_back(kind->type);
  return types;
}

/// The kind that the words of a table choose.
const FlowKind& chosen_kind(const TableReader& table)
{
  std::string name, type;
  table.read("kind", name, names());
  const auto kinds = kinds_named(name);
  const auto types = types_of(name);
  if (kinds.size() > 1)
    table.read("type", type, types);
  return *kinds[std::find(types.begin(), types.end(), type) - types.begin()];
}

SceneKey kind_key()
{
  SceneKey key;
  key.name = "kind";
  key.allowed = in_quotes(names());
  key.help = "of the flow";
  key.read = [](const TableReader& table, Scene& scene) { scene.flow = chosen_kind(table).make(); };
  key.write = [](const Scene& scene) { return to_toml(scene.flow->kind().name); };
  return key.required();
}

/// Tells the kinds of one name apart; read together with it.
SceneKey type_key(const std::string& name)
{
  std::vector<std::string> described;
  for (const FlowKind* kind : kinds_named(name))
    described.push_back(fmt::format("\"{}\" ({})", kind->type, kind->axes));
  SceneKey key;
  key.name = "type";
  key.allowed = in_quotes(types_of(name));
  key.help = "which one, and along which axes";
  key.read = [](const TableReader&, Scene&) {};
  key.write = [](const Scene& scene) { return to_toml(scene.flow->kind().type); };
  return key.with({ name }).required(joined(described, ", "));
}

const char* unit_of(Dimension dimension)
{
  switch (dimension)
  {
    case Dimension::rate:
      return "1 / time";
    case Dimension::velocity:
      return "length / time";
    case Dimension::length:
      return "length";
    case Dimension::direction:
    case Dimension::number:
    case Dimension::file:
      break;
  }
  return "";
}

/// The member of the scene's flow. What is read goes into the flow that the key `kind` has just
/// made, which nobody else holds yet.
template<class Member>
auto in_flow(Member member)
{
  return [=](auto& scene) -> auto&
  {
    if constexpr (std::is_const_v<std::remove_reference_t<decltype(scene)>>)
      return (*scene.flow).*member;
    else
      return (*std::const_pointer_cast<ImposedFlow>(scene.flow)).*member;
  };
}

SceneKey parameter_key(const FlowParameter& parameter, double ImposedFlow::*member)
{
  return key(parameter.name, in_flow(member),
    rules::Number{ parameter.positive ? positive : any_number }, unit_of(parameter.dimension),
    parameter.help);
}

SceneKey parameter_key(const FlowParameter& parameter, Vector3 ImposedFlow::*member)
{
  if (parameter.dimension == Dimension::direction)
    return key(parameter.name, in_flow(member), rules::Direction{}, "", parameter.help);
  return key(
    parameter.name, in_flow(member), rules::Point{}, unit_of(parameter.dimension), parameter.help);
}

/// Relative to the scene's folder; absolute in memory and as written.
struct FileOf
{
  void read(const TableReader& table, const std::string& key, std::string& target) const
  {
    table.read(key, target);
    if (target.empty())
      table.fail(key, "can't be empty", allowed());
    target = std::filesystem::absolute(table.folder() / target).lexically_normal().string();
  }
  std::string write(const std::string& value) const { return to_toml(value); }
  std::string allowed() const { return "the path of a file"; }
};

SceneKey parameter_key(const FlowParameter& parameter, std::string ImposedFlow::*member)
{
  return key(parameter.name, in_flow(member), FileOf{}, "", parameter.help);
}

/// Rows of a time and a factor.
struct History
{
  using Table = std::vector<std::array<double, 2>>;

  void read(const TableReader& table, const std::string& key, Table& target) const
  {
    target.clear();
    for (const auto& item : table.items(key, table.at(key), 0, allowed()))
    {
      const auto& values = table.items(key, item, 2, allowed());
      target.push_back(
        { table.number(key, values[0], not_negative), table.number(key, values[1], any_number) });
      const std::size_t n = target.size();
      if (n > 1 && target[n - 1][0] < target[n - 2][0])
        table.fail_at(item.where, key,
          fmt::format("goes back from {} to {}", target[n - 2][0], target[n - 1][0]), allowed());
    }
    if (target.empty())
      table.fail(key, "can't be empty", allowed());
  }
  std::string write(const Table& value) const { return value.empty() ? "" : to_toml(value); }
  std::string allowed() const { return "[[time, factor], …] with times >= 0 that don't fall"; }
};

/// How the flow's strength changes with time, of every kind.
std::vector<SceneKey> history_keys()
{
  using H = FlowHistory;
  return {
    key("history", at(&Scene::flow_history, &H::table), History{}, "time, a number",
      "what the flow is multiplied by: linear between the times, constant before and after; two "
      "rows "
      "of one time are a jump")
      .otherwise("1"),
    key("period", at(&Scene::flow_history, &H::period), rules::Number{ positive }, "time",
      "repeats the history, which is then from 0 to here")
      .otherwise("no repetition"),
    key("angular_frequency", at(&Scene::flow_history, &H::angular_frequency),
      rules::Number{ not_negative }, "1 / time", "ω: multiplies the flow by cos ωt")
      .written_if([](const Scene& scene) { return scene.flow_history.angular_frequency > 0; }),
  };
}

// A period has a history, which fits into it.
void check_history(const TableReader& table, const Scene& scene)
{
  const FlowHistory& history = scene.flow_history;
  if (!history.period)
    return;
  if (history.table.empty())
    table.fail("period", "repeats nothing", "a period beside a history, or none");
  if (history.table.back()[0] > *history.period)
    table.fail("period",
      fmt::format("ends before the history's last time, {}", history.table.back()[0]),
      "a number not below the history's last time");
}

std::vector<SceneKey> flow_keys()
{
  std::vector<SceneKey> keys{ kind_key() };
  for (const FlowKind* kind : kinds_by_name())
  {
    for (const FlowParameter& parameter : kind->parameters)
    {
      SceneKey key =
        std::visit([&](auto member) { return parameter_key(parameter, member); }, parameter.member)
          .with({ kind->name });
      keys.push_back(parameter.required ? key.required(parameter.missing) : key);
    }
    if (!kind->type.empty())
      keys.push_back(type_key(kind->name));
  }
  for (const SceneKey& key : history_keys())
    keys.push_back(key);
  return keys;
}

SceneTable::Variant variant_in(const SceneTable& flow, const TableReader& table)
{
  if (!table.has("kind"))
  {
    table.check_keys(flow.names());
    table.fail("kind", "is missing", in_quotes(names()));
  }
  std::string name;
  table.read("kind", name, names());
  return { name, fmt::format("kind = \"{}\"", name) };
}

}

SceneTable flow_table()
{
  SceneTable table;
  table.name = "flow";
  table.help = "The fluid's velocity far away. Without the table it is at rest.";
  table.keys = flow_keys();
  for (const FlowKind* kind : kinds_by_name())
  {
    std::string formulas;
    for (const FlowKind* same : kinds_named(kind->name))
      formulas += (formulas.empty() ? "" : "; ") +
        (same->type.empty() ? same->formula : same->type + ": " + same->formula);
    table.variants.emplace_back(kind->name, formulas);
  }
  table.present = [](const Scene& scene) { return scene.flow != nullptr; };
  table.variant_in = variant_in;
  table.check = check_history;
  table.variant_of = [](const Scene& scene) { return scene.flow->kind().name; };
  table.make_example = [](Scene& scene, const std::string& variant)
  { scene.flow = kinds_named(variant).front()->make(); };
  return table;
}

}
