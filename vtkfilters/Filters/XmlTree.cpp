#include "XmlTree.h"

#include "VtkMessages.h"

#include "solver/Errors.h"

#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkXMLParser.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace vesicle
{
namespace
{

/// A surface's file has a few; each takes more memory than its text.
constexpr int most_elements = 100000;
constexpr std::size_t most_levels = 20;
constexpr std::size_t chunk = 1 << 28;

bool keeps_text(std::string_view name)
{
  return name == "DataArray" || name == "Array";
}

/// vtkXMLParser is a wrapper of expat, through which no exception may go.
class TreeBuilder : public vtkXMLParser
{
public:
  static TreeBuilder* New();
  vtkTypeMacro(TreeBuilder, vtkXMLParser);

  void StartElement(const char* name, const char** attributes) override
  {
    if (this->Failure.empty() &&
      (this->Path.size() >= most_levels || ++this->Count > most_elements))
    {
      this->Failure = "has more elements, or more within each other, than a surface";
    }
    if (!this->Failure.empty())
    {
      return;
    }
    XmlElement element{ name, {}, {}, {} };
    for (; attributes && attributes[0] && attributes[1]; attributes += 2)
    {
      element.attributes.emplace_back(attributes[0], attributes[1]);
    }
    this->Path.push_back(std::move(element));
  }
  void EndElement(const char*) override
  {
    if (!this->Failure.empty() || this->Path.empty())
    {
      return;
    }
    XmlElement element = std::move(this->Path.back());
    this->Path.pop_back();
    if (this->Path.empty())
    {
      this->Root = std::move(element);
    }
    else
    {
      this->Path.back().children.push_back(std::move(element));
    }
  }
  void CharacterDataHandler(const char* data, int length) override
  {
    if (this->Failure.empty() && !this->Path.empty() && keeps_text(this->Path.back().name))
    {
      this->Path.back().text.append(data, length);
    }
  }

  bool Feed(std::string_view text)
  {
    for (std::size_t first = 0; first < text.size(); first += chunk)
    {
      const auto part = text.substr(first, chunk);
      if (!this->ParseChunk(part.data(), static_cast<unsigned int>(part.size())))
      {
        return false;
      }
    }
    return true;
  }

  std::vector<XmlElement> Path; ///< the elements that are open
  XmlElement Root;
  std::string Failure;
  int Count = 0;
};
vtkStandardNewMacro(TreeBuilder);

/// The parts of a file around its appended data.
struct Parts
{
  std::string_view before;
  std::string_view appended;
  std::string_view after;
};

Parts parts_of(std::string_view bytes, const std::string& name)
{
  const std::size_t tag = bytes.find("<AppendedData");
  if (tag == std::string_view::npos)
  {
    return { bytes, {}, {} };
  }
  const std::size_t begin = bytes.find('>', tag);
  const std::size_t end = bytes.rfind("</AppendedData");
  if (begin == std::string_view::npos || end == std::string_view::npos || end < begin)
  {
    throw InputError(name +
      ": the file ends too early, within its appended data; write the mesh again, or in another "
      "format");
  }
  auto data = bytes.substr(begin + 1, end - begin - 1);
  const std::size_t underscore = data.find('_');
  data.remove_prefix(underscore == std::string_view::npos ? data.size() : underscore + 1);
  return { bytes.substr(0, begin + 1), data, bytes.substr(end) };
}

}

std::string XmlElement::attribute(std::string_view attribute_name) const
{
  const auto found = std::ranges::find(
    attributes, attribute_name, [](const auto& entry) { return std::string_view(entry.first); });
  return found == attributes.end() ? "" : found->second;
}

const XmlElement* XmlElement::child(std::string_view child_name) const
{
  const auto found =
    std::ranges::find(children, child_name, [](const auto& c) { return std::string_view(c.name); });
  return found == children.end() ? nullptr : &*found;
}

XmlDocument parse_vtk_xml(std::string_view bytes, const std::string& name)
{
  const Parts parts = parts_of(bytes, name);
  const VtkMessages messages;
  vtkNew<TreeBuilder> builder;
  bool parsed =
    builder->InitializeParser() && builder->Feed(parts.before) && builder->Feed(parts.after);
  parsed = builder->CleanupParser() && parsed;
  if (!builder->Failure.empty())
  {
    throw InputError(name + ": " + builder->Failure);
  }
  if (!parsed || !builder->Path.empty() || builder->Root.name.empty())
  {
    throw InputError(fmt::format("{}: is not complete XML, or ends too early ({}); write the mesh "
                                 "again, or in another format",
      name, messages.first_error()));
  }
  if (builder->Root.name != "VTKFile")
  {
    throw InputError(name + ": is not a VTK file: its first element should be VTKFile");
  }
  return { std::move(builder->Root), parts.appended, bytes.size() };
}

}
