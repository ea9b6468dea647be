#pragma once
// What pieces of VTK's XML files have alike, whatever data set they are of.

#include "XmlArrays.h"

#include "solver/mesh/TriangleMesh.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vesicle
{

/// Each throws InputError that begins with the file's name, with the array or the attribute that is
/// wrong.
class XmlPieces
{
public:
  XmlPieces(const XmlDocument& document, std::string name);

  const std::string& name() const { return name_; }
  const XmlArrays& arrays() const { return arrays_; }

  /// 0 where it is missing.
  std::int64_t count(const XmlElement& piece, std::string_view attribute) const;
  /// Whether the file's points are floats.
  bool read_points(const XmlElement& piece, std::int64_t count, Points& points) const;

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
  /// `kind`: the element of the lists.
  CellList read_cells(const XmlElement& piece, std::string_view kind, std::int64_t count) const;
  /// A number for each of an unstructured grid's cells.
  std::vector<std::int64_t> read_types(const XmlElement& piece, std::int64_t count) const;
  /// nullptr: there is none.
  static const XmlElement* array_of(const XmlElement& cells, std::string_view array_name);

  /// `kind`: "PointData" or "CellData".
  std::vector<DataArray> read_data(
    const XmlElement& piece, std::string_view kind, std::int64_t tuples) const;
  void require_tuples(const XmlElement& element, const DataArray& array, std::int64_t needed,
    std::string_view of) const;
  /// Packed bits come with those that fill the last byte.
  static void cut_bits(const XmlElement& element, DataArray& array, std::int64_t tuples);

private:
  std::string name_;
  XmlArrays arrays_;
};

}
