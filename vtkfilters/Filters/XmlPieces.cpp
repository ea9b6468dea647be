#include "XmlPieces.h"

#include "solver/Errors.h"
#include "solver/mesh/PolygonMesh.h"
#include "solver/mesh/io/TextScanner.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace vesicle
{

using Role = DataArray::Role;

XmlPieces::XmlPieces(const XmlDocument& document, std::string name)
  : name_(std::move(name)), arrays_(document, name_)
{
}

std::int64_t XmlPieces::count(const XmlElement& piece, std::string_view attribute) const
{
  const std::string text = piece.attribute(attribute);
  const auto value = text.empty() ? 0 : number_of<std::int64_t>(text).value_or(-1);
  if (value < 0)
    throw InputError(fmt::format("{}: {} of a piece is '{}'", name_, attribute, text));
  return value;
}

bool XmlPieces::read_points(const XmlElement& piece, std::int64_t count, Points& points) const
{
  const XmlElement* element = piece.child("Points");
  const XmlElement* array = element ? element->child("DataArray") : nullptr;
  if (!array && count > 0)
    throw InputError(name_ + ": a piece has no array of points");
  if (!array)
    return false;
  const DataArray read = arrays_.read(*array);
  if (read.components != 3)
    arrays_.fail(*array, fmt::format("of points has {} components, not 3", read.components));
  require_tuples(*array, read, count, "points");
  points.resize(count, 3);
  if (!copy_numbers(read.values, points.data()))
    arrays_.fail(*array, "of points should have numbers");
  return std::holds_alternative<std::vector<float>>(read.values);
}

void XmlPieces::require_tuples(
  const XmlElement& element, const DataArray& array, std::int64_t needed, std::string_view of) const
{
  const auto values =
    std::visit([](const auto& v) { return static_cast<std::uint64_t>(v.size()); }, array.values);
  const auto width = static_cast<std::uint64_t>(array.components);
  if (values % width != 0 || values / width != static_cast<std::uint64_t>(needed))
    arrays_.fail(element,
      fmt::format(
        "has {} values of {} components for {} {}", values, array.components, needed, of));
}

const XmlElement* XmlPieces::array_of(const XmlElement& cells, std::string_view array_name)
{
  const auto found = std::ranges::find_if(cells.children,
    [&](const XmlElement& c)
    { return c.name == "DataArray" && c.attribute("Name") == array_name; });
  return found == cells.children.end() ? nullptr : &*found;
}

XmlPieces::CellList XmlPieces::read_cells(
  const XmlElement& piece, std::string_view kind, std::int64_t count) const
{
  if (count == 0)
    return {};
  const XmlElement* cells = piece.child(kind);
  const XmlElement* corners = cells ? array_of(*cells, "connectivity") : nullptr;
  const XmlElement* ends = cells ? array_of(*cells, "offsets") : nullptr;
  if (!corners || !ends)
    throw InputError(fmt::format("{}: {} of a piece lack connectivity or offsets", name_, kind));
  CellList list{ arrays_.read_integers(*corners), arrays_.read_integers(*ends) };
  if (static_cast<std::int64_t>(list.ends.size()) != count)
    arrays_.fail(*ends, fmt::format("has {} values for {} cells", list.ends.size(), count));
  std::vector<std::int64_t> offsets{ 0 };
  offsets.insert(offsets.end(), list.ends.begin(), list.ends.end());
  check_offsets(offsets, static_cast<std::int64_t>(list.corners.size()), std::string(kind), name_);
  return list;
}

std::vector<std::int64_t> XmlPieces::read_types(const XmlElement& piece, std::int64_t count) const
{
  const XmlElement* cells = piece.child("Cells");
  const XmlElement* element = cells ? array_of(*cells, "types") : nullptr;
  if (!element)
    throw InputError(name_ + ": the cells of a piece lack their types");
  auto types = arrays_.read_integers(*element);
  if (static_cast<std::int64_t>(types.size()) != count)
    arrays_.fail(*element, fmt::format("has {} values for {} cells", types.size(), count));
  return types;
}

std::vector<DataArray> XmlPieces::read_data(
  const XmlElement& piece, std::string_view kind, std::int64_t tuples) const
{
  static constexpr std::array roles{ std::pair{ "Scalars", Role::scalars },
    std::pair{ "Vectors", Role::vectors }, std::pair{ "Normals", Role::normals },
    std::pair{ "TCoords", Role::texture_coordinates }, std::pair{ "Tensors", Role::tensors },
    std::pair{ "GlobalIds", Role::global_ids }, std::pair{ "PedigreeIds", Role::pedigree_ids } };
  std::vector<DataArray> result;
  const XmlElement* data = piece.child(kind);
  if (!data)
    return result;
  for (const XmlElement& element : data->children)
  {
    if (element.name != "DataArray" && element.name != "Array")
      continue;
    DataArray array = arrays_.read(element);
    cut_bits(element, array, tuples);
    require_tuples(element, array, tuples, kind == "PointData" ? "points" : "cells");
    for (const auto& [attribute, role] : roles)
      if (!array.name.empty() && data->attribute(attribute) == array.name)
        array.role = role;
    result.push_back(std::move(array));
  }
  return result;
}

void XmlPieces::cut_bits(const XmlElement& element, DataArray& array, std::int64_t tuples)
{
  auto* values = std::get_if<std::vector<std::uint8_t>>(&array.values);
  if (element.attribute("type") != "Bit" || !values)
    return;
  const auto needed = static_cast<std::uint64_t>(tuples) * array.components;
  if (values->size() > needed && values->size() - needed < 8)
    values->resize(needed);
}

}
