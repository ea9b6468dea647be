#pragma once
// An XML document of VTK's as a tree.

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vesicle
{

struct XmlElement
{
  std::string name;
  std::vector<std::pair<std::string, std::string>> attributes;
  std::string text; ///< of arrays and appended data only
  std::vector<XmlElement> children;

  /// Empty if there is none.
  std::string attribute(std::string_view attribute_name) const;
  /// The first child of the name, nullptr if there is none.
  const XmlElement* child(std::string_view child_name) const;
};

struct XmlDocument
{
  XmlElement root;
  std::string_view appended; ///< what follows the underscore in AppendedData, in `bytes`
  std::size_t size = 0;      ///< of the whole file
};

/// Parses a VTKFile, whose appended data may be any bytes; `bytes` must outlive the document. Throws
/// InputError "name: …" with the line, or that it ends too early.
XmlDocument parse_vtk_xml(std::string_view bytes, const std::string& name);

}
