#include "solver/mesh/io/PlyFile.h"

#include "solver/Errors.h"
#include "solver/mesh/io/ByteReader.h"
#include "solver/mesh/io/TextScanner.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace vesicle
{
namespace
{

enum class Type
{
  int8,
  uint8,
  int16,
  uint16,
  int32,
  uint32,
  float32,
  float64
};

struct TypeName
{
  std::string_view word;
  Type type;
};
constexpr std::array type_names{ TypeName{ "char", Type::int8 }, TypeName{ "int8", Type::int8 },
  TypeName{ "uchar", Type::uint8 }, TypeName{ "uint8", Type::uint8 },
  TypeName{ "short", Type::int16 }, TypeName{ "int16", Type::int16 },
  TypeName{ "ushort", Type::uint16 }, TypeName{ "uint16", Type::uint16 },
  TypeName{ "int", Type::int32 }, TypeName{ "int32", Type::int32 },
  TypeName{ "uint", Type::uint32 }, TypeName{ "uint32", Type::uint32 },
  TypeName{ "float", Type::float32 }, TypeName{ "float32", Type::float32 },
  TypeName{ "double", Type::float64 }, TypeName{ "float64", Type::float64 } };

template<typename Use>
auto with_type(Type type, Use use)
{
  switch (type)
  {
    case Type::int8: // NOLINT(bugprone-branch-clone): each of another type
      return use(std::int8_t());
    case Type::uint8:
      return use(std::uint8_t());
    case Type::int16:
      return use(std::int16_t());
    case Type::uint16:
      return use(std::uint16_t());
    case Type::int32:
      return use(std::int32_t());
    case Type::uint32:
      return use(std::uint32_t());
    case Type::float32:
      return use(float());
    default:
      return use(double());
  }
}

std::size_t size_of(Type type)
{
  return with_type(type, [](auto x) { return sizeof(x); });
}

struct Property
{
  std::string name;
  Type type = Type::float32;
  std::optional<Type> count; ///< of a list's length
};

struct Element
{
  std::string name;
  std::int64_t count = 0;
  std::vector<Property> properties;
};

enum class Format
{
  ascii,
  binary_little_endian,
  binary_big_endian
};

struct PlyHeader
{
  Format format = Format::ascii;
  std::vector<Element> elements;
  std::size_t bytes = 0; ///< where the body begins
};

Type type_of(std::string_view word, const TextScanner& scanner)
{
  const auto found = std::ranges::find(type_names, word, &TypeName::word);
  if (found == type_names.end())
    scanner.fail("a type is needed here: char uchar short ushort int uint float double");
  return found->type;
}

Property read_property(TextScanner& scanner)
{
  Property property;
  auto word = scanner.word_on_line();
  if (word == "list")
  {
    property.count = type_of(scanner.word_on_line(), scanner);
    word = scanner.word_on_line();
  }
  property.type = type_of(word, scanner);
  property.name = scanner.word_on_line();
  if (property.name.empty())
    scanner.fail("a property needs a name");
  return property;
}

Format read_format(TextScanner& scanner)
{
  constexpr std::array<std::string_view, 3> names{ "ascii", "binary_little_endian",
    "binary_big_endian" };
  const auto found = std::ranges::find(names, scanner.word_on_line());
  if (found == names.end())
    scanner.fail("the format should be ascii, binary_little_endian or binary_big_endian");
  if (scanner.word_on_line() != "1.0")
    scanner.fail("the version of the format should be 1.0");
  return static_cast<Format>(found - names.begin());
}

PlyHeader read_header(std::string_view bytes, const std::string& name)
{
  TextScanner scanner(bytes, name);
  if (scanner.word_on_line() != "ply")
    scanner.fail("is not a PLY file: its first line should be 'ply'");
  scanner.require_end_of_line();
  PlyHeader header;
  bool has_format = false;
  while (true)
  {
    const auto keyword = scanner.word();
    if (keyword == "end_header")
      break;
    if (keyword.empty())
      scanner.fail("the file ends too early, where 'end_header' should be");
    if (keyword == "comment" || keyword == "obj_info")
    {
      scanner.rest_of_line();
      continue;
    }
    if (keyword == "format")
    {
      header.format = read_format(scanner);
      has_format = true;
    }
    else if (keyword == "element")
    {
      std::string element(scanner.word_on_line());
      const auto count = scanner.number_on_line<std::int64_t>("the number of elements");
      if (count < 0)
        scanner.fail("the number of elements is negative");
      header.elements.push_back({ std::move(element), count, {} });
    }
    else if (keyword == "property" && !header.elements.empty())
      header.elements.back().properties.push_back(read_property(scanner));
    else
      scanner.fail("a line of a PLY header should be here: element, property, comment, end_header");
    scanner.require_end_of_line();
  }
  if (!has_format)
    scanner.fail("the header has no line 'format'");
  scanner.require_end_of_line();
  header.bytes = scanner.position();
  return header;
}

/// The values of the body one after the other, whichever way they are written.
class TextBody
{
public:
  TextBody(std::string_view bytes, const std::string& name, const PlyHeader& header)
    : scanner_(bytes, name)
  {
    while (scanner_.position() < header.bytes) // counts the lines
      scanner_.rest_of_line();
  }

  void require_rows(const Element& element) const
  {
    if (!element.properties.empty())
      scanner_.require_words(element.count, fmt::format("the elements '{}'", element.name));
  }
  void begin_row() { scanner_.skip_empty_lines(); }
  void end_row() { scanner_.require_end_of_line(); }
  void require_values(std::uint64_t count, Type, std::string_view what) const
  {
    scanner_.require_words(count, what);
  }
  template<typename T>
  T read(std::string_view what)
  {
    return scanner_.number_on_line<T>(what);
  }
  [[noreturn]] void fail(std::string_view problem) const { scanner_.fail(problem); }
  void require_end() const
  {
    if (!scanner_.at_end())
      scanner_.fail("there is more than the header announces");
  }

private:
  TextScanner scanner_;
};

class BinaryBody
{
public:
  BinaryBody(std::string_view bytes, const std::string& name, const PlyHeader& header)
    : reader_(bytes, name,
        header.format == Format::binary_big_endian ? std::endian::big : std::endian::little)
  {
    reader_.take(header.bytes, "the header");
  }

  void require_rows(const Element& element) const
  {
    std::uint64_t bytes = 0;
    for (const Property& property : element.properties)
      bytes += size_of(property.count.value_or(property.type));
    reader_.require(element.count, bytes, fmt::format("the elements '{}'", element.name));
  }
  void begin_row() {}
  void end_row() {}
  void require_values(std::uint64_t count, Type type, std::string_view what) const
  {
    reader_.require(count, size_of(type), what);
  }
  template<typename T>
  T read(std::string_view what)
  {
    return reader_.read<T>(what);
  }
  [[noreturn]] void fail(std::string_view problem) const { reader_.fail(problem); }
  void require_end() const
  {
    if (reader_.left() > 0)
      reader_.fail(
        fmt::format("there are {} bytes more than the header announces", reader_.left()));
  }

private:
  ByteReader reader_;
};

/// What becomes of the elements of one kind.
struct Column
{
  std::string name;
  DataArray::Values values; ///< as the file has them; none of a list
};

std::vector<Column> columns_of(const Element& element)
{
  std::vector<Column> columns;
  for (const Property& property : element.properties)
    columns.push_back({ property.name,
      with_type(
        property.type, [](auto x) -> DataArray::Values { return std::vector<decltype(x)>(); }) });
  return columns;
}

template<typename Body>
class PlyReader
{
public:
  PlyReader(Body body, const PlyHeader& header) : body_(std::move(body)), header_(header) {}

  SurfaceFile read()
  {
    for (const Element& element : header_.elements)
      read_element(element);
    body_.require_end();
    if (!has_points_)
      body_.fail("the file has no element 'vertex' with x, y and z");
    if (has_strips_)
      file_.cell_data.clear(); // which belong to faces
    return std::move(file_);
  }

private:
  void read_element(const Element& element)
  {
    if (element.properties.empty() || element.count == 0)
      return;
    body_.require_rows(element);
    auto columns = columns_of(element);
    const bool is_face = element.name == "face", is_strip = element.name == "tristrips";
    const bool kept = element.name == "vertex" || is_face;
    bool any_corners = false;
    for (std::int64_t i = 0; i < element.count; ++i)
    {
      body_.begin_row();
      for (std::size_t k = 0; k < columns.size(); ++k)
      {
        const Property& property = element.properties[k];
        if (!property.count)
          read_scalar(property, kept ? &columns[k].values : nullptr);
        else if ((is_face || is_strip) &&
          (property.name == "vertex_indices" || property.name == "vertex_index"))
        {
          any_corners = true;
          read_corners(property, i, is_strip);
        }
        else
          pass_over_list(property);
      }
      body_.end_row();
    }
    if ((is_face || is_strip) && !any_corners)
      body_.fail("the faces have no list vertex_indices");
    if (element.name == "vertex")
      take_points(std::move(columns));
    else if (is_face)
      file_.cell_data = arrays_of(std::move(columns));
  }

  void read_scalar(const Property& property, DataArray::Values* values)
  {
    with_type(property.type,
      [&](auto x)
      {
        x = body_.template read<decltype(x)>(property.name);
        if (values)
          std::get<std::vector<decltype(x)>>(*values).push_back(x);
      });
  }

  std::uint64_t read_length(const Property& property)
  {
    const double length = with_type(*property.count,
      [&](auto x) { return static_cast<double>(body_.template read<decltype(x)>(property.name)); });
    if (!(length >= 0) || length != std::floor(length) || length > 9e15)
      body_.fail(fmt::format("a list of {} values can't be", length));
    const auto count = static_cast<std::uint64_t>(length);
    body_.require_values(count, property.type, fmt::format("a list '{}'", property.name));
    return count;
  }

  std::int64_t read_index(const Property& property)
  {
    return with_type(property.type,
      [&](auto x) -> std::int64_t
      {
        x = body_.template read<decltype(x)>(property.name);
        if constexpr (std::is_floating_point_v<decltype(x)>)
        {
          if (!(std::abs(x) < decltype(x)(9e15)) || x != std::floor(x))
            body_.fail(fmt::format("{} is no point's number", x));
        }
        return static_cast<std::int64_t>(x);
      });
  }

  void read_corners(const Property& property, std::int64_t row, bool is_strip)
  {
    const auto count = read_length(property);
    PolygonList& polygons = file_.polygons;
    if (is_strip)
    {
      read_strips(property, count);
      return;
    }
    if (count < 3)
      body_.fail(fmt::format("face {} has {} corners, it needs three or more", row, count));
    for (std::uint64_t k = 0; k < count; ++k)
      polygons.corners.push_back(read_index(property));
    polygons.close(row);
  }

  /// −1 ends a strip.
  void read_strips(const Property& property, std::uint64_t count)
  {
    std::vector<std::int64_t> strip;
    for (std::uint64_t k = 0; k <= count; ++k)
    {
      const std::int64_t index = k < count ? read_index(property) : -1;
      if (index != -1)
      {
        strip.push_back(index);
        continue;
      }
      file_.polygons.add_strip(strip, 0);
      has_strips_ = true;
      strip.clear();
    }
  }

  void pass_over_list(const Property& property)
  {
    const auto count = read_length(property);
    for (std::uint64_t k = 0; k < count; ++k)
      read_scalar(property, nullptr);
  }

  void take_points(std::vector<Column> columns)
  {
    if (has_points_)
      body_.fail("the file has two elements 'vertex'");
    constexpr std::array<std::string_view, 3> axes{ "x", "y", "z" };
    bool single = true;
    for (int k = 0; k < 3; ++k)
    {
      const auto column = std::ranges::find(columns, axes[k], &Column::name);
      if (column == columns.end())
        return;
      std::visit(
        [&](const auto& values)
        {
          using Value = typename std::decay_t<decltype(values)>::value_type;
          if constexpr (std::is_arithmetic_v<Value>)
          {
            single = single && (std::is_same_v<Value, float> || sizeof(Value) <= 2);
            file_.points.conservativeResize(static_cast<Eigen::Index>(values.size()), 3);
            for (std::size_t i = 0; i < values.size(); ++i)
              file_.points(static_cast<Eigen::Index>(i), k) = static_cast<double>(values[i]);
          }
        },
        column->values);
      columns.erase(column);
    }
    has_points_ = true;
    file_.single_precision = single;
    file_.point_data = arrays_of(std::move(columns));
  }

  /// Columns that belong together become the components of one array.
  static std::vector<DataArray> arrays_of(std::vector<Column> columns)
  {
    struct Group
    {
      std::vector<std::string_view> columns;
      const char* name;
      DataArray::Role role;
    };
    using enum DataArray::Role;
    static const std::vector<Group> groups{ { { "nx", "ny", "nz" }, "Normals", normals },
      { { "red", "green", "blue", "alpha" }, "RGBA", none },
      { { "red", "green", "blue" }, "RGB", none }, { { "s", "t" }, "TCoords", texture_coordinates },
      { { "u", "v" }, "TCoords", texture_coordinates },
      { { "texture_u", "texture_v" }, "TCoords", texture_coordinates } };
    std::vector<DataArray> arrays;
    std::erase_if(columns,
      [](const Column& c)
      { return std::visit([](const auto& v) { return v.empty(); }, c.values); });
    for (std::size_t i = 0; i < columns.size();)
    {
      std::size_t size = 1;
      DataArray array;
      array.name = columns[i].name;
      for (const Group& group : groups)
        if (size == 1 && matches(columns, i, group.columns))
        {
          size = group.columns.size();
          array.name = group.name;
          array.role = group.role;
        }
      if (size == 1 && columns[i].name.ends_with("_0"))
        size = numbered(columns, i, array.name);
      array.components = static_cast<int>(size);
      array.values = interleaved({ columns.data() + i, size });
      arrays.push_back(std::move(array));
      i += size;
    }
    return arrays;
  }

  static bool matches(const std::vector<Column>& columns, std::size_t first,
    const std::vector<std::string_view>& names)
  {
    if (first + names.size() > columns.size())
      return false;
    for (std::size_t k = 0; k < names.size(); ++k)
      if (columns[first + k].name != names[k] ||
        columns[first + k].values.index() != columns[first].values.index())
        return false;
    return true;
  }

  /// How many columns name_0, name_1, … there are; `name` loses its number if more than one.
  static std::size_t numbered(
    const std::vector<Column>& columns, std::size_t first, std::string& name)
  {
    const std::string stem = name.substr(0, name.size() - 2);
    std::size_t size = 1;
    while (first + size < columns.size() &&
      columns[first + size].name == fmt::format("{}_{}", stem, size) &&
      columns[first + size].values.index() == columns[first].values.index())
      ++size;
    if (size > 1)
      name = stem;
    return size;
  }

  static DataArray::Values interleaved(std::span<Column> columns)
  {
    if (columns.size() == 1)
      return std::move(columns[0].values);
    return std::visit(
      [&](const auto& first) -> DataArray::Values
      {
        using Vector = std::decay_t<decltype(first)>;
        Vector all(first.size() * columns.size());
        for (std::size_t k = 0; k < columns.size(); ++k)
        {
          const auto& column = std::get<Vector>(columns[k].values);
          for (std::size_t i = 0; i < column.size(); ++i)
            all[i * columns.size() + k] = column[i];
        }
        return all;
      },
      columns[0].values);
  }

  Body body_;
  const PlyHeader& header_;
  SurfaceFile file_;
  bool has_points_ = false;
  bool has_strips_ = false;
};

}

SurfaceFile read_ply(std::string_view bytes, const std::string& name)
{
  const PlyHeader header = read_header(bytes, name);
  return header.format == Format::ascii
    ? PlyReader<TextBody>(TextBody(bytes, name, header), header).read()
    : PlyReader<BinaryBody>(BinaryBody(bytes, name, header), header).read();
}

}
