#include "solver/mesh/io/ObjFile.h"

#include "solver/Errors.h"
#include "solver/mesh/io/TextScanner.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace vesicle
{
namespace
{

/// Statements of the format that say nothing of points and faces.
constexpr std::array passed_over{ "vt", "vn", "vp", "g", "o", "s", "mg", "usemtl", "mtllib",
  "usemap", "maplib", "p", "l", "deg", "bmat", "step", "cstype", "curv", "curv2", "surf", "parm",
  "trim", "hole", "scrv", "sp", "end", "con", "bevel", "c_interp", "d_interp", "lod", "shadow_obj",
  "trace_obj", "ctech", "stech", "call", "csh", "bzp", "bsp", "cdc", "cdp", "res" };

bool is_passed_over(std::string_view keyword)
{
  return std::ranges::find(passed_over, keyword) != passed_over.end();
}

/// A backslash at the end of a line joins it to the next one. Both are replaced by blanks; the
/// lines after it are then counted as one.
std::string with_joined_lines(std::string_view text)
{
  std::string joined(text);
  for (std::size_t i = joined.find('\\'); i != std::string::npos; i = joined.find('\\', i + 1))
  {
    const std::size_t line_end = joined.find_first_not_of(" \t", i + 1);
    if (line_end == std::string::npos || (joined[line_end] != '\n' && joined[line_end] != '\r'))
      continue;
    const bool two = joined.compare(line_end, 2, "\r\n") == 0;
    std::fill_n(joined.begin() + static_cast<std::ptrdiff_t>(i), line_end + (two ? 2 : 1) - i, ' ');
  }
  return joined;
}

class ObjReader
{
public:
  ObjReader(std::string_view text, const std::string& name)
    : scanner_(text, name, TextScanner::Comments::hash)
  {
  }

  SurfaceFile read()
  {
    for (auto keyword = scanner_.word(); !keyword.empty(); keyword = scanner_.word())
    {
      if (keyword == "v")
        read_point();
      else if (keyword == "f" || keyword == "fo")
        read_face();
      else if (!is_passed_over(keyword))
        scanner_.fail("the line begins with a word that OBJ files don't know");
      scanner_.rest_of_line();
    }
    file_.points = Eigen::Map<const Points>(
      coordinates_.data(), static_cast<Eigen::Index>(coordinates_.size() / 3), 3);
    if (colours_.size() == coordinates_.size() && !colours_.empty())
      file_.point_data.push_back({ "RGB", 3, std::move(colours_), {}, {}, false });
    return std::move(file_);
  }

private:
  void read_point()
  {
    for (int k = 0; k < 3; ++k)
      coordinates_.push_back(scanner_.number_on_line<double>("a coordinate"));
    // A weight, a colour, or both.
    std::vector<float> more;
    for (auto word = scanner_.word_on_line(); !word.empty(); word = scanner_.word_on_line())
    {
      const auto value = number_of<float>(word);
      if (!value)
        scanner_.fail("what stands after a point's coordinates should be numbers");
      more.push_back(*value);
    }
    if (more.size() == 3 || more.size() == 4)
      colours_.insert(colours_.end(), more.end() - 3, more.end());
  }

  /// "point", "point/texture", "point//normal" or "point/texture/normal".
  void read_face()
  {
    const std::size_t first = file_.polygons.corners.size();
    for (auto word = scanner_.word_on_line(); !word.empty(); word = scanner_.word_on_line())
    {
      const auto corner = number_of<std::int64_t>(word.substr(0, word.find('/')));
      if (!corner || *corner == 0)
        scanner_.fail("a face should be here: three corners or more, counted from 1");
      const auto points = static_cast<std::int64_t>(coordinates_.size() / 3);
      file_.polygons.corners.push_back(*corner < 0 ? points + *corner : *corner - 1);
      if (*corner < 0 && *corner < -points)
        scanner_.fail(fmt::format(
          "the face counts {} points back, but there are {} so far", -(*corner + 1), points));
    }
    if (file_.polygons.corners.size() < first + 3)
      scanner_.fail("a face needs three corners or more");
    file_.polygons.close(file_.polygons.size());
  }

  TextScanner scanner_;
  std::vector<double> coordinates_;
  std::vector<float> colours_; ///< three a point that has one
  SurfaceFile file_;
};

}

SurfaceFile read_obj(std::string_view text, const std::string& name)
{
  const bool joins = text.find('\\') != std::string_view::npos;
  const std::string joined = joins ? with_joined_lines(text) : std::string();
  SurfaceFile file = ObjReader(joins ? joined : text, name).read();
  check_corners(file.polygons, file.points.rows(), name, 1);
  return file;
}

std::string obj_text(const TriangleMesh& mesh, const Points& normals, const Points& colours)
{
  std::string text;
  for (Eigen::Index i = 0; i < mesh.points.rows(); ++i)
  {
    text += fmt::format("v {} {} {}", mesh.points(i, 0), mesh.points(i, 1), mesh.points(i, 2));
    if (colours.rows() > 0)
      text += fmt::format(" {} {} {}", colours(i, 0), colours(i, 1), colours(i, 2));
    text += '\n';
  }
  for (const auto& n : normals.rowwise())
    text += fmt::format("vn {} {} {}\n", n[0], n[1], n[2]);
  for (const auto& triangle : mesh.triangles.rowwise())
  {
    text += 'f';
    for (const int corner : triangle)
      text += normals.rows() > 0 ? fmt::format(" {}//{}", corner + 1, corner + 1)
                                 : fmt::format(" {}", corner + 1);
    text += '\n';
  }
  return text;
}

}
