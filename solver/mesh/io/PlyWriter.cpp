#include "solver/mesh/io/PlyWriter.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstring>
#include <set>
#include <string_view>
#include <type_traits>

namespace vesicle
{
namespace
{

constexpr double whole_numbers = 9007199254740992; // 2⁵³: beyond, doubles aren't all integers

template<typename T>
void append(std::string& bytes, T value)
{
  std::array<char, sizeof(T)> raw;
  std::memcpy(raw.data(), &value, sizeof(T));
  if constexpr (std::endian::native == std::endian::big)
    std::reverse(raw.begin(), raw.end());
  bytes.append(raw.data(), raw.size());
}

/// The type that stands for T in PLY, which has no 64-bit integers.
template<typename T>
constexpr const char* type_name()
{
  if constexpr (std::is_same_v<T, float>)
    return "float";
  else if constexpr (!std::is_integral_v<T> || sizeof(T) > 4)
    return "double";
  else if constexpr (std::is_signed_v<T>)
    return sizeof(T) == 1 ? "char" : sizeof(T) == 2 ? "short" : "int";
  else
    return sizeof(T) == 1 ? "uchar" : sizeof(T) == 2 ? "ushort" : "uint";
}

bool can_be_held(const DataArray& array)
{
  return std::visit(
    [](const auto& values)
    {
      using T = typename std::decay_t<decltype(values)>::value_type;
      if constexpr (std::is_same_v<T, std::string>)
        return false;
      else if constexpr (std::is_integral_v<T> && sizeof(T) > 4)
        return std::ranges::all_of(
          values, [](T x) { return std::abs(static_cast<double>(x)) <= whole_numbers; });
      else
        return true;
    },
    array.values);
}

std::string as_word(std::string name)
{
  for (char& c : name)
    if (std::isspace(static_cast<unsigned char>(c)) || std::iscntrl(static_cast<unsigned char>(c)))
      c = '_';
  return name;
}

std::vector<std::string> column_names(const DataArray& array)
{
  const bool bytes = std::holds_alternative<std::vector<std::uint8_t>>(array.values);
  if (array.role == DataArray::Role::normals && array.components == 3)
    return { "nx", "ny", "nz" };
  if (bytes && array.name == "RGB" && array.components == 3)
    return { "red", "green", "blue" };
  if (bytes && array.name == "RGBA" && array.components == 4)
    return { "red", "green", "blue", "alpha" };
  if (array.components == 1)
    return { as_word(array.name) };
  std::vector<std::string> names;
  names.reserve(array.components);
  for (int k = 0; k < array.components; ++k)
    names.push_back(fmt::format("{}_{}", as_word(array.name), k));
  return names;
}

/// The arrays of one element that fit beside the names that are taken.
class Columns
{
public:
  Columns(const std::vector<DataArray>& arrays, std::set<std::string> taken,
    std::vector<std::string>& lost)
  {
    for (const DataArray& array : arrays)
    {
      const auto names = column_names(array);
      const bool fits = !array.name.empty() && can_be_held(array) &&
        std::ranges::none_of(names, [&](const auto& n) { return taken.contains(n); });
      if (!fits)
      {
        lost.push_back(array.name);
        continue;
      }
      taken.insert(names.begin(), names.end());
      arrays_.push_back(&array);
      for (const auto& name : names)
        header_ += fmt::format("property {} {}\n",
          std::visit([](const auto& v)
            { return type_name<typename std::decay_t<decltype(v)>::value_type>(); },
            array.values),
          name);
    }
  }

  const std::string& header() const { return header_; }

  void append_row(std::string& bytes, std::int64_t row) const
  {
    for (const DataArray* array : arrays_)
      std::visit(
        [&](const auto& values)
        {
          using T = typename std::decay_t<decltype(values)>::value_type;
          if constexpr (std::is_arithmetic_v<T>)
            for (int k = 0; k < array->components; ++k)
            {
              const T value = values[row * array->components + k];
              if constexpr (std::is_integral_v<T> && sizeof(T) > 4)
                append(bytes, static_cast<double>(value));
              else
                append(bytes, value);
            }
        },
        array->values);
  }

private:
  std::vector<const DataArray*> arrays_;
  std::string header_;
};

}

PlyText ply_text(const SurfaceFile& surface)
{
  PlyText ply;
  const Columns of_points(surface.point_data, { "x", "y", "z" }, ply.lost);
  const Columns of_faces(surface.cell_data, { "vertex_indices", "vertex_index" }, ply.lost);
  for (const DataArray& array : surface.field_data)
    ply.lost.push_back(array.name);
  const char* real = surface.single_precision ? "float" : "double";
  std::string& bytes = ply.bytes;
  bytes = fmt::format("ply\nformat binary_little_endian 1.0\nelement vertex {0}\n"
                      "property {1} x\nproperty {1} y\nproperty {1} z\n{2}element face {3}\n"
                      "property list uchar int vertex_indices\n{4}end_header\n",
    surface.points.rows(), real, of_points.header(), surface.polygons.size(), of_faces.header());
  for (Eigen::Index i = 0; i < surface.points.rows(); ++i)
  {
    for (const double x : surface.points.row(i))
      surface.single_precision ? append(bytes, static_cast<float>(x)) : append(bytes, x);
    of_points.append_row(bytes, i);
  }
  for (std::int64_t i = 0; i < surface.polygons.size(); ++i)
  {
    append(bytes, static_cast<std::uint8_t>(surface.polygons[i].size()));
    for (const std::int64_t corner : surface.polygons[i])
      append(bytes, static_cast<std::int32_t>(corner));
    of_faces.append_row(bytes, surface.polygons.cell[i]);
  }
  return ply;
}

}
