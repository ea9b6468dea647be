#include "solver/mesh/io/CellTypes.h"

#include "solver/Errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace vesicle
{
namespace
{

struct CellType
{
  int number;
  std::string_view name;
};

// vtkCellType.h
constexpr std::array other_types{ CellType{ 10, "tetrahedron" }, CellType{ 11, "voxel" },
  CellType{ 12, "hexahedron" }, CellType{ 13, "wedge" }, CellType{ 14, "pyramid" },
  CellType{ 15, "pentagonal prism" }, CellType{ 16, "hexagonal prism" },
  CellType{ 21, "quadratic edge" }, CellType{ 22, "quadratic triangle" },
  CellType{ 23, "quadratic quadrilateral" }, CellType{ 24, "quadratic tetrahedron" },
  CellType{ 25, "quadratic hexahedron" }, CellType{ 26, "quadratic wedge" },
  CellType{ 27, "quadratic pyramid" }, CellType{ 28, "biquadratic quadrilateral" },
  CellType{ 29, "triquadratic hexahedron" }, CellType{ 30, "quadratic linear quadrilateral" },
  CellType{ 31, "quadratic linear wedge" }, CellType{ 32, "biquadratic quadratic wedge" },
  CellType{ 33, "biquadratic quadratic hexahedron" }, CellType{ 34, "biquadratic triangle" },
  CellType{ 35, "cubic line" }, CellType{ 36, "quadratic polygon" },
  CellType{ 37, "triquadratic pyramid" }, CellType{ 41, "convex point set" },
  CellType{ 42, "polyhedron" }, CellType{ 51, "parametric curve" },
  CellType{ 52, "parametric surface" }, CellType{ 53, "parametric triangular surface" },
  CellType{ 54, "parametric quadrilateral surface" },
  CellType{ 55, "parametric tetrahedral region" }, CellType{ 56, "parametric hexahedral region" },
  CellType{ 60, "higher-order edge" }, CellType{ 61, "higher-order triangle" },
  CellType{ 62, "higher-order quadrilateral" }, CellType{ 63, "higher-order polygon" },
  CellType{ 64, "higher-order tetrahedron" }, CellType{ 65, "higher-order wedge" },
  CellType{ 66, "higher-order pyramid" }, CellType{ 67, "higher-order hexahedron" },
  CellType{ 68, "Lagrange curve" }, CellType{ 69, "Lagrange triangle" },
  CellType{ 70, "Lagrange quadrilateral" }, CellType{ 71, "Lagrange tetrahedron" },
  CellType{ 72, "Lagrange hexahedron" }, CellType{ 73, "Lagrange wedge" },
  CellType{ 74, "Lagrange pyramid" }, CellType{ 75, "Bézier curve" },
  CellType{ 76, "Bézier triangle" }, CellType{ 77, "Bézier quadrilateral" },
  CellType{ 78, "Bézier tetrahedron" }, CellType{ 79, "Bézier hexahedron" },
  CellType{ 80, "Bézier wedge" }, CellType{ 81, "Bézier pyramid" } };

[[noreturn]] void refuse(int type, std::int64_t cell, const std::string& name)
{
  const auto found = std::ranges::find(other_types, type, &CellType::number);
  if (found == other_types.end())
    throw InputError(
      fmt::format("{}: cell {} has the type {}, which VTK doesn't have", name, cell, type));
  throw InputError(fmt::format("{}: cell {} is a {} (VTK's cell type {}), not a flat polygon; take "
                               "the surface first, as linear triangles (vtkDataSetSurfaceFilter, "
                               "ParaView's Extract Surface)",
    name, cell, found->name, type));
}

}

void add_cell(PolygonList& polygons, int type, std::span<const std::int64_t> corners,
  std::int64_t cell, const std::string& name)
{
  const auto require = [&](std::size_t count, std::string_view kind)
  {
    if (corners.size() != count)
      throw InputError(fmt::format("{}: cell {}, a {}, has {} corners instead of {}", name, cell,
        kind, corners.size(), count));
  };
  switch (type)
  {
    case 0: // empty
    case 1: // vertex
    case 2: // poly-vertex
    case 3: // line
    case 4: // poly-line
      return;
    case 5:
      require(3, "triangle");
      return polygons.add(corners, cell);
    case 6:
      return polygons.add_strip(corners, cell);
    case 7:
      return polygons.add(corners, cell);
    case 8: // whose corners go row by row
      require(4, "pixel");
      return polygons.add(std::array{ corners[0], corners[1], corners[3], corners[2] }, cell);
    case 9:
      require(4, "quadrilateral");
      return polygons.add(corners, cell);
    default:
      refuse(type, cell, name);
  }
}

}
