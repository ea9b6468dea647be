#include "apps/CurvatureSummary.h"

#include "apps/JsonText.h"

#include "solver/Errors.h"
#include "solver/files/FileBytes.h"
#include "vtkfilters/Filters/MeshConversion.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace vesicle
{
namespace
{

constexpr std::array summarized{ "Mean_Curvature", "Gauss_Curvature", "Maximum_Curvature",
  "Minimum_Curvature", "Curvedness", "Shape_Index", "Willmore_Density" };

std::vector<double> areas_of_vertices(const TriangleMesh& mesh)
{
  std::vector<double> areas(mesh.points.rows(), 0);
  for (int t = 0; t < mesh.triangles.rows(); ++t)
  {
    const auto [a, b, c] = corners(mesh, t);
    const double third = (b - a).cross(c - a).norm() / 6;
    for (const int vertex : mesh.triangles.row(t))
    {
      areas[vertex] += third;
    }
  }
  return areas;
}

AreaStatistics statistics_of(
  vtkDataArray* array, vtkDataArray* valid, const std::vector<double>& areas, int bins)
{
  std::vector<double> values, weights;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    if (valid->GetComponent(i, 0) != 0)
    {
      values.push_back(array->GetComponent(i, 0));
      weights.push_back(areas[i]);
    }
  }
  return area_statistics(values, weights, bins);
}

std::string bar(double share, double most)
{
  constexpr double longest = 40;
  return std::string(static_cast<std::size_t>(longest * share / most + 0.5), '#');
}

std::string histogram_text(const std::string& name, const AreaStatistics& s)
{
  std::string text = fmt::format("\n{:>13} {:>13} {:>7}   {}\n", "from", "to", "area", name);
  double most = 0;
  for (const auto& bin : s.bins)
  {
    most = std::max(most, bin.share);
  }
  for (const auto& bin : s.bins)
  {
    text += fmt::format("{:>13.5g} {:>13.5g} {:>6.2f}%   {}\n", bin.from, bin.to, 100 * bin.share,
      bar(bin.share, most));
  }
  return text;
}

std::string percent_name(int percent)
{
  return percent == 50 ? "median" : fmt::format("{}%", percent);
}

std::string table_text(const CurvatureSummary& summary)
{
  std::string text = fmt::format("{:<18}{:>12}{:>12}{:>12}", "", "mean", "deviation", "least");
  for (const int percent : AreaStatistics::percents)
  {
    text += fmt::format("{:>12}", percent_name(percent));
  }
  text += fmt::format("{:>12}\n", "greatest");
  for (const auto& [name, s] : summary)
  {
    text += fmt::format("{:<18}{:>12.5g}{:>12.5g}{:>12.5g}", name, s.mean, s.deviation, s.least);
    for (const double value : s.percentiles)
    {
      text += fmt::format("{:>12.5g}", value);
    }
    text += fmt::format("{:>12.5g}\n", s.greatest);
  }
  return text;
}

nlohmann::ordered_json json_of(const AreaStatistics& s)
{
  nlohmann::ordered_json json{ { "area", s.area }, { "mean", s.mean }, { "deviation", s.deviation },
    { "least", s.least }, { "greatest", s.greatest } };
  for (std::size_t i = 0; i < s.percents.size(); ++i)
  {
    json["percentiles"][std::to_string(s.percents[i])] = s.percentiles[i];
  }
  json["histogram"] = nlohmann::ordered_json::array();
  for (const auto& bin : s.bins)
  {
    json["histogram"].push_back({ { "from", bin.from }, { "to", bin.to }, { "share", bin.share } });
  }
  return json;
}

std::string json_text_of(const CurvatureSummary& summary)
{
  auto json = nlohmann::ordered_json::object();
  for (const auto& [name, s] : summary)
  {
    json[name] = json_of(s);
  }
  return json_text(json, 2) + "\n";
}

std::string csv_text_of(const CurvatureSummary& summary)
{
  std::string text = "array,what,from,to,value\n";
  for (const auto& [array, s] : summary)
  {
    const auto add = [&, &name = array](const std::string& what, double value)
    { text += fmt::format("{},{},,,{}\n", name, what, value); };
    add("area", s.area);
    add("mean", s.mean);
    add("deviation", s.deviation);
    add("least", s.least);
    for (std::size_t i = 0; i < s.percents.size(); ++i)
    {
      add(fmt::format("percentile_{}", s.percents[i]), s.percentiles[i]);
    }
    add("greatest", s.greatest);
    for (const auto& bin : s.bins)
    {
      text += fmt::format("{},share,{},{},{}\n", array, bin.from, bin.to, bin.share);
    }
  }
  return text;
}

}

CurvatureSummary curvature_summary(vtkPolyData* surface, int bins)
{
  CurvatureSummary summary;
  vtkPointData* arrays = surface->GetPointData();
  const std::vector<double> areas = areas_of_vertices(to_mesh(surface));
  vtkDataArray* valid = arrays->GetArray("Curvature_Valid");
  for (const char* name : summarized)
  {
    if (vtkDataArray* array = arrays->GetArray(name); array && valid)
    {
      summary.emplace_back(name, statistics_of(array, valid, areas, bins));
    }
  }
  return summary;
}

std::string to_text(const CurvatureSummary& summary)
{
  if (summary.empty() || !(summary.front().second.area > 0))
  {
    return "curvatures are defined nowhere\n";
  }
  std::string text =
    fmt::format("over an area of {:.6g}\n", summary.front().second.area) + table_text(summary);
  for (const auto& [name, statistics] : summary)
  {
    text += histogram_text(name, statistics);
  }
  return text;
}

void require_summary_ending(const std::filesystem::path& file)
{
  if (file.extension() != ".json" && file.extension() != ".csv")
  {
    throw InputError(file.string() + ": summaries are written as .json or .csv");
  }
}

void write_summary(const CurvatureSummary& summary, const std::filesystem::path& file)
{
  require_summary_ending(file);
  replace_file(file, file.extension() == ".json" ? json_text_of(summary) : csv_text_of(summary));
}

}
