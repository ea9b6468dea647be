#pragma once
// Cells of VTK's data sets as numbers that can be followed.

#include "solver/mesh/PolygonMesh.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace vesicle
{

/// The cells' offsets and corners, checked against each other. Throws InputError that begins with `name`.
struct CellList
{
  CellList(vtkCellArray* cells, const std::string& what, const std::string& name)
    : offsets(numbers(cells->GetOffsetsArray())), corners(numbers(cells->GetConnectivityArray()))
  {
    check_offsets(offsets, static_cast<std::int64_t>(corners.size()), what, name);
  }

  std::int64_t size() const
  {
    return offsets.empty() ? 0 : static_cast<std::int64_t>(offsets.size()) - 1;
  }
  std::span<const std::int64_t> operator[](std::int64_t i) const
  {
    return { corners.data() + offsets[i], static_cast<std::size_t>(offsets[i + 1] - offsets[i]) };
  }

  static std::vector<std::int64_t> numbers(vtkDataArray* array)
  {
    std::vector<std::int64_t> result(array->GetNumberOfTuples());
    if (result.empty())
      return result;
    if (array->GetDataTypeSize() == sizeof(std::int64_t))
      std::copy_n(
        static_cast<const std::int64_t*>(array->GetVoidPointer(0)), result.size(), result.begin());
    else
      std::copy_n(
        static_cast<const std::int32_t*>(array->GetVoidPointer(0)), result.size(), result.begin());
    return result;
  }

  std::vector<std::int64_t> offsets;
  std::vector<std::int64_t> corners;
};

}
