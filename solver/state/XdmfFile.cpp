#include "solver/state/XdmfFile.h"

#include "solver/state/XmlText.h"

#include <fmt/format.h>

namespace vesicle
{
namespace
{

constexpr const char* doubles = "NumberType=\"Float\" Precision=\"8\"";
constexpr const char* integers = "NumberType=\"Int\" Precision=\"4\"";

std::string data_item(
  const XdmfFrame& frame, const std::string& dataset, const char* type, long rows, long components)
{
  const std::string size =
    components == 1 ? fmt::format("{}", rows) : fmt::format("{} {}", rows, components);
  return fmt::format("<DataItem Dimensions=\"{}\" {} Format=\"HDF\">{}:/{}</DataItem>", size, type,
    xml_text(frame.file.generic_string()), xml_text(dataset));
}

const char* attribute_type(long components)
{
  switch (components)
  {
    case 1:
      return "Scalar";
    case 3:
      return "Vector";
    case 6:
      return "Tensor6";
    case 9:
      return "Tensor";
    default:
      return "Matrix";
  }
}

std::string attribute(
  const std::string& name, const char* center, long components, const std::string& item)
{
  return fmt::format(
    "        <Attribute Name=\"{}\" AttributeType=\"{}\" Center=\"{}\">{}</Attribute>\n",
    xml_text(name), attribute_type(components), center, item);
}

std::string attributes(const XdmfFrame& frame, const char* group, const char* center, long rows,
  const std::vector<FrameLayout::Array>& arrays)
{
  std::string text;
  for (const auto& [name, components] : arrays)
  {
    text += attribute(name, center, components,
      data_item(frame, fmt::format("{}/{}", group, name), doubles, rows, components));
  }
  return text;
}

std::string grid(const std::string& name, const XdmfFrame& frame)
{
  const FrameLayout& layout = frame.layout;
  const std::string points = data_item(frame, "points", doubles, layout.points, 3);
  std::string text = fmt::format("      <Grid Name=\"{}\" GridType=\"Uniform\">\n", xml_text(name));
  text += fmt::format("        <Time Value=\"{}\"/>\n", frame.time);
  text += fmt::format(
    "        <Topology TopologyType=\"Triangle\" NumberOfElements=\"{}\">{}</Topology>\n",
    layout.triangles, data_item(frame, "triangles", integers, layout.triangles, 3));
  text += fmt::format("        <Geometry GeometryType=\"XYZ\">{}</Geometry>\n", points);
  text += attribute("Position", "Node", 3, points);
  text += attributes(frame, "point_data", "Node", layout.points, layout.point_data);
  text += attributes(frame, "cell_data", "Cell", layout.triangles, layout.cell_data);
  return text + "      </Grid>\n";
}

}

std::string xdmf_text(const std::string& name, const std::vector<XdmfFrame>& frames)
{
  std::string text = "<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\">\n  <Domain>\n";
  text += fmt::format(
    "    <Grid Name=\"{}\" GridType=\"Collection\" CollectionType=\"Temporal\">\n", xml_text(name));
  for (const XdmfFrame& frame : frames)
  {
    text += grid(name, frame);
  }
  return text + "    </Grid>\n  </Domain>\n</Xdmf>\n";
}

}
