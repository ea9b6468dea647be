#include "solver/mesh/io/LegacyVtkFile.h"

#include "solver/mesh/io/ByteReader.h"
#include "solver/mesh/io/CellTypes.h"
#include "solver/mesh/io/TextScanner.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>

namespace vesicle
{
namespace
{

using Role = DataArray::Role;

std::string in_capitals(std::string_view word)
{
  std::string result(word);
  for (char& c : result)
    c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return result;
}

/// "Mean%20Curvature" → "Mean Curvature".
std::string decoded(std::string_view text)
{
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    int code = 0;
    const char* digits = text.data() + i + 1;
    if (text[i] == '%' && i + 2 < text.size() &&
      std::from_chars(digits, digits + 2, code, 16).ptr == digits + 2)
    {
      result += static_cast<char>(code);
      i += 2;
    }
    else
      result += text[i];
  }
  return result;
}

/// Vertices, lines, polygons or strips: where each begins among the corners.
struct CellList
{
  std::vector<std::int64_t> offsets{ 0 };
  std::vector<std::int64_t> corners;

  std::int64_t size() const { return static_cast<std::int64_t>(offsets.size()) - 1; }
  std::span<const std::int64_t> operator[](std::int64_t i) const
  {
    return { corners.data() + offsets[i], static_cast<std::size_t>(offsets[i + 1] - offsets[i]) };
  }
};

class LegacyVtkReader
{
public:
  LegacyVtkReader(std::string_view bytes, const std::string& name)
    : bytes_(bytes), name_(name), scanner_(bytes, name)
  {
  }

  SurfaceFile surface()
  {
    read_header();
    if (data_set_ != "POLYDATA" && data_set_ != "UNSTRUCTURED_GRID")
      scanner_.fail(
        "the data set should be POLYDATA or UNSTRUCTURED_GRID, another holds no surface of "
        "polygons (vtkDataSetSurfaceFilter, ParaView's Extract Surface, makes one)");
    read_sections();
    finish();
    return std::move(file_);
  }

  GridFile grid()
  {
    using Kind = GridFile::Kind;
    static constexpr std::array kinds{ std::pair{ "STRUCTURED_POINTS", Kind::image },
      std::pair{ "RECTILINEAR_GRID", Kind::rectilinear },
      std::pair{ "STRUCTURED_GRID", Kind::structured },
      std::pair{ "UNSTRUCTURED_GRID", Kind::unstructured } };
    read_header();
    const auto kind = std::ranges::find(kinds, data_set_, [](const auto& k) { return k.first; });
    if (kind == kinds.end())
      scanner_.fail(
        "the data set should be STRUCTURED_POINTS, RECTILINEAR_GRID, STRUCTURED_GRID or "
        "UNSTRUCTURED_GRID, in which fields live");
    grid_.kind = kind->second;
    read_sections();
    finish_field();
    return std::move(grid_);
  }

private:
  // Header: four lines.
  void read_header()
  {
    if (in_capitals(scanner_.rest_of_line().substr(0, 22)) != "# VTK DATAFILE VERSION")
      scanner_.fail(
        "is not a legacy VTK file: its first line should be '# vtk DataFile Version …'");
    scanner_.rest_of_line(); // the title
    const std::string format = in_capitals(scanner_.word());
    if (format != "ASCII" && format != "BINARY")
      scanner_.fail("ASCII or BINARY should be here");
    binary_ = format == "BINARY";
    const std::string keyword = in_capitals(scanner_.word());
    data_set_ = in_capitals(scanner_.word_on_line());
    if (keyword == "FIELD")
      scanner_.fail("holds fields without a surface");
    if (keyword != "DATASET")
      scanner_.fail(keyword.empty() ? "the file ends too early, where 'DATASET' should be"
                                    : "'DATASET' should be here");
    is_grid_ = data_set_ == "UNSTRUCTURED_GRID";
  }

  void read_sections()
  {
    for (auto word = scanner_.word(); !word.empty(); word = scanner_.word())
      read_section(in_capitals(word));
  }

  void read_section(const std::string& keyword)
  {
    if (keyword == "POINTS")
      read_points();
    else if (is_grid_ ? keyword == "CELLS"
                      : keyword == "VERTICES" || keyword == "LINES" || keyword == "POLYGONS" ||
          keyword == "TRIANGLE_STRIPS")
      lists_.emplace_back(keyword, read_cells());
    else if (is_grid_ && keyword == "CELL_TYPES")
      read_cell_types();
    else if (keyword == "CELL_DATA" || keyword == "POINT_DATA")
    {
      arrays_ = keyword == "CELL_DATA" ? &file_.cell_data : &file_.point_data;
      tuples_ = count("the number of tuples");
    }
    else if (keyword == "METADATA")
      read_metadata();
    else if (keyword == "FIELD")
      read_field();
    else if (keyword == "LOOKUP_TABLE")
      pass_over_table();
    else if (!read_structure(keyword) && !read_attribute(keyword))
      scanner_.fail("a keyword of a VTK file should be here");
  }

  // Numbers.
  std::int64_t count(std::string_view what)
  {
    const auto value = scanner_.number<std::int64_t>(what);
    if (value < 0)
      scanner_.fail(fmt::format("{} is negative", what));
    return value;
  }
  int components(std::string_view what)
  {
    const auto value = count(what);
    if (value > std::numeric_limits<std::uint16_t>::max())
      scanner_.fail(fmt::format("{} is {}", what, value));
    return static_cast<int>(value);
  }

  std::uint64_t product(std::int64_t tuples, int components) const
  {
    const auto t = static_cast<std::uint64_t>(tuples);
    if (components > 0 && t > bytes_.size() * 8 / static_cast<std::uint64_t>(components))
      scanner_.fail(
        fmt::format("the file ends too early: {} × {} values would follow, but {} bytes "
                    "are left",
          tuples, components, scanner_.left()));
    return t * static_cast<std::uint64_t>(components);
  }

  template<typename T>
  std::vector<T> numbers(std::uint64_t count, std::string_view what)
  {
    if (binary_)
    {
      scanner_.rest_of_line();
      ByteReader reader(bytes_, name_, std::endian::big);
      reader.take(scanner_.position(), what);
      auto values = reader.read_array<T>(count, what);
      scanner_.skip(count * sizeof(T));
      return values;
    }
    scanner_.require_words(count, what);
    std::vector<T> values;
    values.reserve(count);
    for (std::uint64_t i = 0; i < count; ++i)
      values.push_back(scanner_.number<T>(what));
    return values;
  }

  template<typename To, typename From>
  static std::vector<To> converted(const std::vector<From>& values)
  {
    return std::vector<To>(values.begin(), values.end());
  }

  std::vector<std::uint8_t> bits(std::uint64_t count, std::string_view what)
  {
    if (!binary_)
      return numbers<std::uint8_t>(count, what);
    const auto packed = numbers<std::uint8_t>((count + 7) / 8, what);
    std::vector<std::uint8_t> values(count);
    for (std::uint64_t i = 0; i < count; ++i)
      values[i] = packed[i / 8] >> (7 - i % 8) & 1;
    return values;
  }

  std::vector<std::string> strings(std::uint64_t count)
  {
    scanner_.rest_of_line();
    std::vector<std::string> values;
    for (std::uint64_t i = 0; i < count; ++i)
    {
      if (scanner_.left() == 0)
        scanner_.fail("the file ends too early, within strings");
      values.push_back(binary_ ? binary_string() : decoded(scanner_.rest_of_line()));
    }
    return values;
  }

  /// The length before it takes 1, 2, 4 or 8 bytes, as the two highest bits tell.
  std::string binary_string()
  {
    ByteReader reader(bytes_, name_, std::endian::big);
    reader.take(scanner_.position(), "strings");
    const auto first = static_cast<unsigned char>(bytes_[scanner_.position()]);
    std::uint64_t length = 0;
    switch (first >> 6)
    {
      case 3:
        length = reader.read<std::uint8_t>("a string's length") & 0x3fU;
        break;
      case 2:
        length = reader.read<std::uint16_t>("a string's length") & 0x3fffU;
        break;
      case 1:
        length = reader.read<std::uint32_t>("a string's length") & 0x3fffffffU;
        break;
      default:
        length = reader.read<std::uint64_t>("a string's length");
    }
    std::string text(reader.take(length, "a string"));
    scanner_.skip(reader.position() - scanner_.position());
    return text;
  }

  DataArray::Values values(std::string_view type, std::uint64_t n, std::string_view what)
  {
    const std::string t = in_capitals(type);
    if (t == "BIT")
      return bits(n, what);
    if (t == "CHAR")
      return numbers<char>(n, what);
    if (t == "SIGNED_CHAR")
      return numbers<std::int8_t>(n, what);
    if (t == "UNSIGNED_CHAR")
      return numbers<std::uint8_t>(n, what);
    if (t == "SHORT")
      return numbers<std::int16_t>(n, what);
    if (t == "UNSIGNED_SHORT")
      return numbers<std::uint16_t>(n, what);
    if (t == "INT")
      return numbers<std::int32_t>(n, what);
    if (t == "UNSIGNED_INT")
      return numbers<std::uint32_t>(n, what);
    if (t == "VTKIDTYPE" && binary_) // written as int
      return converted<std::int64_t>(numbers<std::int32_t>(n, what));
    if (t == "VTKIDTYPE" || t == "LONG" || t == "VTKTYPEINT64")
      return numbers<std::int64_t>(n, what);
    if (t == "UNSIGNED_LONG" || t == "VTKTYPEUINT64")
      return numbers<std::uint64_t>(n, what);
    if (t == "FLOAT")
      return numbers<float>(n, what);
    if (t == "DOUBLE")
      return numbers<double>(n, what);
    if (t == "STRING" || t == "UTF8_STRING")
      return strings(n);
    scanner_.fail("a type of VTK's should be here, such as float, double, int or unsigned_char");
  }

  std::vector<std::int64_t> integers(std::string_view type, std::uint64_t n, std::string_view what)
  {
    auto all = values(type, n, what);
    return std::visit(
      [&](auto& v) -> std::vector<std::int64_t>
      {
        using Value = typename std::decay_t<decltype(v)>::value_type;
        if constexpr (std::is_same_v<Value, std::int64_t>)
          return std::move(v);
        else if constexpr (std::is_integral_v<Value>)
          return converted<std::int64_t>(v);
        else
          scanner_.fail(fmt::format("{} should be integers", what));
      },
      all);
  }

  // Points and cells.
  void read_points()
  {
    const auto points = count("the number of points");
    const std::string type(scanner_.word_on_line());
    if (file_.points.rows() > 0)
      scanner_.fail("the points are there twice");
    const auto all = values(type, product(points, 3), "the coordinates");
    file_.single_precision = std::visit(
      [](const auto& v)
      {
        using Value = typename std::decay_t<decltype(v)>::value_type;
        return std::is_same_v<Value, float> || sizeof(Value) <= 2;
      },
      all);
    file_.points.resize(points, 3);
    if (!copy_numbers(all, file_.points.data()))
      scanner_.fail("coordinates should be numbers");
  }

  // Of data sets that aren't surfaces.
  bool read_structure(const std::string& keyword)
  {
    static constexpr std::array axes{ "X_COORDINATES", "Y_COORDINATES", "Z_COORDINATES" };
    if (data_set_ == "POLYDATA" || is_grid_)
      return false;
    if (keyword == "DIMENSIONS")
      for (int c = 0; c < 3; ++c)
      {
        const auto points = count("the number of points along an axis");
        if (points < 1 || points > std::numeric_limits<int>::max())
          scanner_.fail(fmt::format("there are {} points along an axis", points));
        grid_.extent[2 * c] = 0;
        grid_.extent[2 * c + 1] = static_cast<int>(points - 1);
      }
    else if (keyword == "ORIGIN")
      read_three(grid_.origin, "the origin");
    else if (keyword == "SPACING" || keyword == "ASPECT_RATIO")
      read_three(grid_.spacing, "the spacing");
    else if (const auto axis = std::ranges::find(axes, keyword); axis != axes.end())
      read_coordinates(grid_.coordinates[axis - axes.begin()]);
    else
      return false;
    return true;
  }

  void read_three(std::array<double, 3>& numbers, std::string_view what)
  {
    for (double& number : numbers)
      number = scanner_.number<double>(what);
  }

  void read_coordinates(std::vector<double>& along)
  {
    const auto points = count("the number of coordinates");
    const std::string type(scanner_.word_on_line());
    const auto all = values(type, product(points, 1), "the coordinates");
    along.resize(points);
    if (!copy_numbers(all, along.data()))
      scanner_.fail("coordinates should be numbers");
  }

  CellList read_cells()
  {
    const auto cells = count("the number of cells");
    const auto size = count("the size of the list of cells");
    if (in_capitals(scanner_.peek().substr(0, 7)) == "OFFSETS") // since version 5
      return read_offsets(cells, size);
    const auto list = numbers<std::int32_t>(product(size, 1), "the cells");
    CellList result;
    std::size_t at = 0;
    for (std::int64_t i = 0; i < cells; ++i)
    {
      const std::int64_t corners = at < list.size() ? list[at] : -1;
      if (corners < 0 || static_cast<std::size_t>(corners) > list.size() - at - 1)
        scanner_.fail(
          fmt::format("cell {} doesn't fit into the list, which has {} numbers", i, list.size()));
      const auto* first = list.data() + at + 1;
      result.corners.insert(result.corners.end(), first, first + corners);
      result.offsets.push_back(static_cast<std::int64_t>(result.corners.size()));
      at += static_cast<std::size_t>(corners) + 1;
    }
    if (at != list.size())
      scanner_.fail(
        fmt::format("{} cells take {} numbers, but {} are announced", cells, at, list.size()));
    return result;
  }

  CellList read_offsets(std::int64_t offsets, std::int64_t corners)
  {
    CellList result;
    scanner_.word();
    const std::string offset_type(scanner_.word_on_line());
    result.offsets = integers(offset_type, product(offsets, 1), "the cells' offsets");
    if (in_capitals(scanner_.word()) != "CONNECTIVITY")
      scanner_.fail("'CONNECTIVITY' should be here");
    const std::string corner_type(scanner_.word_on_line());
    result.corners = integers(corner_type, product(corners, 1), "the cells' corners");
    check_offsets(result.offsets, corners, "cells", name_);
    if (result.offsets.empty())
      result.offsets = { 0 };
    return result;
  }

  void read_cell_types()
  {
    const auto cells = count("the number of cells");
    cell_types_ = numbers<std::int32_t>(product(cells, 1), "the cells' types");
    has_cell_types_ = true;
  }

  // Arrays.
  bool read_attribute(const std::string& keyword)
  {
    struct Attribute
    {
      std::string_view keyword;
      int components; ///< 0: a number in the file
      Role role;
    };
    static constexpr std::array attributes{ Attribute{ "VECTORS", 3, Role::vectors },
      Attribute{ "NORMALS", 3, Role::normals },
      Attribute{ "TEXTURE_COORDINATES", 0, Role::texture_coordinates },
      Attribute{ "TENSORS", 9, Role::tensors }, Attribute{ "TENSORS6", 6, Role::tensors },
      Attribute{ "GLOBAL_IDS", 1, Role::global_ids },
      Attribute{ "PEDIGREE_IDS", 1, Role::pedigree_ids },
      Attribute{ "EDGE_FLAGS", 1, Role::edge_flags } };
    if (keyword == "SCALARS" || keyword == "COLOR_SCALARS")
    {
      require_data_section();
      keyword == "SCALARS" ? read_scalars() : read_colors();
      return true;
    }
    const auto found = std::ranges::find(attributes, keyword, &Attribute::keyword);
    if (found == attributes.end())
      return false;
    require_data_section();
    std::string name = decoded(scanner_.word_on_line());
    const int width =
      found->components > 0 ? found->components : components("the number of components");
    const std::string type(scanner_.word_on_line());
    add_array(*arrays_, std::move(name), width, tuples_, type, found->role);
    return true;
  }

  void require_data_section() const
  {
    if (!arrays_)
      scanner_.fail("POINT_DATA or CELL_DATA should come first");
  }

  void add_array(std::vector<DataArray>& arrays, std::string name, int width, std::int64_t tuples,
    const std::string& type, Role role)
  {
    auto all = values(type, product(tuples, width), fmt::format("the array '{}'", name));
    if (width == 0)
      return;
    const bool ids = in_capitals(type) == "VTKIDTYPE";
    arrays.push_back({ std::move(name), width, std::move(all), role, {}, ids });
    last_ = { &arrays, arrays.size() - 1 };
  }

  void read_scalars()
  {
    std::string name = decoded(scanner_.word_on_line());
    const std::string type(scanner_.word_on_line());
    const auto word = scanner_.word_on_line();
    const auto width = word.empty() ? 1 : number_of<std::uint16_t>(word).value_or(0);
    if (width == 0)
      scanner_.fail("the number of components should be here");
    if (in_capitals(scanner_.word()) != "LOOKUP_TABLE")
      scanner_.fail("'LOOKUP_TABLE' should be here");
    scanner_.word_on_line();
    add_array(*arrays_, std::move(name), width, tuples_, type, Role::scalars);
  }

  /// Unsigned characters in binary files, numbers from 0 to 1 in text.
  void read_colors()
  {
    std::string name = decoded(scanner_.word_on_line());
    const int width = components("the number of components");
    if (binary_)
      return add_array(*arrays_, std::move(name), width, tuples_, "unsigned_char", Role::scalars);
    std::vector<std::uint8_t> colors;
    for (const float c : numbers<float>(product(tuples_, width), "the colours"))
      colors.push_back(static_cast<std::uint8_t>(std::lround(255 * std::clamp(c, 0.F, 1.F))));
    if (width > 0)
      arrays_->push_back({ std::move(name), width, std::move(colors), Role::scalars, {}, false });
  }

  void read_field()
  {
    auto& arrays = arrays_ ? *arrays_ : file_.field_data;
    scanner_.word_on_line(); // its name
    const auto count_of_arrays = count("the number of arrays");
    for (std::int64_t i = 0; i < count_of_arrays; ++i)
    {
      auto name = scanner_.word();
      if (name.empty())
        scanner_.fail("the file ends too early, where an array should be");
      if (in_capitals(name) == "METADATA")
      {
        read_metadata();
        --i;
        continue;
      }
      if (name == "NULL_ARRAY")
        continue;
      std::string text = decoded(name);
      const int width = components("the number of components");
      const auto tuples = count("the number of tuples");
      const std::string type(scanner_.word_on_line());
      add_array(arrays, std::move(text), width, tuples, type, Role::none);
    }
  }

  /// What follows an array: its components' names, and information that nobody here asks for; to
  /// the next empty line.
  void read_metadata()
  {
    scanner_.rest_of_line();
    int names = 0;
    for (auto line = scanner_.rest_of_line(); !line.empty(); line = scanner_.rest_of_line())
    {
      if (in_capitals(line.substr(0, 15)) == "COMPONENT_NAMES" && last_.arrays)
        names = (*last_.arrays)[last_.index].components;
      else if (names > 0 &&
        (*last_.arrays)[last_.index].component_names.size() < static_cast<std::size_t>(names))
        (*last_.arrays)[last_.index].component_names.push_back(decoded(line));
    }
  }

  void pass_over_table()
  {
    scanner_.word_on_line(); // its name
    const auto n = product(count("the size of the table"), 4);
    if (binary_)
      numbers<std::uint8_t>(n, "the table");
    else
      numbers<float>(n, "the table");
  }

  // Polygons, once all is there.
  void finish()
  {
    std::int64_t cells = 0;
    if (is_grid_)
      cells = finish_grid();
    else
    {
      for (const char* kind : { "VERTICES", "LINES", "POLYGONS", "TRIANGLE_STRIPS" }) // VTK's order
        for (const auto& [keyword, list] : lists_)
          if (keyword == kind)
          {
            add_list(keyword, list, cells);
            cells += list.size();
          }
    }
    require_tuples(file_.point_data, file_.points.rows(), "points");
    require_tuples(file_.cell_data, cells, "cells");
  }

  void add_list(const std::string& keyword, const CellList& list, std::int64_t first_cell)
  {
    for (std::int64_t i = 0; i < list.size(); ++i)
    {
      if (keyword == "POLYGONS")
        file_.polygons.add(list[i], first_cell + i);
      else if (keyword == "TRIANGLE_STRIPS")
        file_.polygons.add_strip(list[i], first_cell + i);
    }
  }

  void require_types() const
  {
    if (lists_.size() != 1 || !has_cell_types_ ||
      lists_[0].second.size() != static_cast<std::int64_t>(cell_types_.size()))
      scanner_.fail("an unstructured grid needs CELLS and as many CELL_TYPES (or the file ends too "
                    "early)");
  }

  void finish_field()
  {
    if (is_grid_)
    {
      require_types();
      grid_.types = converted<std::int64_t>(cell_types_);
      grid_.offsets = std::move(lists_[0].second.offsets);
      grid_.corners = std::move(lists_[0].second.corners);
    }
    grid_.points = std::move(file_.points);
    grid_.point_data = std::move(file_.point_data);
    grid_.cell_data = std::move(file_.cell_data);
  }

  std::int64_t finish_grid()
  {
    if (lists_.empty() && cell_types_.empty())
      return 0;
    require_types();
    const CellList& list = lists_[0].second;
    for (std::int64_t i = 0; i < list.size(); ++i)
      add_cell(file_.polygons, cell_types_[i], list[i], i, name_);
    return list.size();
  }

  void require_tuples(
    const std::vector<DataArray>& arrays, std::int64_t count, std::string_view what) const
  {
    for (const DataArray& array : arrays)
      if (array.tuples() != count)
        scanner_.fail(fmt::format(
          "the array '{}' has {} tuples for {} {}", array.name, array.tuples(), count, what));
  }

  struct Place
  {
    std::vector<DataArray>* arrays = nullptr;
    std::size_t index = 0;
  };

  std::string_view bytes_;
  std::string name_;
  TextScanner scanner_;
  bool binary_ = false;
  std::string data_set_;
  bool is_grid_ = false; ///< unstructured
  std::vector<std::pair<std::string, CellList>> lists_;
  std::vector<std::int32_t> cell_types_;
  bool has_cell_types_ = false;
  std::vector<DataArray>* arrays_ = nullptr; ///< of the section that is being read
  std::int64_t tuples_ = 0;
  Place last_; ///< the array read last
  SurfaceFile file_;
  GridFile grid_; ///< what surfaces don't have, and all of it in the end
};

}

SurfaceFile read_legacy_vtk(std::string_view bytes, const std::string& name)
{
  return LegacyVtkReader(bytes, name).surface();
}

GridFile read_legacy_vtk_grid(std::string_view bytes, const std::string& name)
{
  return LegacyVtkReader(bytes, name).grid();
}

}
