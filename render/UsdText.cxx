// Universal Scene Description as text: one mesh, which may change with time.

#include "render/Model.h"

#include <fmt/format.h>

#include <algorithm>

namespace vesicle
{
namespace
{

constexpr int frames_a_second = 24;

std::string value_of(const Points& rows)
{
  std::string text = "[";
  for (const auto& row : rows.rowwise())
    text += fmt::format("{}({}, {}, {})", text.size() > 1 ? ", " : "", static_cast<float>(row[0]),
      static_cast<float>(row[1]), static_cast<float>(row[2]));
  return text + "]";
}

std::string value_of(const Triangles& triangles)
{
  std::string text = "[";
  for (const auto& t : triangles.rowwise())
    text += fmt::format("{}{}, {}, {}", text.size() > 1 ? ", " : "", t[0], t[1], t[2]);
  return text + "]";
}

std::string value_of(const Vector3& v)
{
  return fmt::format("({}, {}, {})", v[0], v[1], v[2]);
}

/// How many corners each face has.
std::string counts_of(const Triangles& triangles)
{
  std::string text = "[";
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
    text += t > 0 ? ", 3" : "3";
  return text + "]";
}

/// `value` of each frame, or once where it is always the same.
template<class Value>
std::string attribute(const std::string& name, const std::vector<Model>& frames, const Value& value)
{
  std::vector<std::string> values;
  for (const Model& frame : frames)
    values.push_back(value(frame));
  const auto differs = [&](const std::string& other) { return other != values.front(); };
  if (std::none_of(values.begin(), values.end(), differs))
    return fmt::format("    {} = {}\n", name, values.front());
  std::string text = fmt::format("    {}.timeSamples = {{\n", name);
  for (std::size_t i = 0; i < values.size(); ++i)
    text += fmt::format("        {}: {},\n", i, values[i]);
  return text + "    }\n";
}

/// One value a point.
std::string of_points(const std::string& name)
{
  return fmt::format("    {} (\n        interpolation = \"vertex\"\n    )\n", name);
}

bool is_identifier(char c)
{
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

std::string identifier(std::string name)
{
  std::replace_if(
    name.begin(), name.end(), [](char c) { return !is_identifier(c); }, '_');
  const bool starts = !name.empty() && !(name.front() >= '0' && name.front() <= '9');
  return starts ? name : "_" + name;
}

}

std::string usd_text(const std::vector<Model>& frames, const std::string& name)
{
  const std::string prim = identifier(name);
  std::string text =
    fmt::format("#usda 1.0\n(\n    defaultPrim = \"{}\"\n    upAxis = \"Z\"\n", prim);
  if (frames.size() > 1)
    text +=
      fmt::format("    startTimeCode = 0\n    endTimeCode = {}\n    timeCodesPerSecond = {}\n",
        frames.size() - 1, frames_a_second);
  text += fmt::format(")\n\ndef Mesh \"{}\"\n{{\n", prim);
  text += "    uniform token subdivisionScheme = \"none\"\n    uniform bool doubleSided = 1\n";
  text += attribute(
    "int[] faceVertexCounts", frames, [](const Model& m) { return counts_of(m.triangles); });
  text += attribute(
    "int[] faceVertexIndices", frames, [](const Model& m) { return value_of(m.triangles); });
  text += attribute("point3f[] points", frames, [](const Model& m) { return value_of(m.points); });
  text += of_points("normal3f[] normals");
  text +=
    attribute("normal3f[] normals", frames, [](const Model& m) { return value_of(m.normals); });
  text += of_points("color3f[] primvars:displayColor");
  text += attribute(
    "color3f[] primvars:displayColor", frames, [](const Model& m) { return value_of(m.colors); });
  text += attribute(
    "double3 xformOp:translate", frames, [](const Model& m) { return value_of(m.place); });
  return text + "    uniform token[] xformOpOrder = [\"xformOp:translate\"]\n}\n";
}

}
