#include "SeriesWriter.h"

#include "ArrayLabels.h"
#include "MeshConversion.h"
#include "MeshFiles.h"

#include "solver/Errors.h"
#include "solver/files/FileBytes.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <fmt/format.h>

namespace vesicle
{
namespace
{

/// A shallow copy that knows its time, so that the caller's surface stays as it is. Field data are
/// numbers alone: programs that read frames (meshio) stop at others.
vtkSmartPointer<vtkPolyData> as_frame(vtkPolyData* surface, double time)
{
  vtkNew<vtkDoubleArray> value;
  value->SetName("TimeValue");
  value->InsertNextValue(time);
  label(value);
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->ShallowCopy(surface);
  vtkFieldData* fields = copy->GetFieldData();
  for (int i = fields->GetNumberOfArrays() - 1; i >= 0; --i)
  {
    if (!fields->GetArray(i))
    {
      fields->RemoveArray(i);
    }
  }
  fields->AddArray(value);
  return copy;
}

}

SeriesWriter::SeriesWriter(std::filesystem::path folder, std::string name)
  : folder_(std::move(folder)), name_(std::move(name))
{
}

std::filesystem::path SeriesWriter::pvd_file() const
{
  return folder_ / (name_ + ".pvd");
}

std::filesystem::path SeriesWriter::series_file() const
{
  return folder_ / (name_ + ".vtu.series");
}

std::filesystem::path SeriesWriter::xdmf_file() const
{
  return folder_ / (name_ + ".xdmf");
}

std::filesystem::path SeriesWriter::frame_name(std::size_t index, const char* ending) const
{
  return std::filesystem::path("frames") / fmt::format("{}_{:06}{}", name_, index, ending);
}

std::vector<std::filesystem::path> SeriesWriter::files() const
{
  std::vector<std::filesystem::path> result;
  for (const auto& frame : frames_)
  {
    result.push_back(folder_ / frame.file);
  }
  return result;
}

void SeriesWriter::require_frames(std::size_t count) const
{
  for (std::size_t i = 0; i < count; ++i)
  {
    for (const char* ending : { ".vtu", ".h5" })
    {
      const auto frame = folder_ / frame_name(i, ending);
      if (!is_file(frame))
      {
        throw InputError(
          fmt::format("{}: this frame is missing, and the run can't go on without it; bring it "
                      "back, or start anew with --overwrite",
            frame.string()));
      }
    }
  }
}

void SeriesWriter::keep(const std::vector<double>& times, vtkPolyData* like)
{
  require_frames(times.size());
  frames_.clear();
  xdmf_frames_.clear();
  const FrameLayout layout = layout_of(to_frame(like, 0));
  for (const double time : times)
  {
    list(time, layout);
  }
  list_frames();
  remove_frames_from(times.size());
}

void SeriesWriter::list(double time, FrameLayout layout)
{
  const std::size_t index = frames_.size();
  frames_.push_back({ time, frame_name(index, ".vtu") });
  xdmf_frames_.push_back({ time, frame_name(index, ".h5"), std::move(layout) });
}

void SeriesWriter::append(vtkDataObject* surface, double time)
{
  const std::size_t index = frames_.size();
  if (index == 0) // later on it is an error if the folder is gone
  {
    make_folder(folder_ / "frames");
  }
  const auto frame_surface = as_frame(triangulated(surface, name_), time);
  write_mesh(frame_surface, folder_ / frame_name(index, ".vtu"));
  const Frame frame = to_frame(frame_surface, time);
  replace_file(folder_ / frame_name(index, ".h5"), frame_file_image(frame));
  list(time, layout_of(frame));
  list_frames();
}

void SeriesWriter::list_frames() const
{
  replace_file(pvd_file(), pvd_text(frames_));
  replace_file(series_file(), series_text(frames_));
  replace_file(xdmf_file(), xdmf_text(name_, xdmf_frames_));
}

void SeriesWriter::remove_frames_from(std::size_t index) const
{
  bool removed = true;
  for (std::size_t i = index; removed; ++i)
  {
    removed = false;
    for (const char* ending : { ".vtu", ".h5" })
    {
      std::error_code ignored;
      removed |= std::filesystem::remove(folder_ / frame_name(i, ending), ignored);
    }
  }
}

}
