#include "solver/mesh/io/OffFile.h"

#include "solver/mesh/io/TextScanner.h"

#include <fmt/format.h>

namespace vesicle
{
namespace
{

/// What stands between "OFF" and the points.
struct Header
{
  int words_a_point = 3; ///< with what a free-form file has after the coordinates
  std::int64_t points = 0;
  std::int64_t faces = 0;
};

bool take_prefix(std::string_view& word, std::string_view prefix)
{
  const bool there = word.starts_with(prefix);
  if (there)
    word.remove_prefix(prefix.size());
  return there;
}

/// Words a point of "[ST][C][N][4][n]OFF".
int words_a_point(std::string_view keyword, const TextScanner& scanner)
{
  std::string_view rest = keyword;
  int words = 3;
  if (take_prefix(rest, "ST"))
    words += 2;
  if (take_prefix(rest, "C"))
    words += 4;
  if (take_prefix(rest, "N"))
    words += 3;
  if (rest == "4OFF" || rest == "nOFF" || rest == "4nOFF")
    scanner.fail(fmt::format("'{}' is of points in another space; three coordinates a point are "
                             "needed (OFF)",
      keyword));
  if (rest != "OFF")
    scanner.fail("the first word should be OFF, COFF, NOFF or STOFF");
  return words;
}

Header read_header(TextScanner& scanner)
{
  Header header;
  if (!number_of<std::int64_t>(scanner.peek())) // the keyword may be left out
    header.words_a_point = words_a_point(scanner.word(), scanner);
  if (scanner.peek() == "BINARY")
    scanner.fail("the file is binary, only OFF as text can be read");
  header.points = scanner.number<std::int64_t>("the number of points");
  const bool is_free_form = TextScanner(scanner).word_on_line().empty();
  header.faces = scanner.number<std::int64_t>("the number of faces");
  // That of edges nobody counts; where a line holds the others it may be left out.
  if (is_free_form)
    scanner.number<std::int64_t>("the number of edges");
  else if (!scanner.word_on_line().empty())
    scanner.require_end_of_line();
  if (header.points < 0 || header.faces < 0)
    scanner.fail("the numbers of points and faces should be here");
  scanner.require_words(header.points, "the points");
  scanner.require_words(header.faces, "the faces");
  return header;
}

/// Words on each line of the points, as many on all of them, 3 or more; 0: the points don't have a
/// line each.
int words_a_line(TextScanner scanner, std::int64_t points)
{
  int first = 0;
  for (std::int64_t i = 0; i < points; ++i)
  {
    int words = scanner.word().empty() ? 0 : 1;
    while (words > 0 && !scanner.word_on_line().empty())
      ++words;
    if (words < 3 || (i > 0 && words != first))
      return 0;
    first = words;
  }
  return first;
}

Points read_points(TextScanner& scanner, const Header& header)
{
  const int on_line = words_a_line(scanner, header.points);
  const int words = on_line > 0 ? on_line : header.words_a_point;
  scanner.require_words(3 * static_cast<std::uint64_t>(header.points), "the points");
  Points points(header.points, 3);
  for (std::int64_t i = 0; i < header.points; ++i)
  {
    for (int k = 0; k < 3; ++k)
      points(i, k) = scanner.number<double>("a coordinate");
    for (int k = 3; k < words; ++k)
      scanner.number<double>("a point's normal, colour or texture");
  }
  return points;
}

void read_face(TextScanner& scanner, std::int64_t face, PolygonList& polygons)
{
  const auto size = scanner.number<std::int64_t>("the number of a face's corners");
  if (size < 3)
    scanner.fail(fmt::format("face {} has {} corners, it needs three or more", face, size));
  scanner.require_words(size, "a face's corners");
  for (std::int64_t k = 0; k < size; ++k)
    polygons.corners.push_back(scanner.number<std::int64_t>("a corner of a face"));
  polygons.close(face);
  // A colour: the number in a map, or three or four parts.
  for (int k = 0; k < 4; ++k)
  {
    const auto part = scanner.word_on_line();
    if (part.empty())
      break;
    if (!number_of<double>(part))
      scanner.fail("what stands after a face's corners should be its colour");
  }
  scanner.require_end_of_line();
}

std::string off_points(const TriangleMesh& mesh)
{
  std::string text;
  for (const auto& p : mesh.points.rowwise())
    text += fmt::format("{} {} {}\n", p[0], p[1], p[2]);
  return text;
}

}

SurfaceFile read_off(std::string_view text, const std::string& name)
{
  TextScanner scanner(text, name, TextScanner::Comments::hash);
  const Header header = read_header(scanner);
  SurfaceFile file;
  file.points = read_points(scanner, header);
  for (std::int64_t i = 0; i < header.faces; ++i)
    read_face(scanner, i, file.polygons);
  if (!scanner.at_end())
    scanner.fail(fmt::format("there is more than the {} faces announced", header.faces));
  return file;
}

std::string off_text(const TriangleMesh& mesh)
{
  std::string text = fmt::format("OFF\n{} {} 0\n", mesh.points.rows(), mesh.triangles.rows());
  text += off_points(mesh);
  for (const auto& t : mesh.triangles.rowwise())
    text += fmt::format("3 {} {} {}\n", t[0], t[1], t[2]);
  return text;
}

}
