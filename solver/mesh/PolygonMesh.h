#pragma once
// A surface of polygons as files and pipelines bring it, and the one place where its numbers are
// checked before anything follows them.

#include "solver/mesh/TriangleMesh.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace vesicle
{

/// Lists of point numbers. Polygon i also has the number of the cell that it came from, so that
/// the values of cells find their polygons again where other cells were left out.
struct PolygonList
{
  std::vector<std::int64_t> offsets{ 0 }; ///< #polygons + 1: where each begins among the corners
  std::vector<std::int64_t> corners;
  std::vector<std::int64_t> cell; ///< #polygons

  std::int64_t size() const { return static_cast<std::int64_t>(cell.size()); }
  std::span<const std::int64_t> operator[](std::int64_t i) const
  {
    return { corners.data() + offsets[i], static_cast<std::size_t>(offsets[i + 1] - offsets[i]) };
  }
  /// The corners added since the last polygon become one.
  void close(std::int64_t from_cell);
  void add(std::span<const std::int64_t> polygon, std::int64_t from_cell);
  /// A strip's triangles, each second one turned so that all face the same way.
  void add_strip(std::span<const std::int64_t> strip, std::int64_t from_cell);
};

/// The third power of an area, which the reduced volume takes, is then still a number.
inline constexpr double greatest_coordinate = 1e50;

/// Throws InputError "name: …" with the point unless there are at most as many as triangle meshes
/// can number and all coordinates are finite, none beyond greatest_coordinate.
void check_points(const Points& points, const std::string& name);

/// Throws InputError "name: face i uses point j, …" unless all corners are among the points; faces
/// and points are counted from `first`, as the user's file does. `what` is one of the polygons.
void check_corners(const PolygonList& polygons, std::int64_t points, const std::string& name,
  int first = 0, const std::string& what = "face");

/// Throws InputError unless offsets, as VTK's cell arrays have them, start at 0, don't descend and
/// end at the number of corners; where there are no cells they may be missing. `what` names the
/// cells: "polygons".
void check_offsets(std::span<const std::int64_t> offsets, std::int64_t corners,
  const std::string& what, const std::string& name);

}
