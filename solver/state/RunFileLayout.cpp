#include "solver/state/RunFileLayout.h"

#include "solver/Errors.h"
#include "solver/state/StateFields.h"

#include <fmt/format.h>

#include <algorithm>
#include <type_traits>

namespace vesicle
{
namespace
{

using hdf5::Handle;
using hdf5::Shape;

constexpr const char* format_name = "vesicle run file";
constexpr std::int64_t layout_version = 2; // raise it when a reader would misunderstand the file

/// Where a number or the first of an array's numbers stands, its type and its shape.
const std::int64_t* data_of(const std::int64_t& value)
{
  return &value;
}
const double* data_of(const double& value)
{
  return &value;
}
const double* data_of(const Points& points)
{
  return points.data();
}
const double* data_of(const Eigen::VectorXd& vector)
{
  return vector.data();
}
Shape shape_of_field(const std::int64_t&)
{
  return {};
}
Shape shape_of_field(const double&)
{
  return {};
}
Shape shape_of_field(const Points& points)
{
  return { static_cast<hsize_t>(points.rows()), 3 };
}
Shape shape_of_field(const Eigen::VectorXd& vector)
{
  return { static_cast<hsize_t>(vector.size()) };
}

[[noreturn]] void misshapen(const std::string& name)
{
  throw IoError(name + " doesn't have the shape that it has in a run file");
}

/// Makes room for what a dataset of `shape` holds.
template<class T>
T* resized(T& value, const Shape& shape, const std::string& name)
{
  if (!shape.empty())
  {
    misshapen(name);
  }
  return &value;
}

double* resized(Points& points, const Shape& shape, const std::string& name)
{
  if (shape.size() != 2 || shape[1] != 3)
  {
    misshapen(name);
  }
  points.resize(static_cast<Eigen::Index>(shape[0]), 3);
  return points.data();
}

double* resized(Eigen::VectorXd& vector, const Shape& shape, const std::string& name)
{
  if (shape.size() != 1)
  {
    misshapen(name);
  }
  vector.resize(static_cast<Eigen::Index>(shape[0]));
  return vector.data();
}

std::string slot_name(std::size_t slot)
{
  return fmt::format("state/{}", slot);
}

void write_header(hid_t file, const RunFile::Header& header)
{
  hdf5::write_attribute(file, "format", std::string(format_name));
  hdf5::write_attribute(file, "layout_version", layout_version);
  hdf5::write_attribute(file, "vesicle_version", std::string(VESICLE_VERSION));
  hdf5::write_attribute(file, "length_scale", header.length_scale);
  hdf5::write_attribute(file, "time_scale", header.time_scale);
  hdf5::write_attribute(file, "energy_scale", header.energy_scale);
  hdf5::write_attribute(file, "viscosity", header.viscosity);
  hdf5::write_text(file, "scene", header.scene);
  const Handle group = hdf5::create_group(file, "triangles");
  for (std::size_t v = 0; v < header.triangles.size(); ++v)
  {
    const std::string name = vesicle_group(v);
    const Shape shape{ static_cast<hsize_t>(header.triangles[v].rows()), 3 };
    const Handle triangles = hdf5::create_dataset<int>(group, name, shape);
    hdf5::write(triangles, header.triangles[v].data(), name);
  }
}

void write_series(hid_t file, const RunFileContents& contents, std::size_t capacity)
{
  const Handle group = hdf5::create_group(file, "series");
  hdf5::write_attribute(group, "columns", contents.header.columns);
  std::vector<double> padded(capacity);
  for (std::size_t i = 0; i < contents.columns.size(); ++i)
  {
    const std::string& name = contents.header.columns[i];
    const auto& values = contents.columns[i];
    std::fill(std::copy(values.begin(), values.end(), padded.begin()), padded.end(), missing_value);
    const Handle column = hdf5::create_dataset<double>(group, name, { capacity }, missing_value);
    hdf5::write(column, padded.data(), name);
    hdf5::write_attribute(column, "missing_value", missing_value);
  }
}

void write_slot(hid_t file, std::size_t slot, const State& state)
{
  const Handle group = hdf5::create_group(file, slot_name(slot));
  for (std::size_t v = 0; v < state.vesicles.size(); ++v)
    hdf5::create_group(group, vesicle_group(v));
  for_each_field(state,
    [&](const std::string& name, const auto& field)
    {
      using Number = std::remove_cvref_t<decltype(*data_of(field))>;
      const Handle dataset = hdf5::create_dataset<Number>(group, name, shape_of_field(field));
      hdf5::write(dataset, data_of(field), name);
    });
}

void read_triangles(hid_t group, const std::string& name, Triangles& triangles)
{
  const Handle dataset = hdf5::open_dataset(group, name);
  const Shape shape = hdf5::shape_of(dataset, name);
  if (shape.size() != 2 || shape[1] != 3)
    misshapen("triangles/" + name);
  triangles.resize(static_cast<Eigen::Index>(shape[0]), 3);
  hdf5::read(dataset, triangles.data(), name);
}

RunFile::Header read_header(hid_t file)
{
  const bool ours = hdf5::has_attribute(file, "format") &&
    hdf5::read_text_attribute(file, "format") == std::vector<std::string>{ format_name };
  if (!ours)
  {
    throw IoError("is an HDF5 file but not a run file");
  }
  const auto version = hdf5::read_attribute<std::int64_t>(file, "layout_version");
  if (version != layout_version)
  {
    throw IoError(
      fmt::format("has layout version {}, this program knows version {}; go on with the "
                  "version of the program that wrote it",
        version, layout_version));
  }
  RunFile::Header header;
  header.length_scale = hdf5::read_attribute<double>(file, "length_scale");
  header.time_scale = hdf5::read_attribute<double>(file, "time_scale");
  header.energy_scale = hdf5::read_attribute<double>(file, "energy_scale");
  header.viscosity = hdf5::read_attribute<double>(file, "viscosity");
  header.scene = hdf5::read_text(file, "scene");

  const Handle group = hdf5::open_group(file, "triangles");
  header.triangles.resize(hdf5::member_count(group));
  for (std::size_t v = 0; v < header.triangles.size(); ++v)
    read_triangles(group, vesicle_group(v), header.triangles[v]);
  header.columns = hdf5::read_text_attribute(hdf5::open_group(file, "series"), "columns");
  return header;
}

State state_of(std::size_t vesicles)
{
  State state;
  state.vesicles.resize(vesicles);
  state.preconditioner.points.resize(vesicles);
  return state;
}

State read_slot(hid_t file, std::size_t slot, std::size_t vesicles)
{
  const Handle group = hdf5::open_group(file, slot_name(slot));
  State state = state_of(vesicles);
  for_each_field(state,
    [&](const std::string& name, auto& field)
    {
      const Handle dataset = hdf5::open_dataset(group, name);
      hdf5::read(dataset, resized(field, hdf5::shape_of(dataset, name), name), name);
    });
  return state;
}

std::vector<Handle> open_slot(hid_t file, std::size_t slot, std::size_t vesicles)
{
  const Handle group = hdf5::open_group(file, slot_name(slot));
  std::vector<Handle> datasets;
  const State any = state_of(vesicles);
  for_each_field(any,
    [&](const std::string& name, const auto&)
    { datasets.push_back(hdf5::open_dataset(group, name)); });
  return datasets;
}

std::size_t read_committed(const RunFileDatasets& datasets)
{
  std::int64_t rows = 0;
  hdf5::read(datasets.committed, &rows, "committed");
  if (rows < 0 || static_cast<std::size_t>(rows) > datasets.capacity)
  {
    throw IoError(fmt::format("says that {} rows are committed, of {}", rows, datasets.capacity));
  }
  return static_cast<std::size_t>(rows);
}

}

std::vector<char> run_file_image(const RunFileContents& contents, std::size_t capacity)
{
  const Handle file = hdf5::create_in_memory();
  write_header(file, contents.header);
  write_series(file, contents, capacity);
  const Handle state = hdf5::create_group(file, "state");
  if (contents.rows() > 0)
  {
    write_slot(file, 0, contents.state);
    write_slot(file, 1, contents.state);
  }
  const auto rows = static_cast<std::int64_t>(contents.rows());
  const Handle committed = hdf5::create_dataset<std::int64_t>(file, "committed", {});
  hdf5::write(committed, &rows, "committed");
  return hdf5::image_of(file);
}

RunFileDatasets open_datasets(hid_t file, const RunFile::Header& header)
{
  RunFileDatasets datasets;
  datasets.committed = hdf5::open_dataset(file, "committed");
  const Handle series = hdf5::open_group(file, "series");
  for (const auto& name : header.columns)
  {
    datasets.columns.push_back(hdf5::open_dataset(series, name));
    const Shape shape = hdf5::shape_of(datasets.columns.back(), name);
    const bool first = datasets.columns.size() == 1;
    if (shape.size() != 1 || (!first && shape[0] != datasets.capacity))
    {
      misshapen(name);
    }
    datasets.capacity = shape[0];
  }
  if (read_committed(datasets) > 0)
  {
    const std::size_t vesicles = header.triangles.size();
    datasets.slots = { open_slot(file, 0, vesicles), open_slot(file, 1, vesicles) };
    for (const auto& field : datasets.slots[0])
    {
      datasets.state_shapes.push_back(hdf5::shape_of(field, "state"));
    }
  }
  return datasets;
}

RunFileContents read_contents(hid_t file)
{
  RunFileContents contents;
  contents.header = read_header(file);
  const RunFileDatasets datasets = open_datasets(file, contents.header);
  const std::size_t rows = read_committed(datasets);
  for (std::size_t i = 0; i < datasets.columns.size(); ++i)
  {
    std::vector<double> values(datasets.capacity);
    hdf5::read(datasets.columns[i], values.data(), contents.header.columns[i]);
    values.resize(rows);
    contents.columns.push_back(std::move(values));
  }
  if (rows > 0)
  {
    contents.state = read_slot(file, rows % 2, contents.header.triangles.size());
  }
  return contents;
}

std::vector<Shape> field_shapes(const State& state)
{
  std::vector<Shape> shapes;
  for_each_field(
    state, [&](const std::string&, const auto& field) { shapes.push_back(shape_of_field(field)); });
  return shapes;
}

void write_state(const std::vector<Handle>& slot, const State& state)
{
  auto dataset = slot.begin();
  for_each_field(state,
    [&](const std::string& name, const auto& field)
    { hdf5::write(*dataset++, data_of(field), name); });
}

}
