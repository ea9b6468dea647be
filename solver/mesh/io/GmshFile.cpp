#include "solver/mesh/io/GmshFile.h"

#include "solver/mesh/io/ByteReader.h"
#include "solver/mesh/io/TextScanner.h"

#include <fmt/format.h>

#include <array>
#include <span>
#include <unordered_map>

namespace vesicle
{
namespace
{

/// gmsh's numbers of its elements.
enum ElementType
{
  triangle = 2,
  quadrilateral = 3,
  triangle_of_second_order = 9
};

/// Nodes of an element by its type; 0: gmsh has no such type, or it isn't known here.
int nodes_of(std::int64_t type)
{
  static constexpr std::array<int, 32> nodes{ 0, 2, 3, 4, 4, 8, 6, 5, 3, 6, 9, 10, 27, 18, 14, 1, 8,
    20, 15, 13, 9, 10, 12, 15, 15, 21, 4, 5, 6, 20, 35, 56 };
  const bool known = type > 0 && type < static_cast<std::int64_t>(nodes.size());
  return known ? nodes[static_cast<std::size_t>(type)] : type == 92 ? 64 : type == 93 ? 125 : 0;
}

struct GmshFormat
{
  bool version_4;
  bool binary;
  std::endian order = std::endian::native;
};

/// The numbers of a section that is text.
class TextNumbers
{
public:
  explicit TextNumbers(TextScanner& scanner) : scanner_(scanner) {}

  std::int64_t integer(std::string_view what) { return scanner_.number<std::int64_t>(what); }
  std::int64_t count(std::string_view what)
  {
    const auto count = scanner_.number<std::int64_t>(what);
    if (count < 0)
      fail(fmt::format("{} can't be {}", what, count));
    return count;
  }
  double real(std::string_view what) { return scanner_.number<double>(what); }
  void require(std::int64_t count, int numbers_each, std::string_view what) const
  {
    scanner_.require_words(static_cast<std::uint64_t>(count), what); // no product overflows then
    scanner_.require_words(static_cast<std::uint64_t>(count) * numbers_each, what);
  }
  [[noreturn]] void fail(const std::string& problem) const { scanner_.fail(problem); }
  void finish() {}

private:
  TextScanner& scanner_;
};

/// The same of a binary one: integers have 4 bytes, counts and tags in version 4 have 8.
class BinaryNumbers
{
public:
  BinaryNumbers(
    TextScanner& scanner, std::string_view bytes, const std::string& name, const GmshFormat& format)
    : scanner_(scanner), reader_(bytes.substr(scanner.position()), name, format.order),
      wide_(format.version_4)
  {
  }

  std::int64_t integer(std::string_view what) { return reader_.read<std::int32_t>(what); }
  std::int64_t count(std::string_view what)
  {
    const std::int64_t count = wide_ ? reader_.read<std::int64_t>(what) : integer(what);
    if (count < 0)
      fail(fmt::format("{} can't be {}", what, count));
    return count;
  }
  double real(std::string_view what) { return reader_.read<double>(what); }
  void require(std::int64_t count, int numbers_each, std::string_view what) const
  {
    reader_.require(static_cast<std::uint64_t>(count), numbers_each * sizeof(std::int32_t), what);
  }
  [[noreturn]] void fail(const std::string& problem) const { reader_.fail(problem); }
  /// Text goes on where the numbers end.
  void finish() { scanner_.skip(reader_.position()); }

private:
  TextScanner& scanner_;
  ByteReader reader_;
  bool wide_;
};

/// What a file's sections say together.
class GmshMesh
{
public:
  void add_node(std::int64_t tag, const std::array<double, 3>& at)
  {
    place_.insert_or_assign(tag, static_cast<std::int64_t>(coordinates_.size() / 3));
    coordinates_.insert(coordinates_.end(), at.begin(), at.end());
  }

  template<class Numbers>
  void add_element(std::int64_t type, std::span<const std::int64_t> tags, const Numbers& numbers)
  {
    const std::int64_t cell = elements_++;
    if (type != triangle && type != quadrilateral && type != triangle_of_second_order)
      return;
    std::array<std::int64_t, 6> corner{};
    for (std::size_t k = 0; k < tags.size(); ++k)
    {
      const auto found = place_.find(tags[k]);
      if (found == place_.end())
        numbers.fail(fmt::format("element {} has a node {}, which isn't in $Nodes", cell, tags[k]));
      corner[k] = found->second;
    }
    if (type != triangle_of_second_order)
      return polygons_.add(std::span(corner).first(tags.size()), cell);
    // Corners 0 to 2, and 3 to 5 in the middle of the edges 01, 12, 20.
    for (const auto& [a, b, c] : { std::array{ 0, 3, 5 }, { 3, 1, 4 }, { 5, 4, 2 }, { 3, 4, 5 } })
      polygons_.add(std::array{ corner[a], corner[b], corner[c] }, cell);
  }

  /// Without nodes that no polygon uses: centres of circles, what is inside.
  SurfaceFile surface() &&
  {
    const auto nodes = static_cast<std::int64_t>(coordinates_.size() / 3);
    std::vector<std::int64_t> number(nodes, -1);
    for (const std::int64_t corner : polygons_.corners)
      number[corner] = 0;
    std::int64_t used = 0;
    for (std::int64_t& n : number)
      n = n < 0 ? n : used++;
    SurfaceFile file;
    file.points.resize(used, 3);
    for (std::int64_t i = 0; i < nodes; ++i)
      if (number[i] >= 0)
        file.points.row(number[i]) = Eigen::Map<const Eigen::RowVector3d>(&coordinates_[3 * i]);
    for (std::int64_t& corner : polygons_.corners)
      corner = number[corner];
    file.polygons = std::move(polygons_);
    return file;
  }

  bool has_polygons() const { return polygons_.size() > 0; }
  std::int64_t elements() const { return elements_; }

private:
  std::vector<double> coordinates_;
  std::unordered_map<std::int64_t, std::int64_t> place_; ///< of a node's tag
  PolygonList polygons_;
  std::int64_t elements_ = 0;
};

template<class Numbers>
std::array<double, 3> read_point(Numbers& numbers)
{
  std::array<double, 3> at;
  for (double& x : at)
    x = numbers.real("a coordinate");
  return at;
}

template<class Numbers>
void read_nodes_2(Numbers& numbers, std::int64_t count, GmshMesh& mesh)
{
  numbers.require(count, 4, "the nodes");
  for (std::int64_t i = 0; i < count; ++i)
  {
    const std::int64_t tag = numbers.integer("the number of a node");
    mesh.add_node(tag, read_point(numbers));
  }
}

/// The head of a section of version 4: how many blocks it has, of `what`.
template<class Numbers>
std::int64_t read_blocks(Numbers& numbers, const std::string& what)
{
  const std::int64_t blocks = numbers.count("the number of blocks of " + what);
  for (const std::string& of_all :
    { "the number of " + what, std::string("the least tag"), std::string("the greatest tag") })
    numbers.count(of_all);
  numbers.require(blocks, 4, "the blocks of " + what);
  return blocks;
}

template<class Numbers>
void read_nodes_4(Numbers& numbers, GmshMesh& mesh)
{
  const std::int64_t blocks = read_blocks(numbers, "nodes");
  for (std::int64_t b = 0; b < blocks; ++b)
  {
    const std::int64_t dimension = numbers.integer("the dimension of an entity");
    numbers.integer("the tag of an entity");
    const bool parametric = numbers.integer("whether nodes have parameters") != 0;
    const std::int64_t count = numbers.count("the number of nodes in a block");
    numbers.require(count, 4, "the nodes");
    std::vector<std::int64_t> tags(count);
    for (std::int64_t& tag : tags)
      tag = numbers.count("the tag of a node");
    for (const std::int64_t tag : tags)
    {
      mesh.add_node(tag, read_point(numbers));
      for (std::int64_t k = 0; parametric && k < dimension; ++k)
        numbers.real("a parameter of a node");
    }
  }
}

template<class Numbers>
int known_nodes(Numbers& numbers, std::int64_t type)
{
  const int nodes = nodes_of(type);
  if (nodes == 0)
    numbers.fail(fmt::format("there is no type {} of elements", type));
  return nodes;
}

/// One element after another, each with its type.
void read_elements_2(TextNumbers& numbers, std::int64_t count, GmshMesh& mesh)
{
  numbers.require(count, 4, "the elements");
  for (std::int64_t i = 0; i < count; ++i)
  {
    numbers.integer("the number of an element");
    const std::int64_t type = numbers.integer("the type of an element");
    const std::int64_t tags = numbers.count("the number of an element's tags");
    numbers.require(tags, 1, "an element's tags");
    for (std::int64_t k = 0; k < tags; ++k)
      numbers.integer("a tag of an element");
    std::vector<std::int64_t> nodes(known_nodes(numbers, type));
    for (std::int64_t& node : nodes)
      node = numbers.integer("a node of an element");
    mesh.add_element(type, nodes, numbers);
  }
}

/// Runs of elements of one type.
void read_elements_2(BinaryNumbers& numbers, std::int64_t count, GmshMesh& mesh)
{
  for (const std::int64_t all = mesh.elements() + count; mesh.elements() < all;)
  {
    const std::int64_t type = numbers.integer("the type of elements");
    const std::int64_t run = numbers.count("how many follow");
    const std::int64_t tags = numbers.count("the number of an element's tags");
    const int size = known_nodes(numbers, type);
    if (run == 0 || run > all - mesh.elements())
      numbers.fail(fmt::format("{} elements follow, and {} are announced", run, count));
    numbers.require(run, 2, "the elements");
    numbers.require(tags, 1, "an element's tags");
    std::vector<std::int64_t> nodes(size);
    for (std::int64_t i = 0; i < run; ++i)
    {
      for (std::int64_t k = 0; k < 1 + tags; ++k)
        numbers.integer("a tag of an element");
      for (std::int64_t& node : nodes)
        node = numbers.integer("a node of an element");
      mesh.add_element(type, nodes, numbers);
    }
  }
}

template<class Numbers>
void read_elements_4(Numbers& numbers, GmshMesh& mesh)
{
  const std::int64_t blocks = read_blocks(numbers, "elements");
  for (std::int64_t b = 0; b < blocks; ++b)
  {
    numbers.integer("the dimension of an entity");
    numbers.integer("the tag of an entity");
    const std::int64_t type = numbers.integer("the type of elements");
    const std::int64_t count = numbers.count("the number of elements in a block");
    numbers.require(count, 2, "the elements");
    std::vector<std::int64_t> nodes(known_nodes(numbers, type));
    for (std::int64_t i = 0; i < count; ++i)
    {
      numbers.count("the tag of an element");
      for (std::int64_t& node : nodes)
        node = numbers.count("a node of an element");
      mesh.add_element(type, nodes, numbers);
    }
  }
}

class GmshReader
{
public:
  GmshReader(std::string_view bytes, const std::string& name)
    : bytes_(bytes), name_(name), scanner_(bytes, name)
  {
  }

  SurfaceFile read()
  {
    read_format();
    while (!scanner_.at_end())
      read_section(std::string(scanner_.word()));
    if (!mesh_.has_polygons())
      scanner_.fail("there are no triangles among the elements; have gmsh save the surface "
                    "(Physical Surface)");
    return std::move(mesh_).surface();
  }

private:
  void read_format()
  {
    if (scanner_.word() != "$MeshFormat")
      scanner_.fail("the first word should be $MeshFormat");
    scanner_.rest_of_line();
    const std::string version(scanner_.word_on_line());
    const bool is_2 = version == "2" || version.starts_with("2.");
    if (!is_2 && version != "4.1")
      scanner_.fail(fmt::format("MSH {} can't be read; write 2.2 or 4.1 (gmsh -format msh41)",
        number_of<double>(version) ? version : "of this version"));
    const auto type = scanner_.number_on_line<int>("the file's type");
    const auto size = scanner_.number_on_line<int>("the size of a number");
    scanner_.rest_of_line();
    if ((type != 0 && type != 1) || size != sizeof(double))
      scanner_.fail(fmt::format("type {} with numbers of {} bytes can't be read", type, size));
    format_ = { !is_2, type == 1 };
    if (format_.binary)
      read_order();
    require_end("$EndMeshFormat");
  }

  void read_order()
  {
    ByteReader reader(bytes_.substr(scanner_.position()), name_);
    if (const auto one = reader.read<std::int32_t>("the number 1"); one == 1 << 24)
      format_.order =
        std::endian::native == std::endian::little ? std::endian::big : std::endian::little;
    else if (one != 1)
      scanner_.fail("the number 1, which tells the byte order, should be here");
    scanner_.skip(reader.position());
  }

  void read_section(const std::string& keyword)
  {
    if (!keyword.starts_with('$'))
      scanner_.fail("a section's name, $ and a word, should be here");
    const std::string end = "$End" + keyword.substr(1);
    if (keyword == "$Nodes" || keyword == "$Elements")
    {
      const bool nodes = keyword == "$Nodes";
      scanner_.rest_of_line();
      if (format_.version_4)
        with_numbers([&](auto& numbers)
          { nodes ? read_nodes_4(numbers, mesh_) : read_elements_4(numbers, mesh_); });
      else
        read_section_2(nodes);
      require_end(end);
    }
    else
      pass_over(end);
  }

  /// What else files have: names, entities, data. Of text the scanner counts the lines.
  void pass_over(const std::string& end)
  {
    const auto at = bytes_.find(end, scanner_.position());
    if (at == std::string_view::npos)
      scanner_.fail(fmt::format("the file ends too early, before {}", end));
    while (!format_.binary && scanner_.position() < at)
      scanner_.word();
    if (format_.binary)
      scanner_.skip(at + end.size() - scanner_.position());
  }

  /// The count is text in binary files, too.
  void read_section_2(bool nodes)
  {
    const auto count = scanner_.number<std::int32_t>("how many there are");
    if (count < 0)
      scanner_.fail(fmt::format("{} can't be a number of things", count));
    scanner_.rest_of_line();
    with_numbers([&](auto& numbers)
      { nodes ? read_nodes_2(numbers, count, mesh_) : read_elements_2(numbers, count, mesh_); });
  }

  template<class Read>
  void with_numbers(const Read& read)
  {
    if (format_.binary)
    {
      BinaryNumbers numbers(scanner_, bytes_, name_, format_);
      read(numbers);
      numbers.finish();
    }
    else
    {
      TextNumbers numbers(scanner_);
      read(numbers);
    }
  }

  void require_end(const std::string& keyword)
  {
    if (scanner_.word() != keyword)
      scanner_.fail(keyword + " should be here");
  }

  std::string_view bytes_;
  std::string name_;
  TextScanner scanner_;
  GmshFormat format_{};
  GmshMesh mesh_;
};

}

SurfaceFile read_gmsh(std::string_view bytes, const std::string& name)
{
  return GmshReader(bytes, name).read();
}

std::string gmsh_text(const TriangleMesh& mesh)
{
  std::string text =
    fmt::format("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{}\n", mesh.points.rows());
  for (Eigen::Index i = 0; i < mesh.points.rows(); ++i)
    text +=
      fmt::format("{} {} {} {}\n", i + 1, mesh.points(i, 0), mesh.points(i, 1), mesh.points(i, 2));
  text += fmt::format("$EndNodes\n$Elements\n{}\n", mesh.triangles.rows());
  // Two tags, as gmsh wants: of a physical group and of the surface.
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t)
    text += fmt::format("{} 2 2 1 1 {} {} {}\n", t + 1, mesh.triangles(t, 0) + 1,
      mesh.triangles(t, 1) + 1, mesh.triangles(t, 2) + 1);
  return text + "$EndElements\n";
}

}
