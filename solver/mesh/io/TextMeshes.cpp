#include "solver/mesh/io/TextMeshes.h"

#include "solver/Errors.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <iterator>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

namespace vesicle
{
namespace
{

/// The lines that say something, one after the other.
class Lines
{
public:
  Lines(const std::string& text, const std::string& name) : text_(text), name_(name) {}

  /// The next line that isn't empty or a comment; empty at the end.
  std::optional<std::istringstream> next()
  {
    std::string line;
    while (std::getline(text_, line))
    {
      ++number_;
      line = line.substr(0, line.find('#'));
      if (line.find_first_not_of(" \t\r") != std::string::npos)
      {
        return std::istringstream(line);
      }
    }
    return {};
  }
  std::istringstream next(const std::string& expected)
  {
    auto line = next();
    if (!line)
    {
      fail("the file ends where " + expected + " should be");
    }
    return std::move(*line);
  }

  [[noreturn]] void fail(const std::string& problem) const
  {
    throw InputError(fmt::format(
      "{}:{}: {}; write the mesh again, or in another format", name_, number_, problem));
  }

private:
  std::istringstream text_;
  std::string name_;
  int number_ = 0;
};

struct Counts
{
  long points = 0;
  long faces = 0;
};

/// "OFF" and the counts, on one line or on two.
Counts read_counts(Lines& lines)
{
  auto line = lines.next("OFF");
  std::string word;
  line >> word;
  if (word != "OFF")
  {
    lines.fail("the first word is '" + word + "' instead of OFF");
  }
  Counts counts;
  if (!(line >> counts.points))
  {
    line = lines.next("the numbers of points and faces");
    line >> counts.points;
  }
  if (!(line >> counts.faces) || counts.points < 0 || counts.faces < 0)
  {
    lines.fail("the numbers of points and faces should be here");
  }
  return counts;
}

using Point = std::array<double, 3>;
using Triangle = std::array<int, 3>;

Point read_point(std::istringstream line, const Lines& lines)
{
  Point point;
  if (!(line >> point[0] >> point[1] >> point[2]))
  {
    lines.fail("three coordinates should be here");
  }
  return point;
}

void check_corner(long corner, std::size_t points, const Lines& lines)
{
  if (corner < 0 || corner >= static_cast<long>(points))
  {
    lines.fail(fmt::format("there is no point {} among {}, counted from 0", corner, points));
  }
}

/// A polygon as triangles from its first corner.
void add_polygon(const std::vector<int>& corners, std::vector<Triangle>& triangles)
{
  for (std::size_t i = 2; i < corners.size(); ++i)
  {
    triangles.push_back({ corners[0], corners[i - 1], corners[i] });
  }
}

TriangleMesh mesh_of(const std::vector<Point>& points, const std::vector<Triangle>& triangles)
{
  TriangleMesh mesh{ Points(points.size(), 3), Triangles(triangles.size(), 3) };
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    mesh.points.row(i) << points[i][0], points[i][1], points[i][2];
  }
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    mesh.triangles.row(i) << triangles[i][0], triangles[i][1], triangles[i][2];
  }
  return mesh;
}

std::vector<int> read_off_face(Lines& lines, std::size_t points)
{
  auto line = lines.next("a face");
  int size = 0;
  line >> size;
  std::vector<int> corners;
  for (int corner; static_cast<int>(corners.size()) < size && line >> corner;)
  {
    check_corner(corner, points, lines);
    corners.push_back(corner);
  }
  if (size < 3 || static_cast<int>(corners.size()) < size)
  {
    lines.fail("a face should be here: the number of its corners (3 or more), then their points");
  }
  return corners;
}

/// Corners are "point", "point/texture" or "point/texture/normal", from 1 or back from the last
/// (−1).
std::vector<int> read_obj_face(std::istringstream& line, std::size_t points, const Lines& lines)
{
  std::vector<int> corners;
  for (std::string word; line >> word;)
  {
    long corner = 0;
    const auto end = word.data() + word.size();
    if (std::from_chars(word.data(), end, corner).ec != std::errc())
    {
      lines.fail("'" + word + "' is not a corner of a face");
    }
    corner = corner < 0 ? static_cast<long>(points) + corner : corner - 1;
    check_corner(corner, points, lines);
    corners.push_back(static_cast<int>(corner));
  }
  if (corners.size() < 3)
  {
    lines.fail("a face needs three corners or more");
  }
  return corners;
}

std::string point_lines(const TriangleMesh& mesh, const char* prefix)
{
  std::string text;
  for (const auto& p : mesh.points.rowwise())
  {
    fmt::format_to(std::back_inserter(text), "{}{} {} {}\n", prefix, p[0], p[1], p[2]);
  }
  return text;
}

std::string face_lines(const TriangleMesh& mesh, const char* prefix, int first)
{
  std::string text;
  for (const auto& t : mesh.triangles.rowwise())
  {
    fmt::format_to(
      std::back_inserter(text), "{} {} {} {}\n", prefix, t[0] + first, t[1] + first, t[2] + first);
  }
  return text;
}

}

TriangleMesh parse_off(const std::string& text, const std::string& name)
{
  Lines lines(text, name);
  const Counts counts = read_counts(lines);
  std::vector<Point> points;
  for (long i = 0; i < counts.points; ++i)
  {
    points.push_back(read_point(lines.next("a point"), lines));
  }
  std::vector<Triangle> triangles;
  for (long i = 0; i < counts.faces; ++i)
  {
    add_polygon(read_off_face(lines, points.size()), triangles);
  }
  return mesh_of(points, triangles);
}

TriangleMesh parse_obj(const std::string& text, const std::string& name)
{
  Lines lines(text, name);
  std::vector<Point> points;
  std::vector<Triangle> triangles;
  while (auto line = lines.next())
  {
    std::string word;
    *line >> word;
    if (word == "v")
    {
      points.push_back(read_point(std::move(*line), lines));
    }
    else if (word == "f")
    {
      add_polygon(read_obj_face(*line, points.size(), lines), triangles);
    }
  }
  return mesh_of(points, triangles);
}

std::string off_text(const TriangleMesh& mesh)
{
  return fmt::format("OFF\n{} {} 0\n", mesh.points.rows(), mesh.triangles.rows()) +
    point_lines(mesh, "") + face_lines(mesh, "3", 0);
}

std::string obj_text(const TriangleMesh& mesh)
{
  return point_lines(mesh, "v ") + face_lines(mesh, "f", 1);
}

}
