#pragma once
// What the file of a grid holds, in which fields live, as all readers give it. Whoever follows its numbers
// checks them first.

#include "solver/mesh/io/SurfaceFile.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace vesicle
{

struct GridFile
{
  enum class Kind
  {
    image,
    rectilinear,
    structured,
    unstructured
  };

  Kind kind = Kind::unstructured;
  /// Of all but unstructured ones: first and last number of the points along x, y, z.
  std::array<int, 6> extent{ 0, -1, 0, -1, 0, -1 };
  /// Of images: where number 0 is, steps along the axes, the axes as columns, row by row.
  std::array<double, 3> origin{ 0, 0, 0 }, spacing{ 1, 1, 1 };
  std::array<double, 9> axes{ 1, 0, 0, 0, 1, 0, 0, 0, 1 };
  std::array<std::vector<double>, 3> coordinates; ///< of rectilinear ones
  Points points;                                  ///< of the others
  /// Of unstructured ones: VTK's numbers of their forms, and where each begins among the corners.
  std::vector<std::int64_t> types, offsets{ 0 }, corners;
  /// Polyhedra's faces as VTK stores them: number of faces, and of each the number of its points and these. Of
  /// each cell where its own begin, −1: it has none; empty: none has.
  std::vector<std::int64_t> faces, first_face;
  std::vector<DataArray> point_data, cell_data;
};

/// Points of an extent, and cells, of which an axis with one point has one, too. Throw InputError "name: …"
/// where there can't be so many.
std::int64_t points_in(const std::array<int, 6>& extent, const std::string& name);
std::int64_t cells_in(const std::array<int, 6>& extent, const std::string& name);

}
