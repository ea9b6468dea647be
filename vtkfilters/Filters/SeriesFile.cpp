#include "SeriesFile.h"

#include "VtkMessages.h"

#include "solver/Errors.h"
#include "solver/files/FileBytes.h"
#include "solver/state/XmlText.h"

#include "vtkSmartPointer.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLUtilities.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace vesicle
{
namespace
{

using std::filesystem::path;

[[noreturn]] void fail(const path& file, const std::string& problem)
{
  throw InputError(
    fmt::format("{}: {}; name the frames' files themselves instead", file.string(), problem));
}

std::vector<SeriesFrame> read_json(const path& file)
{
  std::vector<SeriesFrame> frames;
  try
  {
    const auto series = nlohmann::json::parse(read_file(file));
    for (const auto& entry : series.at("files"))
    {
      frames.push_back({ entry.at("time").get<double>(), entry.at("name").get<std::string>() });
    }
  }
  catch (const nlohmann::json::exception& error)
  {
    fail(file, fmt::format("isn't a VTK file series ({})", error.what()));
  }
  return frames;
}

std::vector<SeriesFrame> read_pvd(const path& file)
{
  const VtkMessages messages;
  const auto root =
    vtk::TakeSmartPointer(vtkXMLUtilities::ReadElementFromString(read_file(file).c_str()));
  auto* collection = root ? root->FindNestedElementWithName("Collection") : nullptr;
  if (!collection)
  {
    fail(file, "isn't a ParaView collection");
  }
  std::vector<SeriesFrame> frames;
  for (int i = 0; i < collection->GetNumberOfNestedElements(); ++i)
  {
    auto* entry = collection->GetNestedElement(i);
    SeriesFrame frame;
    const char* name = entry->GetAttribute("file");
    if (!name || !entry->GetScalarAttribute("timestep", frame.time))
    {
      fail(file, fmt::format("entry {} lacks its file or timestep", i + 1));
    }
    frame.file = name;
    frames.push_back(frame);
  }
  return frames;
}

}

bool is_series(const path& file)
{
  return file.extension() == ".pvd" || file.extension() == ".series";
}

std::vector<SeriesFrame> read_series(const path& file)
{
  auto frames = file.extension() == ".pvd" ? read_pvd(file) : read_json(file);
  if (frames.empty())
  {
    fail(file, "lists no frames");
  }
  for (auto& frame : frames)
  {
    frame.file = file.parent_path() / frame.file; // an absolute name stays what it is
  }
  return frames;
}

std::string pvd_text(const std::vector<SeriesFrame>& frames)
{
  std::string text = "<?xml version=\"1.0\"?>\n"
                     "<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
                     "  <Collection>\n";
  for (const auto& frame : frames)
  {
    text += fmt::format("    <DataSet timestep=\"{}\" group=\"\" part=\"0\" file=\"{}\"/>\n",
      frame.time, xml_text(frame.file.generic_string()));
  }
  return text + "  </Collection>\n</VTKFile>\n";
}

std::string series_text(const std::vector<SeriesFrame>& frames)
{
  auto files = nlohmann::json::array();
  for (const auto& frame : frames)
  {
    files.push_back({ { "name", frame.file.generic_string() }, { "time", frame.time } });
  }
  return nlohmann::json{ { "file-series-version", "1.0" }, { "files", files } }.dump(1) + "\n";
}

}
