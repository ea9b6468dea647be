#include "render/FrameFile.h"

#include "solver/Errors.h"

#include "vtkCallbackCommand.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkGenericDataObjectReader.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkGeometryFilter.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkXMLGenericDataObjectReader.h"

#include <fstream>

namespace vesicle
{
namespace
{

void require_readable(const std::filesystem::path& file)
{
  std::ifstream in(file);
  if (!in.good() || std::filesystem::is_directory(file))
  {
    throw IoError("can't read " + file.string());
  }
}

/// Runs the reader with VTK's own complaints collected instead of printed.
template<typename Reader>
vtkSmartPointer<vtkDataSet> read_with(const std::filesystem::path& file)
{
  std::string complaint;
  vtkNew<vtkCallbackCommand> listener;
  listener->SetClientData(&complaint);
  listener->SetCallback(
    [](vtkObject*, unsigned long, void* kept, void* text)
    {
      auto& first = *static_cast<std::string*>(kept);
      first = first.empty() && text ? static_cast<const char*>(text) : first;
    });
  vtkNew<Reader> reader;
  reader->AddObserver("ErrorEvent", listener);
  reader->GetExecutive()->AddObserver("ErrorEvent", listener);
  reader->SetFileName(file.c_str());
  reader->Update();
  auto* data = vtkDataSet::SafeDownCast(reader->GetOutputDataObject(0));
  if (!data || reader->GetErrorCode() != 0 || !complaint.empty())
  {
    throw InputError(file.string() + " is not a complete VTK data set");
  }
  return data;
}

vtkSmartPointer<vtkPolyData> surface_of(vtkDataSet* data)
{
  if (auto* surface = vtkPolyData::SafeDownCast(data))
  {
    return surface;
  }
  vtkNew<vtkGeometryFilter> outer;
  outer->SetInputData(data);
  outer->Update();
  return outer->GetOutput();
}

}

FrameFile read_frame(const std::filesystem::path& file)
{
  const auto ending = file.extension();
  if (ending != ".vtp" && ending != ".vtu" && ending != ".vtk")
  {
    throw InputError("can't draw " + file.string() + ": use a .vtp, .vtu or .vtk file");
  }
  require_readable(file);
  const auto data = ending == ".vtk" ? read_with<vtkGenericDataObjectReader>(file)
                                     : read_with<vtkXMLGenericDataObjectReader>(file);
  FrameFile frame{ surface_of(data), {} };
  if (frame.surface->GetNumberOfPolys() == 0)
  {
    throw InputError(file.string() + " holds no triangles");
  }
  vtkDataArray* time = data->GetFieldData()->GetArray("TimeValue");
  if (time && time->GetNumberOfValues() > 0)
  {
    frame.time = time->GetComponent(0, 0);
  }
  return frame;
}

}
