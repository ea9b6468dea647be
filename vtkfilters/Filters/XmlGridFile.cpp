#include "XmlGridFile.h"

#include "XmlPieces.h"
#include "XmlTree.h"

#include "solver/Errors.h"
#include "solver/files/FileBytes.h"
#include "solver/mesh/io/TextScanner.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace vesicle
{
namespace
{

using Kind = GridFile::Kind;

class XmlGridReader : XmlPieces
{
public:
  using XmlPieces::XmlPieces;

  GridFile read(const XmlElement& data_set, Kind kind) const
  {
    GridFile grid;
    grid.kind = kind;
    const XmlElement* piece = only_piece(data_set, kind);
    if (!piece)
      return grid;
    std::int64_t points = 0, cells = 0;
    if (kind == Kind::unstructured)
    {
      points = count(*piece, "NumberOfPoints");
      cells = count(*piece, "NumberOfCells");
      read_points(*piece, points, grid.points);
      read_cells_of(*piece, cells, grid);
    }
    else
    {
      grid.extent = numbers<int, 6>(*piece, "Extent").value_or(grid.extent);
      points = points_in(grid.extent, name());
      cells = cells_in(grid.extent, name());
      read_places(data_set, *piece, points, grid);
    }
    grid.point_data = read_data(*piece, "PointData", points);
    grid.cell_data = read_data(*piece, "CellData", cells);
    return grid;
  }

private:
  /// That has points; nullptr: none has.
  const XmlElement* only_piece(const XmlElement& data_set, Kind kind) const
  {
    const XmlElement* only = nullptr;
    for (const XmlElement& piece : data_set.children)
    {
      if (piece.name != "Piece" ||
        (kind == Kind::unstructured && count(piece, "NumberOfPoints") == 0))
        continue;
      if (only)
        throw InputError(name() + ": comes in several pieces; write it in one");
      only = &piece;
    }
    return only;
  }

  /// Empty: there is no such attribute.
  template<class Number, std::size_t size>
  std::optional<std::array<Number, size>> numbers(
    const XmlElement& element, const char* attribute) const
  {
    const std::string text = element.attribute(attribute);
    if (text.empty())
      return {};
    TextScanner scanner(text, fmt::format("{}: {}", name(), attribute));
    std::array<Number, size> result;
    for (Number& number : result)
      number = scanner.number<Number>("a number");
    if (!scanner.word().empty())
      scanner.fail(fmt::format("{} numbers should be here", size));
    return result;
  }

  void read_places(
    const XmlElement& data_set, const XmlElement& piece, std::int64_t points, GridFile& grid) const
  {
    if (grid.kind == Kind::image)
    {
      grid.origin = numbers<double, 3>(data_set, "Origin").value_or(grid.origin);
      grid.spacing = numbers<double, 3>(data_set, "Spacing").value_or(grid.spacing);
      grid.axes = numbers<double, 9>(data_set, "Direction").value_or(grid.axes);
    }
    else if (grid.kind == Kind::structured)
      read_points(piece, points, grid.points);
    else
      read_coordinates(piece, grid);
  }

  void read_coordinates(const XmlElement& piece, GridFile& grid) const
  {
    const XmlElement* coordinates = piece.child("Coordinates");
    std::size_t axis = 0;
    if (coordinates)
      for (const XmlElement& element : coordinates->children)
        if (element.name == "DataArray" && axis < 3)
        {
          const DataArray read = arrays().read(element);
          std::vector<double>& along = grid.coordinates[axis++];
          along.resize(read.tuples());
          if (read.components != 1 || !copy_numbers(read.values, along.data()))
            arrays().fail(element, "of coordinates should have numbers");
        }
    if (axis < 3)
      throw InputError(name() + ": a rectilinear grid has coordinates along three axes");
  }

  void read_cells_of(const XmlElement& piece, std::int64_t cells, GridFile& grid) const
  {
    if (cells == 0)
      return;
    CellList list = read_cells(piece, "Cells", cells);
    grid.corners = std::move(list.corners);
    grid.offsets.insert(grid.offsets.end(), list.ends.begin(), list.ends.end());
    grid.types = read_types(piece, cells);
    read_faces(*piece.child("Cells"), grid);
  }

  /// A file says where those of a cell end.
  void read_faces(const XmlElement& cells, GridFile& grid) const
  {
    const XmlElement *faces = array_of(cells, "faces"), *ends = array_of(cells, "faceoffsets");
    if (!faces || !ends)
      return;
    grid.faces = arrays().read_integers(*faces);
    std::int64_t begin = 0;
    for (const std::int64_t end : arrays().read_integers(*ends))
    {
      grid.first_face.push_back(end < 0 ? -1 : begin);
      begin = std::max(begin, end);
    }
  }
};

}

GridFile read_xml_grid(const std::filesystem::path& file)
{
  static constexpr std::array kinds{ std::pair{ "ImageData", Kind::image },
    std::pair{ "RectilinearGrid", Kind::rectilinear },
    std::pair{ "StructuredGrid", Kind::structured },
    std::pair{ "UnstructuredGrid", Kind::unstructured } };
  const std::string bytes = read_file(file), name = file.string();
  const XmlDocument document = parse_vtk_xml(bytes, name);
  const std::string type = document.root.attribute("type");
  const auto kind = std::ranges::find(kinds, type, [](const auto& k) { return k.first; });
  if (kind == kinds.end())
    throw InputError(
      fmt::format("{}: holds '{}'; a field lives in an image or a grid", name, type));
  const XmlElement* data_set = document.root.child(type);
  if (!data_set)
    throw InputError(fmt::format("{}: has no element {}", name, type));
  return XmlGridReader(document, name).read(*data_set, kind->second);
}

}
