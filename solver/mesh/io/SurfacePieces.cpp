#include "solver/mesh/io/SurfacePieces.h"

#include "solver/mesh/io/PointNumbers.h"

#include <algorithm>
#include <type_traits>

namespace vesicle
{
namespace
{

const DataArray* find(const std::vector<DataArray>& arrays, const std::string& name)
{
  const auto found = std::ranges::find(arrays, name, &DataArray::name);
  return found == arrays.end() ? nullptr : &*found;
}

/// The marks of all points or cells; none where nothing is marked.
std::vector<int> marks(const std::vector<DataArray>& arrays)
{
  const DataArray* array = find(arrays, ghost_array);
  if (!array || array->components != 1)
    return {};
  return std::visit(
    [](const auto& values)
    {
      std::vector<int> result;
      if constexpr (std::is_integral_v<typename std::decay_t<decltype(values)>::value_type>)
        for (const auto value : values)
          result.push_back(static_cast<int>(value & 0xff));
      return result;
    },
    array->values);
}

bool is_marked(const std::vector<int>& marks, std::int64_t i, int mask)
{
  return i < static_cast<std::int64_t>(marks.size()) && (marks[i] & mask) != 0;
}

/// A tuple of a piece.
struct Place
{
  std::size_t piece;
  std::int64_t tuple;
};

/// The arrays that all pieces have, their tuples taken from `places`.
std::vector<DataArray> gathered(const std::vector<SurfaceFile>& pieces,
  std::vector<DataArray> SurfaceFile::*kind, const std::vector<Place>& places)
{
  std::vector<DataArray> result;
  for (const DataArray& model : pieces[0].*kind)
  {
    std::vector<const DataArray*> parts;
    for (const SurfaceFile& piece : pieces)
    {
      const DataArray* part = find(piece.*kind, model.name);
      if (part && part->components == model.components &&
        part->values.index() == model.values.index())
        parts.push_back(part);
    }
    if (parts.size() < pieces.size() || model.name == ghost_array)
      continue;
    DataArray array{ model.name, model.components, {}, model.role, model.component_names,
      model.ids };
    std::visit(
      [&](const auto& first)
      {
        using Vector = std::decay_t<decltype(first)>;
        Vector all;
        all.reserve(places.size() * model.components);
        for (const auto& [piece, tuple] : places)
        {
          const auto from =
            std::get<Vector>(parts[piece]->values).begin() + tuple * model.components;
          all.insert(all.end(), from, from + model.components);
        }
        array.values = std::move(all);
      },
      model.values);
    result.push_back(std::move(array));
  }
  return result;
}

}

SurfaceFile joined(std::vector<SurfaceFile> pieces, const std::string& name)
{
  if (pieces.size() == 1)
    return std::move(pieces[0]);
  SurfaceFile whole;
  if (pieces.empty())
    return whole;
  whole.single_precision = true;
  PointNumbers numbers;
  std::vector<Place> points, cells;
  std::vector<bool> is_owned;
  for (std::size_t p = 0; p < pieces.size(); ++p)
  {
    const SurfaceFile& piece = pieces[p];
    check_corners(piece.polygons, piece.points.rows(), name);
    whole.single_precision = whole.single_precision && piece.single_precision;
    const auto point_marks = marks(piece.point_data), cell_marks = marks(piece.cell_data);
    std::vector<std::int64_t> number(piece.points.rows());
    for (Eigen::Index i = 0; i < piece.points.rows(); ++i)
    {
      const bool owned = !is_marked(point_marks, i, duplicate_point);
      const auto [n, is_new] =
        numbers.number({ piece.points(i, 0), piece.points(i, 1), piece.points(i, 2) });
      number[i] = n;
      if (is_new)
      {
        points.push_back({ p, i });
        is_owned.push_back(owned);
      }
      else if (owned && !is_owned[n])
      {
        points[n] = { p, i };
        is_owned[n] = true;
      }
    }
    for (std::int64_t c = 0; c < piece.polygons.size(); ++c)
    {
      if (is_marked(cell_marks, piece.polygons.cell[c], duplicate_cell | hidden_cell))
        continue;
      for (const std::int64_t corner : piece.polygons[c])
        whole.polygons.corners.push_back(number[corner]);
      whole.polygons.close(static_cast<std::int64_t>(cells.size()));
      cells.push_back({ p, piece.polygons.cell[c] });
    }
  }
  whole.points = numbers.points();
  whole.point_data = gathered(pieces, &SurfaceFile::point_data, points);
  whole.cell_data = gathered(pieces, &SurfaceFile::cell_data, cells);
  whole.field_data = std::move(pieces[0].field_data);
  return whole;
}

}
