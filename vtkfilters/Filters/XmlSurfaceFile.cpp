#include "XmlSurfaceFile.h"

#include "XmlArrays.h"
#include "XmlTree.h"

#include "solver/Errors.h"
#include "solver/files/FileBytes.h"
#include "solver/mesh/io/CellTypes.h"
#include "solver/mesh/io/SurfacePieces.h"
#include "solver/mesh/io/TextScanner.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>

namespace vesicle
{
namespace
{

using std::filesystem::path;
using Role = DataArray::Role;

/// One file that has its pieces within.
class XmlSurfaceReader
{
public:
  XmlSurfaceReader(const XmlDocument& document, std::string name)
    : name_(std::move(name)), arrays_(document, name_)
  {
  }

  std::vector<SurfaceFile> pieces(const XmlElement& data_set) const
  {
    std::vector<SurfaceFile> result;
    for (const XmlElement& element : data_set.children)
      if (element.name == "Piece")
        if (auto piece = read_piece(element, data_set.name == "UnstructuredGrid");
            piece.points.rows() > 0 || result.empty())
          result.push_back(std::move(piece));
    if (result.size() > 1 && result[0].points.rows() == 0)
      result.erase(result.begin());
    if (const XmlElement* field = data_set.child("FieldData"); field && !result.empty())
      result[0].field_data = read_fields(*field);
    return result;
  }

private:
  std::int64_t count(const XmlElement& piece, std::string_view attribute) const
  {
    const std::string text = piece.attribute(attribute);
    const auto value = text.empty() ? 0 : number_of<std::int64_t>(text).value_or(-1);
    if (value < 0)
      throw InputError(fmt::format("{}: {} of a piece is '{}'", name_, attribute, text));
    return value;
  }

  SurfaceFile read_piece(const XmlElement& piece, bool is_grid) const
  {
    SurfaceFile file;
    const std::int64_t points = count(piece, "NumberOfPoints");
    read_points(piece, points, file);
    const std::int64_t cells = is_grid ? read_grid(piece, file) : read_polydata(piece, file);
    file.point_data = read_data(piece, "PointData", points);
    file.cell_data = read_data(piece, "CellData", cells);
    return file;
  }

  void read_points(const XmlElement& piece, std::int64_t points, SurfaceFile& file) const
  {
    const XmlElement* element = piece.child("Points");
    const XmlElement* array = element ? element->child("DataArray") : nullptr;
    if (!array && points > 0)
      throw InputError(name_ + ": a piece has no array of points");
    if (!array)
      return;
    const DataArray read = arrays_.read(*array);
    if (read.components != 3)
      arrays_.fail(*array, fmt::format("of points has {} components, not 3", read.components));
    require_tuples(*array, read, points, "points");
    file.points.resize(points, 3);
    std::visit(
      [&](const auto& v)
      {
        using Value = typename std::decay_t<decltype(v)>::value_type;
        file.single_precision = std::is_same_v<Value, float>;
        if constexpr (std::is_arithmetic_v<Value>)
          std::copy(v.begin(), v.end(), file.points.data());
        else
          arrays_.fail(*array, "of points should have numbers");
      },
      read.values);
  }

  void require_tuples(const XmlElement& element, const DataArray& array, std::int64_t needed,
    std::string_view of) const
  {
    const auto values =
      std::visit([](const auto& v) { return static_cast<std::uint64_t>(v.size()); }, array.values);
    const auto width = static_cast<std::uint64_t>(array.components);
    if (values % width != 0 || values / width != static_cast<std::uint64_t>(needed))
      arrays_.fail(element,
        fmt::format(
          "has {} values of {} components for {} {}", values, array.components, needed, of));
  }

  /// Cells as VTK writes them since ever: where each ends among the corners.
  struct CellList
  {
    std::vector<std::int64_t> corners, ends;
    std::span<const std::int64_t> operator[](std::int64_t i) const
    {
      const std::int64_t first = i == 0 ? 0 : ends[i - 1];
      return { corners.data() + first, static_cast<std::size_t>(ends[i] - first) };
    }
  };

  const XmlElement* array_of(const XmlElement& cells, std::string_view array_name) const
  {
    const auto found = std::ranges::find_if(cells.children,
      [&](const XmlElement& c)
      { return c.name == "DataArray" && c.attribute("Name") == array_name; });
    return found == cells.children.end() ? nullptr : &*found;
  }

  CellList read_cells(const XmlElement& piece, std::string_view kind, std::int64_t count) const
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
    check_offsets(
      offsets, static_cast<std::int64_t>(list.corners.size()), std::string(kind), name_);
    return list;
  }

  /// VTK's order of cells, and so of their values: verts, lines, polys, strips.
  std::int64_t read_polydata(const XmlElement& piece, SurfaceFile& file) const
  {
    std::int64_t cells = count(piece, "NumberOfVerts") + count(piece, "NumberOfLines");
    if (cells < 0)
      throw InputError(name_ + ": a piece has more cells than can be");
    const auto polys = count(piece, "NumberOfPolys"), strips = count(piece, "NumberOfStrips");
    const CellList polygons = read_cells(piece, "Polys", polys);
    for (std::int64_t i = 0; i < polys; ++i)
      file.polygons.add(polygons[i], cells + i);
    cells += polys;
    const CellList strip_list = read_cells(piece, "Strips", strips);
    for (std::int64_t i = 0; i < strips; ++i)
      file.polygons.add_strip(strip_list[i], cells + i);
    return cells + strips;
  }

  std::int64_t read_grid(const XmlElement& piece, SurfaceFile& file) const
  {
    const auto cells = count(piece, "NumberOfCells");
    if (cells == 0)
      return 0;
    const CellList list = read_cells(piece, "Cells", cells);
    const XmlElement* element = array_of(*piece.child("Cells"), "types");
    if (!element)
      throw InputError(name_ + ": the cells of a piece lack their types");
    const auto types = arrays_.read_integers(*element);
    if (static_cast<std::int64_t>(types.size()) != cells)
      arrays_.fail(*element, fmt::format("has {} values for {} cells", types.size(), cells));
    for (std::int64_t i = 0; i < cells; ++i)
      add_cell(file.polygons, static_cast<int>(std::clamp<std::int64_t>(types[i], -1, 255)),
        list[i], i, name_);
    return cells;
  }

  std::vector<DataArray> read_data(
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

  /// Packed bits come with those that fill the last byte.
  static void cut_bits(const XmlElement& element, DataArray& array, std::int64_t tuples)
  {
    auto* values = std::get_if<std::vector<std::uint8_t>>(&array.values);
    if (element.attribute("type") != "Bit" || !values)
      return;
    const auto needed = static_cast<std::uint64_t>(tuples) * array.components;
    if (values->size() > needed && values->size() - needed < 8)
      values->resize(needed);
  }

  std::vector<DataArray> read_fields(const XmlElement& field) const
  {
    std::vector<DataArray> result;
    for (const XmlElement& element : field.children)
    {
      if (element.name != "DataArray" && element.name != "Array")
        continue;
      DataArray array = arrays_.read(element);
      const std::string tuples = element.attribute("NumberOfTuples");
      if (!tuples.empty())
      {
        const auto needed = number_of<std::int64_t>(tuples).value_or(-1);
        if (needed < 0)
          arrays_.fail(element, "has no number of tuples");
        cut_bits(element, array, needed);
        require_tuples(element, array, needed, "tuples");
      }
      result.push_back(std::move(array));
    }
    return result;
  }

  std::string name_;
  XmlArrays arrays_;
};

std::vector<SurfaceFile> read_file_with_pieces(const path& file);

/// The files that a .pvtu or .pvtp names, beside it.
std::vector<SurfaceFile> read_piece_files(const XmlElement& data_set, const path& file)
{
  std::vector<SurfaceFile> pieces;
  std::set<path> seen;
  for (const XmlElement& element : data_set.children)
  {
    if (element.name != "Piece")
      continue;
    const path source = file.parent_path() / element.attribute("Source");
    if (element.attribute("Source").empty())
      throw InputError(file.string() + ": a piece names no file");
    if (!seen.insert(source.lexically_normal()).second)
      throw InputError(
        fmt::format("{}: the piece {} is there twice", file.string(), element.attribute("Source")));
    if (!is_file(source))
      throw InputError(fmt::format(
        "{}: its piece {} is missing; bring it beside this file", file.string(), source.string()));
    for (SurfaceFile& piece : read_file_with_pieces(source))
      if (piece.points.rows() > 0)
        pieces.push_back(std::move(piece));
  }
  return pieces;
}

std::vector<SurfaceFile> read_file_with_pieces(const path& file)
{
  const std::string bytes = read_file(file), name = file.string();
  const XmlDocument document = parse_vtk_xml(bytes, name);
  const std::string type = document.root.attribute("type");
  const XmlElement* data_set = document.root.child(type);
  if (type != "PolyData" && type != "UnstructuredGrid")
    throw InputError(fmt::format("{}: holds '{}', a surface is PolyData or UnstructuredGrid "
                                 "(vtkDataSetSurfaceFilter, ParaView's Extract Surface, makes one)",
      name, type));
  if (!data_set)
    throw InputError(fmt::format("{}: has no element {}", name, type));
  return XmlSurfaceReader(document, name).pieces(*data_set);
}

}

SurfaceFile read_xml_surface(const path& file)
{
  const std::string name = file.string();
  const std::string ending = file.extension().string();
  const bool names_pieces = ending.size() > 1 && (ending[1] == 'p' || ending[1] == 'P');
  if (!names_pieces)
    return joined(read_file_with_pieces(file), name);
  const std::string bytes = read_file(file);
  const XmlDocument document = parse_vtk_xml(bytes, name);
  const std::string type = document.root.attribute("type");
  const XmlElement* data_set = document.root.child(type);
  if ((type != "PPolyData" && type != "PUnstructuredGrid") || !data_set)
    throw InputError(fmt::format("{}: holds '{}', not the pieces of a surface", name, type));
  return joined(read_piece_files(*data_set, file), name);
}

}
