#include "XmlSurfaceFile.h"

#include "XmlPieces.h"
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

/// One file that has its pieces within.
class XmlSurfaceReader : XmlPieces
{
public:
  using XmlPieces::XmlPieces;

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
  SurfaceFile read_piece(const XmlElement& piece, bool is_grid) const
  {
    SurfaceFile file;
    const std::int64_t points = count(piece, "NumberOfPoints");
    file.single_precision = read_points(piece, points, file.points);
    const std::int64_t cells = is_grid ? read_grid(piece, file) : read_polydata(piece, file);
    file.point_data = read_data(piece, "PointData", points);
    file.cell_data = read_data(piece, "CellData", cells);
    return file;
  }

  /// VTK's order of cells, and so of their values: verts, lines, polys, strips.
  std::int64_t read_polydata(const XmlElement& piece, SurfaceFile& file) const
  {
    std::int64_t cells = count(piece, "NumberOfVerts") + count(piece, "NumberOfLines");
    if (cells < 0)
      throw InputError(name() + ": a piece has more cells than can be");
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
    const auto types = read_types(piece, cells);
    for (std::int64_t i = 0; i < cells; ++i)
      add_cell(file.polygons, static_cast<int>(std::clamp<std::int64_t>(types[i], -1, 255)),
        list[i], i, name());
    return cells;
  }

  std::vector<DataArray> read_fields(const XmlElement& field) const
  {
    std::vector<DataArray> result;
    for (const XmlElement& element : field.children)
    {
      if (element.name != "DataArray" && element.name != "Array")
        continue;
      DataArray array = arrays().read(element);
      const std::string tuples = element.attribute("NumberOfTuples");
      if (!tuples.empty())
      {
        const auto needed = number_of<std::int64_t>(tuples).value_or(-1);
        if (needed < 0)
          arrays().fail(element, "has no number of tuples");
        cut_bits(element, array, needed);
        require_tuples(element, array, needed, "tuples");
      }
      result.push_back(std::move(array));
    }
    return result;
  }
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
