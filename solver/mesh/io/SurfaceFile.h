#pragma once
// What the file of a surface holds, in the types that the file has, as all readers give it.

#include "solver/mesh/PolygonMesh.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace vesicle
{

/// Values of points, cells or the file as a whole.
struct DataArray
{
  using Values = std::variant<std::vector<char>, std::vector<std::int8_t>,
    std::vector<std::uint8_t>, std::vector<std::int16_t>, std::vector<std::uint16_t>,
    std::vector<std::int32_t>, std::vector<std::uint32_t>, std::vector<std::int64_t>,
    std::vector<std::uint64_t>, std::vector<float>, std::vector<double>, std::vector<std::string>>;
  /// What the file says that the array is for.
  enum class Role
  {
    none,
    scalars,
    vectors,
    normals,
    texture_coordinates,
    tensors,
    global_ids,
    pedigree_ids,
    edge_flags
  };

  std::string name;
  int components = 1;
  Values values; ///< all components of a tuple one after the other
  Role role = Role::none;
  std::vector<std::string> component_names; ///< none, or one a component
  bool ids = false;                         ///< 64-bit integers that VTK calls vtkIdType

  std::int64_t tuples() const
  {
    return std::visit([](const auto& v) { return static_cast<std::int64_t>(v.size()); }, values) /
      components;
  }
};

/// False where they are text.
template<class To>
bool copy_numbers(const DataArray::Values& values, To* to)
{
  return std::visit(
    [to](const auto& v)
    {
      using Value = typename std::decay_t<decltype(v)>::value_type;
      if constexpr (std::is_arithmetic_v<Value>)
        std::copy(v.begin(), v.end(), to);
      return std::is_arithmetic_v<Value>;
    },
    values);
}

struct SurfaceFile
{
  Points points;
  bool single_precision = false; ///< the file's points are floats
  PolygonList polygons;          ///< vertices and lines are left out
  std::vector<DataArray> point_data;
  std::vector<DataArray> cell_data; ///< a tuple a cell of the file: polygons.cell says whose
  std::vector<DataArray> field_data;
};

}
