#include "solver/state/FrameFile.h"

#include "solver/Errors.h"
#include "solver/state/Hdf5.h"

#include <algorithm>

namespace vesicle
{
namespace
{

using hdf5::Handle;

constexpr const char* frame_format = "vesicle frame";

template<class Numbers>
void write_numbers(
  hid_t parent, const std::string& name, const hdf5::Shape& shape, const Numbers& numbers)
{
  const Handle dataset =
    hdf5::create_compressed_dataset<typename Numbers::Scalar>(parent, name, shape);
  hdf5::write(dataset, numbers.data(), name);
}

void write_arrays(hid_t file, const std::string& group, const std::vector<FrameArray>& arrays)
{
  const Handle parent = hdf5::create_group(file, group);
  for (const auto& [name, values] : arrays)
  {
    hdf5::Shape shape{ static_cast<hsize_t>(values.rows()) };
    if (values.cols() != 1)
    {
      shape.push_back(static_cast<hsize_t>(values.cols()));
    }
    write_numbers(parent, name, shape, values);
  }
}

/// In the order in which HDF5 lists them.
std::vector<FrameLayout::Array> layout_of(const std::vector<FrameArray>& arrays)
{
  std::vector<FrameLayout::Array> result;
  result.reserve(arrays.size());
  for (const auto& [name, values] : arrays)
    result.push_back({ name, values.cols() });
  std::sort(
    result.begin(), result.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  return result;
}

std::vector<FrameLayout::Array> read_layout(hid_t file, const std::string& group)
{
  const Handle parent = hdf5::open_group(file, group);
  std::vector<FrameLayout::Array> result;
  for (const std::string& name : hdf5::names_in(parent))
  {
    const auto shape = hdf5::shape_of(hdf5::open_dataset(parent, name), name);
    result.push_back({ name, shape.size() > 1 ? static_cast<long>(shape[1]) : 1 });
  }
  return result;
}

long rows_of(hid_t file, const std::string& name)
{
  const auto shape = hdf5::shape_of(hdf5::open_dataset(file, name), name);
  return shape.empty() ? 0 : static_cast<long>(shape[0]);
}

}

FrameLayout layout_of(const Frame& frame)
{
  return { frame.mesh.points.rows(), frame.mesh.triangles.rows(), layout_of(frame.point_data),
    layout_of(frame.cell_data) };
}

FrameLayout read_frame_layout(const std::filesystem::path& file)
{
  const hdf5::QuietErrors quiet;
  try
  {
    const Handle frame(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, "frame");
    return { rows_of(frame, "points"), rows_of(frame, "triangles"),
      read_layout(frame, "point_data"), read_layout(frame, "cell_data") };
  }
  catch (const IoError& error)
  {
    throw IoError(file.string() + ": isn't a frame of a run: " + error.what());
  }
}

std::string frame_file_image(const Frame& frame)
{
  const hdf5::QuietErrors quiet;
  const Handle file = hdf5::create_in_memory();
  hdf5::write_attribute(file, "format", std::string(frame_format));
  hdf5::write_attribute(file, "time", frame.time);
  const auto& [points, triangles] = frame.mesh;
  write_numbers(file, "points", { static_cast<hsize_t>(points.rows()), 3 }, points);
  write_numbers(file, "triangles", { static_cast<hsize_t>(triangles.rows()), 3 }, triangles);
  write_arrays(file, "point_data", frame.point_data);
  write_arrays(file, "cell_data", frame.cell_data);
  write_arrays(file, "field_data", frame.field_data);
  return hdf5::image_of(file);
}

}
