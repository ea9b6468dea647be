#include "solver/mesh/PolygonMesh.h"

#include "solver/Errors.h"

#include <fmt/format.h>

#include <limits>

namespace vesicle
{

void PolygonList::close(std::int64_t from_cell)
{
  offsets.push_back(static_cast<std::int64_t>(corners.size()));
  cell.push_back(from_cell);
}

void PolygonList::add(std::span<const std::int64_t> polygon, std::int64_t from_cell)
{
  corners.insert(corners.end(), polygon.begin(), polygon.end());
  close(from_cell);
}

void PolygonList::add_strip(std::span<const std::int64_t> strip, std::int64_t from_cell)
{
  for (std::size_t i = 2; i < strip.size(); ++i)
  {
    const std::int64_t turn = i % 2;
    corners.insert(corners.end(), { strip[i - 2 + turn], strip[i - 1 - turn], strip[i] });
    close(from_cell);
  }
}

void check_points(const Points& points, const std::string& name)
{
  if (points.rows() >= std::numeric_limits<int>::max())
    throw InputError(fmt::format("{}: {} points are more than a mesh here can have, {}", name,
      points.rows(), std::numeric_limits<int>::max()));
  const auto usable = [](const auto& x)
  { return x.allFinite() && (x.array().abs() <= greatest_coordinate).all(); };
  if (usable(points))
    return;
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    if (!usable(points.row(i)))
      throw InputError(
        fmt::format("{}: point {} is ({}, {}, {}): coordinates must be finite numbers, up to {} in "
                    "size; check the file, or choose another unit of length",
          name, i, points(i, 0), points(i, 1), points(i, 2), greatest_coordinate));
  }
}

void check_corners(const PolygonList& polygons, std::int64_t points, const std::string& name,
  int first, const std::string& what)
{
  for (std::int64_t i = 0; i < polygons.size(); ++i)
  {
    for (const std::int64_t corner : polygons[i])
    {
      if (corner >= 0 && corner < points)
        continue;
      const std::string use =
        fmt::format("{}: {} {} uses point {}, but ", name, what, i + first, corner + first);
      throw InputError(use +
        (points == 0 ? "there are no points"
                     : fmt::format("the points are numbered {} to {}", first, points - 1 + first)));
    }
  }
}

void check_offsets(std::span<const std::int64_t> offsets, std::int64_t corners,
  const std::string& what, const std::string& name)
{
  if (offsets.empty() && corners > 0)
    throw InputError(
      fmt::format("{}: {} corners of the {} are listed, but no offsets", name, corners, what));
  for (std::size_t i = 0; i < offsets.size(); ++i)
  {
    const std::int64_t least = i == 0 ? 0 : offsets[i - 1];
    if (offsets[i] < least || offsets[i] > corners || (i == 0 && offsets[i] != 0))
      throw InputError(fmt::format(
        "{}: offset {} of the {} is {}, which should lie between {} and {}, the number of corners",
        name, i, what, offsets[i], least, i == 0 ? 0 : corners));
  }
  if (!offsets.empty() && offsets.back() != corners)
    throw InputError(fmt::format("{}: the {} end at corner {}, but {} corners are listed", name,
      what, offsets.back(), corners));
}

}
