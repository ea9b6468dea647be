#include "solver/scene/SceneUnits.h"

#include "solver/Errors.h"
#include "solver/scene/Quantity.h"
#include "solver/scene/SceneSchema.h"
#include "solver/scene/TableReader.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace vesicle
{
namespace
{

/// What a key measures; empty where it has no dimension or is unknown.
Dimensions dimensions_of_key(const std::string& table, const std::string& name)
{
  for (const SceneTable& candidate : scene_schema())
    for (const SceneKey& key : candidate.keys)
      if (candidate.name == table && key.name == name)
        return dimensions_of(key.unit);
  return {};
}

/// Converts the values of one key after another, and remembers what it met.
class Converter
{
public:
  Converter(const SceneDocument& document, double temperature)
    : document_(document), temperature_(temperature)
  {
  }

  void convert(SceneDocument::Entry& entry)
  {
    const Dimensions dimensions = dimensions_of_key(entry.table, entry.key);
    if (!dimensions.empty())
      convert(entry, entry.value, dimensions, 0);
  }

  bool has_units() const { return !with_unit_.empty(); }

  /// Of the first number that lacks a unit, if there is one.
  void require_no_plain_number() const
  {
    if (plain_)
      fail(*plain_, plain_->value.where, fmt::format("has no unit, and '{}' has one", with_unit_),
        fmt::format("\"{}\" or the like, or units = \"SI\" at the top for plain numbers in SI",
          example_of(plain_dimension_)));
  }

private:
  void convert(const SceneDocument::Entry& entry, SceneValue& value, const Dimensions& dimensions,
    std::size_t place)
  {
    const PhysicalDimension dimension = dimensions[std::min(place, dimensions.size() - 1)];
    if (auto* items = std::get_if<SceneValue::Array>(&value.data))
      for (std::size_t i = 0; i < items->size(); ++i)
        convert(entry, (*items)[i], dimensions, i);
    else if (const auto* text = std::get_if<std::string>(&value.data);
             text && is_like_a_quantity(*text))
      value.data = in_si(entry, value.where, *text, dimension);
    else if (is_plain(value) && dimension != PhysicalDimension{} && !plain_)
    {
      plain_ = entry;
      plain_dimension_ = dimension;
    }
  }

  double in_si(const SceneDocument::Entry& entry, const std::string& where, const std::string& text,
    const PhysicalDimension& dimension)
  {
    const std::string allowed = dimension == PhysicalDimension{}
      ? std::string("a number without a unit")
      : fmt::format("\"{}\" or the like", example_of(dimension));
    try
    {
      const Quantity quantity = parse_quantity(text, temperature_);
      if (quantity.dimension != dimension)
        fail(entry, where, fmt::format("\"{}\" measures something else", text), allowed);
      if (with_unit_.empty())
        with_unit_ = entry.shown.empty() ? entry.key : entry.shown + "." + entry.key;
      return quantity.value;
    }
    catch (const QuantityError& error)
    {
      fail(entry, where, error.what(), allowed);
    }
  }

  static bool is_plain(const SceneValue& value)
  {
    const auto* integer = std::get_if<std::int64_t>(&value.data);
    const auto* real = std::get_if<double>(&value.data);
    return (integer && *integer != 0) || (real && *real != 0);
  }

  [[noreturn]] void fail(const SceneDocument::Entry& entry, const std::string& where,
    const std::string& problem, const std::string& allowed) const
  {
    TableReader(document_, entry.table).fail_at(where, entry.key, problem, allowed);
  }

  const SceneDocument& document_; ///< for messages
  double temperature_;
  std::string with_unit_; ///< the first key that has one
  std::optional<SceneDocument::Entry> plain_;
  PhysicalDimension plain_dimension_;
};

/// fluid.temperature, of which kT is made, in K.
double temperature_of(SceneDocument document)
{
  const double room = Scene::Fluid{}.temperature;
  Converter converter(document, room);
  for (auto& entry : document.entries)
    if (entry.table == "fluid" && entry.key == "temperature")
      converter.convert(entry);
  double temperature = room;
  TableReader(document, "fluid").read("temperature", temperature, positive);
  return temperature;
}

/// 1 m and 1 Pa s, which these have where they are left out, are never meant.
void require_scales(const SceneDocument& document)
{
  for (std::size_t v = 0; v < document.vesicles.size(); ++v)
  {
    const SceneDocument own = document.of_vesicle(v);
    if (own.find("vesicle", "shape"))
      TableReader(own, "vesicle").require("radius", "the radius r0 with its unit: \"10 um\"");
    TableReader(own, "fluid").require("viscosity", "that of the fluid with its unit: \"1 mPa s\"");
  }
}

}

void convert_units(SceneDocument& document)
{
  const SceneDocument original = document;
  Converter converter(original, temperature_of(document));
  for (auto& entry : document.entries)
    converter.convert(entry);
  for (auto& vesicle : document.vesicles)
    for (auto& entry : vesicle.entries)
      converter.convert(entry);
  const TableReader top(document, "");
  Units units = Units::any;
  top.read("units", units, units_names);
  if (converter.has_units() && units != Units::si)
  {
    if (top.has("units"))
      top.fail("units", "contradicts the units of its values", "\"SI\"");
    converter.require_no_plain_number();
    document.entries.push_back({ "", "units", { std::string("SI"), document.name, "" }, "" });
    units = Units::si;
  }
  if (units == Units::si)
    require_scales(document);
}

}
