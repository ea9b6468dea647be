#include "XmlArrays.h"

#include "VtkMessages.h"

#include "solver/Errors.h"
#include "solver/mesh/io/ByteReader.h"
#include "solver/mesh/io/TextScanner.h"

#include "vtkDataCompressor.h"
#include "vtkLZ4DataCompressor.h"
#include "vtkLZMADataCompressor.h"
#include "vtkZLibDataCompressor.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

namespace vesicle
{
namespace
{

/// zlib shrinks by 1032 at most, LZ4 by 255; blocks of LZMA that VTK writes by less.
constexpr std::uint64_t most_shrinking = 1100;
constexpr std::uint64_t largest_block = std::numeric_limits<int>::max();

/// What the arrays of a file may take in memory. Points and triangles shrink by a few times; a file
/// of a megabyte that holds gigabytes is one of nothing but zeros, or its arrays share their bytes.
constexpr std::uint64_t memory_of_small_files = std::uint64_t{ 1 } << 28;
constexpr std::uint64_t memory_of_a_byte_in_files = 16;

/// How much memory a byte of an array takes at most: integers may be read as those of 64 bits.
std::uint64_t memory_of_a_byte(const std::string& type)
{
  if (type == "Bit" || type == "String")
    return 64;
  if (type.ends_with("64") || type == "vtkIdType")
    return 1;
  if (type.ends_with("32"))
    return 2;
  return type.ends_with("16") ? 4 : 8;
}

/// −1: none of base64's letters.
int base64_digit(char c)
{
  if (c >= 'A' && c <= 'Z')
    return c - 'A';
  if (c >= 'a' && c <= 'z')
    return c - 'a' + 26;
  if (c >= '0' && c <= '9')
    return c - '0' + 52;
  return c == '+' ? 62 : c == '/' ? 63 : -1;
}

/// All bytes up to what is no base64. Padding ends a part, after which another may follow: VTK
/// encodes the header of compressed data by itself.
std::string decoded(std::string_view text)
{
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3);
  std::uint32_t group = 0;
  int digits = 0, padding = 0;
  for (const char c : text)
  {
    if (c == ' ' || c == '\n' || c == '\r' || c == '\t')
      continue;
    const int digit = base64_digit(c);
    if (c == '=')
      ++padding;
    else if (digit < 0 || padding > 0)
      break;
    group = group << 6 | static_cast<std::uint32_t>(digit < 0 ? 0 : digit);
    if (++digits < 4)
      continue;
    for (int k = 0; k < 3 - padding; ++k)
      bytes += static_cast<char>(group >> (16 - 8 * k) & 0xff);
    group = 0;
    digits = padding = 0;
  }
  return bytes;
}

vtkSmartPointer<vtkDataCompressor> compressor_of(const std::string& type, const std::string& name)
{
  if (type.empty())
    return nullptr;
  if (type == "vtkZLibDataCompressor")
    return vtkSmartPointer<vtkZLibDataCompressor>::New();
  if (type == "vtkLZ4DataCompressor")
    return vtkSmartPointer<vtkLZ4DataCompressor>::New();
  if (type == "vtkLZMADataCompressor")
    return vtkSmartPointer<vtkLZMADataCompressor>::New();
  throw InputError(fmt::format("{}: the compressor '{}' isn't known", name, type));
}

/// The blocks behind the sizes that stand before them.
std::string uncompressed(
  ByteReader& reader, const std::vector<std::uint64_t>& sizes, vtkDataCompressor* compressor)
{
  const std::uint64_t blocks = sizes[0], block = sizes[1], last = sizes[2];
  const VtkMessages quiet;
  std::string bytes;
  for (std::uint64_t i = 0; i < blocks; ++i)
  {
    const std::uint64_t size = i + 1 == blocks && last > 0 ? last : block;
    const auto compressed = reader.take(sizes[3 + i], "a compressed block");
    if (size > most_shrinking * (compressed.size() + 1))
      reader.fail(
        fmt::format("a compressed block of {} bytes can't hold {}", compressed.size(), size));
    const std::size_t first = bytes.size();
    bytes.resize(first + size);
    if (size > 0 &&
      compressor->Uncompress(reinterpret_cast<const unsigned char*>(compressed.data()),
        compressed.size(), reinterpret_cast<unsigned char*>(bytes.data() + first), size) != size)
      reader.fail("a compressed block is damaged");
  }
  return bytes;
}

}

XmlArrays::XmlArrays(const XmlDocument& document, std::string name)
  : document_(document), name_(std::move(name)),
    memory_left_(std::max(memory_of_small_files, memory_of_a_byte_in_files * document.size))
{
  const std::string order = document.root.attribute("byte_order");
  const std::string header = document.root.attribute("header_type");
  if (order != "LittleEndian" && order != "BigEndian" && !order.empty())
    throw InputError(name_ + ": byte_order should be LittleEndian or BigEndian");
  if (header != "UInt32" && header != "UInt64" && !header.empty())
    throw InputError(name_ + ": header_type should be UInt32 or UInt64");
  order_ = order == "BigEndian" ? std::endian::big : std::endian::little;
  wide_headers_ = header == "UInt64";
  compressor_ = compressor_of(document.root.attribute("compressor"), name_);
  if (const XmlElement* appended = document.root.child("AppendedData"))
    appended_as_text_ = appended->attribute("encoding") == "base64";
}

XmlArrays::~XmlArrays() = default;

void XmlArrays::fail(const XmlElement& element, const std::string& problem) const
{
  throw InputError(fmt::format("{}: the array '{}' {}; write the mesh again, or in another format",
    name_, element.attribute("Name"), problem));
}

void XmlArrays::take_memory(const XmlElement& element, std::uint64_t bytes) const
{
  const std::uint64_t memory = memory_of_a_byte(element.attribute("type"));
  if (bytes > memory_left_ / memory)
    fail(element,
      fmt::format("of {} bytes is too much for a file of {}, which it can only be where they "
                  "share their bytes or are all the same",
        bytes, document_.size));
  memory_left_ -= memory * bytes;
}

std::string XmlArrays::bytes_of(const XmlElement& element) const
{
  std::string from_text;
  std::string_view bytes;
  if (element.attribute("format") == "appended")
  {
    const auto offset = number_of<std::uint64_t>(element.attribute("offset"));
    if (!offset || *offset > document_.appended.size())
      fail(element, "begins after the end of the appended data: the file ends too early");
    bytes = document_.appended.substr(*offset);
    if (appended_as_text_)
      bytes = bytes.substr(0, std::min(bytes.find_first_of("<"), bytes.size()));
  }
  if (element.attribute("format") != "appended" || appended_as_text_)
  {
    from_text = decoded(bytes.data() ? bytes : std::string_view(element.text));
    bytes = from_text;
  }
  ByteReader reader(bytes, fmt::format("{}: array '{}'", name_, element.attribute("Name")), order_);
  const auto header = [&]
  {
    return wide_headers_ ? reader.read<std::uint64_t>("the header of an array")
                         : reader.read<std::uint32_t>("the header of an array");
  };
  const std::uint64_t count = header(); // of bytes, or of blocks
  if (!compressor_)
  {
    const auto values = reader.take(count, "the values");
    take_memory(element, values.size());
    return std::string(values);
  }
  if (count == 0)
    return {};
  reader.require(count, wide_headers_ ? 8 : 4, "the sizes of the compressed blocks");
  std::vector<std::uint64_t> sizes{ count };
  for (std::uint64_t i = 0; i < count + 2; ++i)
    sizes.push_back(header());
  const std::uint64_t block = sizes[1], last = sizes[2] > 0 ? sizes[2] : block;
  if (std::max(block, last) > largest_block)
    fail(element, fmt::format("has compressed blocks of {} bytes", std::max(block, last)));
  take_memory(element, (count - 1) * block + last);
  return uncompressed(reader, sizes, compressor_);
}

template<typename T>
std::vector<T> XmlArrays::numbers(const XmlElement& element) const
{
  const std::string format = element.attribute("format");
  if (format == "binary" || format == "appended")
  {
    const std::string bytes = bytes_of(element);
    if (bytes.size() % sizeof(T) != 0)
      fail(element, fmt::format("of numbers of {} bytes has {}", sizeof(T), bytes.size()));
    return ByteReader(bytes, name_, order_).read_array<T>(bytes.size() / sizeof(T), "the values");
  }
  if (!format.empty() && format != "ascii")
    fail(element, "has an unknown format '" + format + "'");
  TextScanner scanner(
    element.text, fmt::format("{}: array '{}'", name_, element.attribute("Name")));
  std::vector<T> values;
  for (auto word = scanner.word(); !word.empty(); word = scanner.word())
  {
    const auto value = number_of<T>(word);
    if (!value)
      scanner.fail("a number of the array's type should be here");
    values.push_back(*value);
  }
  return values;
}

/// Packed eight in a byte, the first one highest; in text one by one.
std::vector<std::uint8_t> XmlArrays::bits(const XmlElement& element) const
{
  const std::string format = element.attribute("format");
  auto packed = numbers<std::uint8_t>(element);
  if (format != "binary" && format != "appended")
    return packed;
  std::vector<std::uint8_t> values(8 * packed.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = packed[i / 8] >> (7 - i % 8) & 1;
  return values;
}

/// Each ends with a zero.
std::vector<std::string> XmlArrays::strings(const XmlElement& element) const
{
  std::vector<std::string> values;
  std::string text;
  for (const std::uint8_t c : numbers<std::uint8_t>(element))
  {
    if (c != 0)
    {
      text += static_cast<char>(c);
      continue;
    }
    values.push_back(std::move(text));
    text.clear();
  }
  if (!text.empty())
    fail(element, "ends within a string");
  return values;
}

DataArray::Values XmlArrays::values_of(const XmlElement& element) const
{
  const std::string type = element.attribute("type");
  if (type == "Int8")
    return numbers<std::int8_t>(element);
  if (type == "UInt8")
    return numbers<std::uint8_t>(element);
  if (type == "Int16")
    return numbers<std::int16_t>(element);
  if (type == "UInt16")
    return numbers<std::uint16_t>(element);
  if (type == "Int32")
    return numbers<std::int32_t>(element);
  if (type == "UInt32")
    return numbers<std::uint32_t>(element);
  if (type == "Int64" || type == "vtkIdType")
    return numbers<std::int64_t>(element);
  if (type == "UInt64")
    return numbers<std::uint64_t>(element);
  if (type == "Float32")
    return numbers<float>(element);
  if (type == "Float64")
    return numbers<double>(element);
  if (type == "Bit")
    return bits(element);
  if (type == "String")
    return strings(element);
  fail(element, "has an unknown type '" + type + "'");
}

DataArray XmlArrays::read(const XmlElement& element) const
{
  DataArray array;
  array.name = element.attribute("Name");
  const std::string components = element.attribute("NumberOfComponents");
  array.components = components.empty() ? 1 : number_of<std::uint16_t>(components).value_or(0);
  if (array.components == 0)
    fail(element, "should have 1 component or more");
  array.values = values_of(element);
  array.ids = element.attribute("IdType") == "1" || element.attribute("type") == "vtkIdType";
  for (int k = 0; k < array.components; ++k)
  {
    const std::string label = element.attribute(fmt::format("ComponentName{}", k));
    if (!label.empty())
    {
      array.component_names.resize(array.components);
      array.component_names[k] = label;
    }
  }
  return array;
}

std::vector<std::int64_t> XmlArrays::read_integers(const XmlElement& element) const
{
  auto all = values_of(element);
  return std::visit(
    [&](auto& values) -> std::vector<std::int64_t>
    {
      using Value = typename std::decay_t<decltype(values)>::value_type;
      if constexpr (std::is_same_v<Value, std::int64_t>)
        return std::move(values);
      else if constexpr (std::is_integral_v<Value>)
        return { values.begin(), values.end() };
      else
        fail(element, "should have integers");
    },
    all);
}

}
