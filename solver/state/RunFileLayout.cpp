#include "solver/state/RunFileLayout.h"

#include "solver/Errors.h"
#include "solver/files/Checksum.h"
#include "solver/state/LittleEndian.h"
#include "solver/state/StateFields.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace vesicle
{
namespace
{

using hdf5::Handle;
using hdf5::Shape;

constexpr const char* format_name = "vesicle run file";

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
const int* data_of(const Triangles& triangles)
{
  return triangles.data();
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
Shape shape_of_field(const Triangles& triangles)
{
  return { static_cast<hsize_t>(triangles.rows()), 3 };
}
Shape shape_of_field(const Eigen::VectorXd& vector)
{
  return { static_cast<hsize_t>(vector.size()) };
}

bool is_usable(std::int64_t)
{
  return true;
}
bool is_usable(double value)
{
  return !std::isnan(value);
}
bool is_usable(const Points& points)
{
  return points.allFinite();
}
bool is_usable(const Eigen::VectorXd& vector)
{
  return vector.allFinite();
}
bool is_usable(const Triangles&)
{
  return true; // whether they are a mesh is asked before they are used
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

/// Points or triangles.
template<class Number>
Number* resized(Eigen::Matrix<Number, Eigen::Dynamic, 3, Eigen::RowMajor>& rows, const Shape& shape,
  const std::string& name)
{
  if (shape.size() != 2 || shape[1] != 3)
  {
    misshapen(name);
  }
  rows.resize(static_cast<Eigen::Index>(shape[0]), 3);
  return rows.data();
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
  hdf5::write_attribute(file, "layout_version", static_cast<std::int64_t>(run_file_layout_version));
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

/// A state's datasets, in the order of for_each_field.
std::vector<Handle> create_slot(hid_t file, std::size_t slot, const State& state)
{
  const Handle group = hdf5::create_group(file, slot_name(slot));
  for (std::size_t v = 0; v < state.vesicles.size(); ++v)
    hdf5::create_group(group, vesicle_group(v));
  std::vector<Handle> datasets;
  for_each_field(state,
    [&](const std::string& name, const auto& field)
    {
      using Number = std::remove_cvref_t<decltype(*data_of(field))>;
      datasets.push_back(hdf5::create_dataset<Number>(group, name, shape_of_field(field)));
    });
  return datasets;
}

void write_slot(const std::vector<Handle>& datasets, const State& state)
{
  auto dataset = datasets.begin();
  for_each_field(state,
    [&](const std::string& name, const auto& field)
    { hdf5::write(*dataset++, data_of(field), name); });
}

/// The place of the first dataset that has one.
std::optional<std::uint64_t> first_place(const std::vector<Handle>& datasets)
{
  for (const Handle& dataset : datasets)
  {
    if (const auto place = hdf5::place_of(dataset))
    {
      return place;
    }
  }
  return std::nullopt;
}

void read_triangles(hid_t group, const std::string& name, Triangles& triangles)
{
  const Handle dataset = hdf5::open_dataset(group, name);
  hdf5::read(dataset, resized(triangles, hdf5::shape_of(dataset, name), "triangles/" + name), name);
}

RunFile::Header read_header(hid_t file)
{
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
  header.columns = hdf5::columns_of_table(hdf5::open_dataset(file, "series"), "series");
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

std::vector<double> read_series(const std::string& file, const CheckedRunFile& checked)
{
  const auto& [head, commit] = checked;
  std::vector<double> series;
  for (std::uint64_t place = head.series; place < head.row(commit.rows); place += 8)
  {
    series.push_back(number_at<double>(file, place));
  }
  return series;
}

/// What a writer would have refused.
void require_usable(const RunFileContents& contents)
{
  const bool finite =
    std::ranges::all_of(contents.series, [](double x) { return std::isfinite(x); });
  const std::string field = finite ? first_unusable_field(contents.state) : "series";
  if (!field.empty())
    throw IoError(fmt::format(
      "{} isn't finite; bring a copy of the file back, or start anew with --overwrite", field));
}

/// A file whose numbers aren't where they are looked for must not come to be.
void require_places(
  const RunFileImage& image, const std::vector<std::vector<Handle>>& slots, hid_t series)
{
  const auto is_at = [](const std::optional<std::uint64_t>& place, std::uint64_t wanted)
  { return !place || *place == wanted; };
  const RunFileHead& head = image.head;
  bool right =
    is_at(hdf5::place_of(series), head.series) && image.bytes.size() == head.committed + 8;
  for (std::size_t slot = 0; slot < slots.size(); ++slot)
  {
    right = right && is_at(first_place(slots[slot]), head.slot(slot));
  }
  if (!right)
  {
    throw IoError("HDF5 lays out a run file in another way than this program knows");
  }
}

}

/// A record a step, or a step and vesicle where there are several.
static Shape series_shape(const RunFile::Header& header, std::size_t steps)
{
  Shape shape{ steps };
  if (header.triangles.size() > 1)
    shape.push_back(header.triangles.size());
  return shape;
}

RunFileImage run_file_image(const RunFileContents& contents, std::size_t capacity)
{
  const State& state = contents.state;
  const std::size_t rows = contents.rows();
  const Handle file = hdf5::create_in_memory(run_file_head_size);
  write_header(file, contents.header);
  hdf5::create_group(file, "state");
  std::vector<std::vector<Handle>> slots; // none while there is no state
  for (std::size_t slot = 0; rows > 0 && slot < 2; ++slot)
  {
    slots.push_back(create_slot(file, slot, state));
  }
  const Handle series = hdf5::create_table(
    file, "series", contents.header.columns, series_shape(contents.header, capacity));
  hdf5::write_attribute(series, "missing_value", missing_value);
  const Handle committed = hdf5::create_dataset<std::int64_t>(file, "committed", {});

  // All that has a place in the file stands before what gets one now, in this order.
  for (const auto& slot : slots)
  {
    write_slot(slot, state);
  }
  std::vector<double> padded = contents.series;
  padded.resize(capacity * contents.row_length(), missing_value);
  hdf5::write_table(series, padded.data(), "series");
  const auto count = static_cast<std::int64_t>(rows);
  hdf5::write(committed, &count, "committed");

  const std::string fields = rows > 0 ? state_bytes(state) : "";
  RunFileImage image{ hdf5::image_of(file), {} };
  RunFileHead& head = image.head;
  head.committed = hdf5::place_of(committed).value();
  head.row_size = 8 * contents.row_length();
  head.capacity = capacity;
  head.series = head.committed - capacity * head.row_size;
  head.slot_size = fields.size();
  head.slots = head.series - 2 * head.slot_size;
  require_places(image, slots, series);
  write_head(head, image.bytes);
  const RunFileCommit commit{ rows, checksum(fields), checksum(numbers_bytes(contents.series)) };
  image.bytes.replace(commit.place(), commit.bytes().size(), commit.bytes());
  return image;
}

RunFileContents read_contents(const std::string& bytes)
{
  const CheckedRunFile checked = checked_run_file(bytes);
  const Handle file = hdf5::open_in_memory(bytes);
  RunFileContents contents;
  contents.header = read_header(file);
  if (contents.header.triangles.empty() || checked.head.row_size != 8 * contents.row_length())
  {
    misshapen("series");
  }
  contents.series = read_series(bytes, checked);
  if (contents.rows() > 0)
  {
    contents.state = read_slot(file, checked.commit.rows % 2, contents.header.triangles.size());
  }
  require_usable(contents);
  return contents;
}

std::string first_unusable_field(const State& state)
{
  std::string found;
  for_each_field(state,
    [&](const std::string& name, const auto& field)
    {
      if (found.empty() && !is_usable(field))
        found = name;
    });
  return found;
}

std::vector<Shape> field_shapes(const State& state)
{
  std::vector<Shape> shapes;
  for_each_field(
    state, [&](const std::string&, const auto& field) { shapes.push_back(shape_of_field(field)); });
  return shapes;
}

std::string state_bytes(const State& state)
{
  std::string bytes;
  for_each_field(state,
    [&](const std::string&, const auto& field)
    {
      std::size_t count = 1;
      for (const hsize_t size : shape_of_field(field))
      {
        count *= size;
      }
      append_numbers(bytes, data_of(field), count);
    });
  return bytes;
}

std::string numbers_bytes(const std::vector<double>& numbers)
{
  std::string bytes;
  append_numbers(bytes, numbers.data(), numbers.size());
  return bytes;
}

}
