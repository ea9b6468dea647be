#include "SeriesWriter.h"

#include "FileBytes.h"
#include "MeshFiles.h"

#include "solver/Errors.h"

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

std::filesystem::path SeriesWriter::frame_name(std::size_t index) const
{
  return std::filesystem::path("frames") / fmt::format("{}_{:06}.vtu", name_, index);
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
  for (std::size_t i = 0; i < count; ++i)
  {
    if (i >= there.size() || !std::filesystem::exists(folder_ / frame_name(i)))
    {
      throw InputError(fmt::format("{}: frame {} is missing; the run can't be gone on with",
        series_file().string(), (folder_ / frame_name(i)).string()));
    }
    frames_.push_back({ there[i].time, frame_name(i) });
  }
  list_frames();
  remove_frames_from(count);
}

void SeriesWriter::append(vtkPolyData* surface, double time)
{
  make_folder(folder_ / "frames");
  const auto name = frame_name(frames_.size());
  write_mesh(with_time(surface, time), folder_ / name);
  frames_.push_back({ time, name });
  list_frames();
}

void SeriesWriter::list_frames() const
{
  replace_file(pvd_file(), pvd_text(frames_));
  replace_file(series_file(), series_text(frames_));
}

void SeriesWriter::remove_frames_from(std::size_t index) const
{
  std::error_code ignored;
  while (std::filesystem::remove(folder_ / frame_name(index), ignored))
  {
    ++index;
  }
}

}
