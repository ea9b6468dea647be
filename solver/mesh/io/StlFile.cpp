#include "solver/mesh/io/StlFile.h"

#include "solver/Errors.h"
#include "solver/mesh/io/ByteReader.h"
#include "solver/mesh/io/PointNumbers.h"
#include "solver/mesh/io/TextScanner.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cstring>

namespace vesicle
{
namespace
{

constexpr std::size_t header_bytes = 84;
constexpr std::size_t facet_bytes = 50;

std::uint32_t announced_facets(std::string_view bytes, const std::string& name)
{
  ByteReader reader(bytes, name, std::endian::little);
  reader.take(80, "the header");
  return reader.read<std::uint32_t>("the number of triangles");
}

SurfaceFile read_binary(std::string_view bytes, const std::string& name)
{
  ByteReader reader(bytes, name, std::endian::little);
  reader.take(80, "the header");
  const auto facets = reader.read<std::uint32_t>("the number of triangles");
  SurfaceFile file;
  file.single_precision = true;
  PointNumbers numbers;
  for (std::uint32_t i = 0; i < facets; ++i)
  {
    reader.take(12, "a normal");
    for (int k = 0; k < 3; ++k)
    {
      std::array<double, 3> corner;
      for (double& x : corner)
        x = reader.read<float>("a coordinate");
      file.polygons.corners.push_back(numbers.number(corner).first);
    }
    file.polygons.close(i);
    reader.take(2, "the attribute");
  }
  file.points = numbers.points();
  return file;
}

std::string in_lower_case(std::string_view word)
{
  std::string result(word);
  for (char& c : result)
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

/// solid NAME, facets, endsolid NAME, as often as there are solids.
class TextStl
{
public:
  TextStl(std::string_view text, const std::string& name) : scanner_(text, name) {}

  SurfaceFile read()
  {
    while (!scanner_.at_end())
    {
      expect("solid");
      scanner_.rest_of_line();
      while (read_facet())
      {
      }
      scanner_.rest_of_line();
    }
    file_.points = numbers_.points();
    return std::move(file_);
  }

private:
  void expect(std::string_view keyword)
  {
    const auto word = scanner_.word();
    if (word.empty())
      scanner_.fail(fmt::format("the file ends too early, where '{}' should be", keyword));
    if (in_lower_case(word) != keyword)
      scanner_.fail(fmt::format("'{}' should be here", keyword));
  }

  /// False at endsolid.
  bool read_facet()
  {
    const std::string word = in_lower_case(scanner_.word());
    if (word == "endsolid")
      return false;
    if (word.empty())
      scanner_.fail("the file ends too early, where 'endsolid' should be");
    if (word != "facet")
      scanner_.fail("'facet' or 'endsolid' should be here");
    scanner_.rest_of_line(); // the normal, which the corners say better
    expect("outer");
    expect("loop");
    for (int k = 0; k < 3; ++k)
    {
      expect("vertex");
      std::array<double, 3> corner;
      for (double& x : corner)
        x = scanner_.number<double>("a coordinate");
      file_.polygons.corners.push_back(numbers_.number(corner).first);
    }
    file_.polygons.close(file_.polygons.size());
    expect("endloop");
    expect("endfacet");
    return true;
  }

  TextScanner scanner_;
  PointNumbers numbers_;
  SurfaceFile file_;
};

/// A text begins so, after a byte order mark and blanks.
bool begins_with_solid(std::string_view bytes)
{
  constexpr std::size_t looked_at = 256;
  TextScanner scanner(bytes.substr(0, looked_at), "");
  return in_lower_case(scanner.word()) == "solid";
}

}

SurfaceFile read_stl(std::string_view bytes, const std::string& name)
{
  if (bytes.size() >= header_bytes &&
    bytes.size() == header_bytes + facet_bytes * announced_facets(bytes, name))
    return read_binary(bytes, name);
  if (begins_with_solid(bytes))
    return TextStl(bytes, name).read();
  if (bytes.size() < header_bytes)
    throw InputError(fmt::format("{}: is not an STL file: {} bytes are neither text that begins "
                                 "with 'solid' nor a header of {} bytes",
      name, bytes.size(), header_bytes));
  const auto facets = announced_facets(bytes, name);
  throw InputError(fmt::format(
    "{}: {}: a binary one of the {} triangles that bytes 81 to 84 announce has {} bytes, this has "
    "{}; write the mesh again, or in another format",
    name,
    bytes.size() < header_bytes + facet_bytes * facets
      ? "ends too early, or is not an STL file"
      : "is not an STL file, or something follows it",
    facets, header_bytes + facet_bytes * facets, bytes.size()));
}

std::string stl_bytes(const TriangleMesh& mesh)
{
  std::string bytes = "binary STL";
  bytes.resize(80, ' ');
  const auto append = [&](auto value)
  {
    std::array<char, sizeof(value)> raw;
    std::memcpy(raw.data(), &value, sizeof(value));
    if constexpr (std::endian::native == std::endian::big)
      std::reverse(raw.begin(), raw.end());
    bytes.append(raw.data(), raw.size());
  };
  append(static_cast<std::uint32_t>(mesh.triangles.rows()));
  for (int t = 0; t < mesh.triangles.rows(); ++t)
  {
    const auto triangle = corners(mesh, t);
    const auto& [a, b, c] = triangle;
    const Vector3 normal = (b - a).cross(c - a).normalized();
    for (const Vector3& x : { normal, a, b, c })
      for (const double coordinate : x)
        append(static_cast<float>(coordinate));
    append(std::uint16_t(0));
  }
  return bytes;
}

}
