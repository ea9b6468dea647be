#include "SeriesWriter.h"

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

/// A shallow copy that knows its time, so that the caller's surface stays as it is.
vtkSmartPointer<vtkPolyData> with_time(vtkPolyData* surface, double time)
{
  vtkNew<vtkDoubleArray> value;
  value->SetName("TimeValue");
  value->InsertNextValue(time);
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->ShallowCopy(surface);
  copy->GetFieldData()->AddArray(value);
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

void SeriesWriter::keep(std::size_t count)
{
  const auto there = count > 0 ? read_series(series_file()) : std::vector<SeriesFrame>{};
  frames_.clear();
  xdmf_frames_.clear();
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto grid = frame_name(i, ".vtu"), hdf5 = frame_name(i, ".h5");
    for (const auto& frame : { grid, hdf5 })
    {
      if (i >= there.size() || !std::filesystem::exists(folder_ / frame))
      {
        throw InputError(fmt::format("{}: frame {} is missing; the run can't be gone on with",
          series_file().string(), (folder_ / frame).string()));
      }
    }
    frames_.push_back({ there[i].time, grid });
    xdmf_frames_.push_back({ there[i].time, hdf5, read_frame_layout(folder_ / hdf5) });
  }
  list_frames();
  remove_frames_from(count);
}

void SeriesWriter::append(vtkPolyData* surface, double time)
{
  make_folder(folder_ / "frames");
  const std::size_t index = frames_.size();
  const auto grid = frame_name(index, ".vtu"), hdf5 = frame_name(index, ".h5");
  const auto timed = with_time(surface, time);
  write_mesh(timed, folder_ / grid);
  const Frame frame = to_frame(timed, time);
  replace_file(folder_ / hdf5, frame_file_image(frame));
  frames_.push_back({ time, grid });
  xdmf_frames_.push_back({ time, hdf5, layout_of(frame) });
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
