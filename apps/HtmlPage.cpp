#include "apps/HtmlPage.h"

#include "apps/JsonText.h"

#include "render/SmoothSurface.h"
#include "render/SurfaceMeasures.h"
#include "render/View.h"
#include "solver/Errors.h"
#include "solver/files/Base64.h"
#include "solver/files/FileBytes.h"
#include "vtkfilters/Filters/MeshConversion.h"

#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <map>
#include <span>
#include <sstream>

namespace vesicle
{
namespace
{

using Json = nlohmann::ordered_json;
using std::filesystem::path;

static_assert(std::endian::native == std::endian::little, "the page reads little-endian numbers");

constexpr std::size_t most_rows = 2000;
constexpr int smooth_triangles = 5000;
constexpr int colors = 256;
constexpr int ticks = 6;

// ---- numbers as text

template<class T>
std::string base64(const std::vector<T>& values)
{
  return vesicle::base64(std::as_bytes(std::span(values)));
}

std::string formatted(const std::string& format, double value)
{
  char text[64];
  std::snprintf(text, sizeof text, format.c_str(), value);
  return text;
}

// ---- the parts of a page

/// <folder of the program>/../share/vesicle
path parts_folder()
{
  return std::filesystem::read_symlink("/proc/self/exe").parent_path().parent_path() / "share" /
    "vesicle";
}

std::string text_of(const path& file)
{
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  if (!in || text.str().empty())
  {
    throw IoError(file.string() + ": can't be read; it belongs to this program's installation");
  }
  return text.str();
}

void replace_all(std::string& text, const std::string& from, const std::string& to)
{
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size()))
  {
    text.replace(at, from.size(), to);
  }
}

/// What would end a script element in the middle of it, or begin a comment there.
std::string inline_script(std::string script)
{
  replace_all(script, "</script", "<\\/script");
  replace_all(script, "<!--", "\\x3C!--");
  return script;
}

struct Parts
{
  std::string page, script, vtk_js, license;
};

Parts read_parts()
{
  const path folder = parts_folder();
  if (!is_file(folder / "vtk.js"))
  {
    throw InputError("--html: this build has no vtk.js to put into pages; configure it with "
                     "-DVESICLE_HTML=ON (which fetches it with npm) and build again");
  }
  return { text_of(folder / "page.html"), text_of(folder / "page.js"), text_of(folder / "vtk.js"),
    text_of(folder / "vtk.js-LICENSE") };
}

// ---- the series

/// One array over all frames.
struct Field
{
  std::string name;
  bool vector = false;
  double neutral = 0;
  RangeFinder finder;
  std::vector<std::vector<double>> frames;
};

struct Series
{
  std::vector<std::vector<float>> points; ///< of each frame, about its centroid
  std::vector<std::vector<std::uint32_t>> triangles;
  std::vector<std::size_t> mesh; ///< of each frame: which of the triangles
  std::vector<Field> fields;
  double radius = 0;
};

bool showable(vtkDataArray* array)
{
  const int components = array->GetNumberOfComponents();
  if (!array->GetName() || std::string(array->GetName()) == "Normals" ||
    (components != 1 && components != 3))
  {
    return false;
  }
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    if (!std::isfinite(scalar_value(array, i)))
    {
      return false;
    }
  }
  return true;
}

std::vector<std::string> names_of_fields(vtkPolyData* surface)
{
  std::vector<std::string> names;
  for (int i = 0; i < surface->GetPointData()->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = surface->GetPointData()->GetArray(i);
    if (array && showable(array))
    {
      names.emplace_back(array->GetName());
    }
  }
  return names;
}

void add_shape(Series& series, vtkPolyData* surface)
{
  const TriangleMesh mesh = to_mesh(surface);
  const Point3 center = surface_centroid(surface);
  std::vector<float> points;
  for (Eigen::Index i = 0; i < mesh.points.rows(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      points.push_back(static_cast<float>(mesh.points(i, k) - center[k]));
    }
  }
  const std::vector<std::uint32_t> triangles(
    mesh.triangles.data(), mesh.triangles.data() + mesh.triangles.size());
  if (series.triangles.empty() || series.triangles.back() != triangles)
  {
    series.triangles.push_back(triangles);
  }
  series.mesh.push_back(series.triangles.size() - 1);
  series.points.push_back(std::move(points));
  Framing framing;
  framing.include(surface, View::named("front"));
  series.radius = std::max(series.radius, framing.radius);
}

void add_values(Field& field, vtkPolyData* surface)
{
  vtkDataArray* array = surface->GetPointData()->GetArray(field.name.c_str());
  field.finder.include(array);
  std::vector<double> values(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] = scalar_value(array, static_cast<long long>(i));
  }
  field.frames.push_back(std::move(values));
}

void add_frame(Series& series, vtkPolyData* surface, bool first)
{
  add_shape(series, surface);
  const auto names = names_of_fields(surface);
  if (first)
  {
    for (const auto& name : names)
    {
      Field field;
      field.name = name;
      field.vector = surface->GetPointData()->GetArray(name.c_str())->GetNumberOfComponents() > 1;
      field.neutral = neutral_value(name, surface);
      series.fields.push_back(std::move(field));
    }
  }
  std::erase_if(series.fields,
    [&](const Field& field)
    { return std::find(names.begin(), names.end(), field.name) == names.end(); });
  for (Field& field : series.fields)
  {
    add_values(field, surface);
  }
}

Series read_series_of(const HtmlPage& page)
{
  Series series;
  SmoothSurface smooth(smooth_triangles);
  for (std::size_t i = 0; i < page.times.size(); ++i)
  {
    try
    {
      auto surface = triangulated(page.frames(static_cast<int>(i)));
      if (page.smooth)
      {
        surface = smooth.refine(surface, names_of_fields(surface)).surface;
      }
      add_frame(series, surface, i == 0);
    }
    catch (const InputError& error)
    {
      throw InputError(fmt::format("frame {} (t = {:.6g}): {}", i, page.times[i], error.what()));
    }
  }
  return series;
}

// ---- as JSON

Json json_of(const Field& field, const std::optional<Range>& range)
{
  double low = field.frames[0][0], high = low;
  for (const auto& values : field.frames)
  {
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    low = std::min(low, *least);
    high = std::max(high, *most);
  }
  const ColorScale scale =
    choose_color_scale(range.value_or(field.finder.range()), field.neutral, field.vector);
  std::vector<std::uint8_t> table;
  for (const Color& color : colors_of_range(scale, colors))
  {
    for (const double c : color)
    {
      table.push_back(static_cast<std::uint8_t>(std::lround(255 * c)));
    }
  }
  const auto marks = round_ticks(scale.range, ticks);
  const std::string format = number_format(marks);
  Json json{ { "name", field.name }, { "title", array_title(field.name, field.vector) },
    { "range", scale.range }, { "extent", Range{ low, high } }, { "colors", base64(table) },
    { "ticks", Json::array() }, { "frames", Json::array() } };
  for (const double mark : marks)
  {
    json["ticks"].push_back({ { "at", (mark - scale.range[0]) / (scale.range[1] - scale.range[0]) },
      { "label", formatted(format, mark) } });
  }
  constexpr double steps = 65535;
  for (const auto& values : field.frames)
  {
    std::vector<std::uint16_t> quantized;
    for (const double value : values)
    {
      const double share = high > low ? (value - low) / (high - low) : 0;
      quantized.push_back(static_cast<std::uint16_t>(std::lround(steps * share)));
    }
    json["frames"].push_back(base64(quantized));
  }
  return json;
}

Json json_of(const RunTable& table, const std::vector<std::string>& chosen)
{
  // Evenly thinned, the first and the last row kept.
  std::vector<std::size_t> rows;
  const std::size_t all = table.rows.size();
  const std::size_t count = std::min(all, most_rows);
  for (std::size_t i = 0; i < count; ++i)
  {
    rows.push_back(count > 1 ? i * (all - 1) / (count - 1) : 0);
  }
  Json json{ { "columns", table.columns }, { "chosen", chosen }, { "values", Json::array() } };
  for (const auto& name : table.columns)
  {
    const auto column = table.column(name);
    Json values = Json::array();
    for (const std::size_t row : rows)
    {
      values.push_back(
        column[row] && std::isfinite(*column[row]) ? Json(*column[row]) : Json(nullptr));
    }
    json["values"].push_back(std::move(values));
  }
  return json;
}

std::string data_of(const HtmlPage& page)
{
  const Series series = read_series_of(page);
  Json data{ { "title", page.title }, { "color", page.color }, { "view", page.view },
    { "smooth", page.smooth }, { "radius", series.radius }, { "frames", Json::array() },
    { "triangles", Json::array() }, { "arrays", Json::array() } };
  const std::string format = page.timed ? "t = " + number_format(page.times) : "%.0f";
  for (std::size_t i = 0; i < page.times.size(); ++i)
  {
    data["frames"].push_back({ { "time", page.times[i] },
      { "label", page.times.size() > 1 || page.timed ? formatted(format, page.times[i]) : "" },
      { "points", base64(series.points[i]) }, { "triangles", series.mesh[i] } });
  }
  for (const auto& triangles : series.triangles)
  {
    data["triangles"].push_back(base64(triangles));
  }
  for (const Field& field : series.fields)
  {
    data["arrays"].push_back(
      json_of(field, field.name == page.color ? page.range : std::optional<Range>{}));
  }
  if (page.table && !page.table->rows.empty())
  {
    data["table"] = json_of(*page.table, page.chart);
  }
  std::string text = json_text(data);
  replace_all(text, "</", "<\\/"); // stays the same JSON, and inside its element
  replace_all(text, "<!--", "\\u003c!--");
  return text;
}

}

void write_html_page(const path& file, const HtmlPage& page)
{
  if (page.times.empty())
  {
    throw InputError("a page needs at least one frame");
  }
  const Parts parts = read_parts();
  // Piece by piece: what is put in is not searched again.
  const std::vector<std::pair<std::string, std::string>> pieces{ { "@DATA@", data_of(page) },
    { "@LICENSE@", parts.license }, { "@VTK_JS@", inline_script(parts.vtk_js) },
    { "@PAGE_JS@", inline_script(parts.script) } };
  std::string text;
  std::size_t done = 0;
  for (const auto& [mark, piece] : pieces)
  {
    const std::size_t at = parts.page.find(mark, done);
    text += parts.page.substr(done, at - done) + piece;
    done = at + mark.size();
  }
  replace_file(file, text + parts.page.substr(done));
}

}
