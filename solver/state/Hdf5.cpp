#include "solver/state/Hdf5.h"

#include "solver/Errors.h"

#include <algorithm>
#include <atomic>

namespace vesicle::hdf5
{
namespace
{

herr_t append_description(unsigned, const H5E_error2_t* error, void* text)
{
  auto& reasons = *static_cast<std::string*>(text);
  if (error->desc && *error->desc)
  {
    reasons += (reasons.empty() ? "" : ": ") + std::string(error->desc);
  }
  return 0;
}

Handle scalar_space()
{
  return { H5Screate(H5S_SCALAR), H5Sclose, "dataspace" };
}

/// Fixed-length UTF-8, which every reader knows.
Handle text_type(std::size_t length)
{
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "text type");
  check(H5Tset_size(type, std::max<std::size_t>(1, length)), "text length");
  check(H5Tset_cset(type, H5T_CSET_UTF8), "text encoding");
  check(H5Tset_strpad(type, H5T_STR_NULLPAD), "text padding");
  return type;
}

/// Without the padding.
std::string trimmed(const char* bytes, std::size_t length)
{
  return { bytes, std::find(bytes, bytes + length, '\0') };
}

/// What is read has room for one value.
void require_single(hid_t space, const std::string& name)
{
  if (H5Sget_simple_extent_npoints(space) != 1)
  {
    throw IoError(name + " is not a single value");
  }
}

/// A row of numbers, each with its name.
Handle record_type(const std::vector<std::string>& columns, hid_t number)
{
  const std::size_t size = H5Tget_size(number);
  Handle record(H5Tcreate(H5T_COMPOUND, columns.size() * size), H5Tclose, "record type");
  for (std::size_t i = 0; i < columns.size(); ++i)
  {
    check(H5Tinsert(record, columns[i].c_str(), i * size, number), "record type");
  }
  return record;
}

std::size_t text_length(hid_t type, const std::string& name)
{
  if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) > 0)
  {
    throw IoError(name + " is not a text of fixed length");
  }
  return H5Tget_size(type);
}

}

QuietErrors::QuietErrors()
{
  H5Eget_auto2(H5E_DEFAULT, &print_, &data_);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

QuietErrors::~QuietErrors()
{
  H5Eset_auto2(H5E_DEFAULT, print_, data_);
}

std::string failure()
{
  std::string reasons;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_DOWNWARD, append_description, &reasons);
  return reasons;
}

void check(herr_t status, const std::string& what)
{
  if (status < 0)
  {
    throw IoError(what + ": " + failure());
  }
}

Handle::Handle(hid_t id, Close close, const std::string& what) : id_(id), close_(close)
{
  if (id < 0)
  {
    throw IoError(what + ": " + failure());
  }
}

Handle::Handle(Handle&& other) noexcept
  : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_)
{
}

Handle& Handle::operator=(Handle&& other) noexcept
{
  if (this != &other)
  {
    reset();
    id_ = std::exchange(other.id_, H5I_INVALID_HID);
    close_ = other.close_;
  }
  return *this;
}

void Handle::reset()
{
  if (id_ >= 0)
  {
    close_(std::exchange(id_, H5I_INVALID_HID));
  }
}

Handle create_group(hid_t parent, const std::string& name)
{
  return { H5Gcreate2(parent, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose,
    "can't create " + name };
}

Handle open_group(hid_t parent, const std::string& name)
{
  return { H5Gopen2(parent, name.c_str(), H5P_DEFAULT), H5Gclose, "there is no " + name };
}

std::size_t member_count(hid_t group)
{
  H5G_info_t info;
  if (H5Gget_info(group, &info) < 0)
    throw IoError("can't list a group");
  return info.nlinks;
}

Handle open_dataset(hid_t parent, const std::string& name)
{
  return { H5Dopen2(parent, name.c_str(), H5P_DEFAULT), H5Dclose, "there is no " + name };
}

Shape shape_of(hid_t dataset, const std::string& name)
{
  const Handle space(H5Dget_space(dataset), H5Sclose, "can't read " + name);
  const int rank = H5Sget_simple_extent_ndims(space);
  check(rank, "can't read " + name);
  Shape shape(static_cast<std::size_t>(rank));
  check(H5Sget_simple_extent_dims(space, shape.data(), nullptr), "can't read " + name);
  return shape;
}

std::vector<std::string> names_in(hid_t group)
{
  std::vector<std::string> names;
  const auto add = [](hid_t, const char* name, const H5L_info_t*, void* list) -> herr_t
  {
    static_cast<std::vector<std::string>*>(list)->emplace_back(name);
    return 0;
  };
  check(H5Literate(group, H5_INDEX_NAME, H5_ITER_INC, nullptr, add, &names), "can't list a group");
  return names;
}

// Without the time of their making, so that equal runs give equal bytes.
Handle create_dataset_of(hid_t parent, const std::string& name, const Shape& shape, hid_t type)
{
  const std::string what = "can't create " + name;
  const Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, what);
  check(H5Pset_layout(properties, H5D_CONTIGUOUS), what);
  check(H5Pset_obj_track_times(properties, false), what);
  const Handle space = shape.empty()
    ? scalar_space()
    : Handle(
        H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), H5Sclose, what);
  return { H5Dcreate2(parent, name.c_str(), type, space, H5P_DEFAULT, properties, H5P_DEFAULT),
    H5Dclose, what };
}

Handle create_table(hid_t parent, const std::string& name, const std::vector<std::string>& columns,
  const Shape& records)
{
  const Handle record = record_type(columns, file_type<double>());
  return create_dataset_of(parent, name, records, record);
}

void write_table(hid_t table, const double* values, const std::string& name)
{
  const Handle record = record_type(columns_of_table(table, name), memory_type<double>());
  check(H5Dwrite(table, record, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), "can't write " + name);
}

std::vector<std::string> columns_of_table(hid_t table, const std::string& name)
{
  const Handle record(H5Dget_type(table), H5Tclose, "can't read " + name);
  if (H5Tget_class(record) != H5T_COMPOUND)
  {
    throw IoError(name + " is not a table");
  }
  std::vector<std::string> columns;
  for (int i = 0; i < H5Tget_nmembers(record); ++i)
  {
    char* const column = H5Tget_member_name(record, static_cast<unsigned>(i));
    columns.emplace_back(column ? column : "");
    H5free_memory(column);
  }
  return columns;
}

std::optional<std::uint64_t> place_of(hid_t dataset)
{
  // Asked for the place of a dataset that has none, HDF5 adds the user block to "undefined".
  return H5Dget_storage_size(dataset) > 0 ? std::optional<std::uint64_t>(H5Dget_offset(dataset))
                                          : std::nullopt;
}

Handle create_compressed_dataset_of(
  hid_t parent, const std::string& name, const Shape& shape, hid_t type)
{
  constexpr unsigned level = 4;
  if (std::find(shape.begin(), shape.end(), 0) != shape.end())
  {
    return create_dataset_of(parent, name, shape, type); // no chunk of nothing
  }
  const std::string what = "can't create " + name;
  const Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, what);
  const int rank = static_cast<int>(shape.size());
  check(H5Pset_chunk(properties, rank, shape.data()), what);
  check(H5Pset_shuffle(properties), what);
  check(H5Pset_deflate(properties, level), what);
  check(H5Pset_obj_track_times(properties, false), what);
  const Handle space(H5Screate_simple(rank, shape.data(), nullptr), H5Sclose, what);
  return { H5Dcreate2(parent, name.c_str(), type, space, H5P_DEFAULT, properties, H5P_DEFAULT),
    H5Dclose, what };
}

void write_text(hid_t parent, const std::string& name, const std::string& text)
{
  const Handle type = text_type(text.size());
  const Handle dataset = create_dataset_of(parent, name, {}, type);
  const std::string padded = text.empty() ? std::string(1, '\0') : text;
  check(
    H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, padded.data()), "can't write " + name);
}

std::string read_text(hid_t parent, const std::string& name)
{
  const Handle dataset = open_dataset(parent, name);
  require_single(Handle(H5Dget_space(dataset), H5Sclose, "can't read " + name), name);
  const Handle type(H5Dget_type(dataset), H5Tclose, "can't read " + name);
  std::string text(text_length(type, name), '\0');
  check(H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()), "can't read " + name);
  return trimmed(text.data(), text.size());
}

void write_attribute_of(
  hid_t object, const std::string& name, hid_t stored, hid_t memory, const void* value)
{
  const std::string what = "can't write the attribute " + name;
  const Handle space = scalar_space();
  const Handle attribute(
    H5Acreate2(object, name.c_str(), stored, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose, what);
  check(H5Awrite(attribute, memory, value), what);
}

void read_attribute_of(hid_t object, const std::string& name, hid_t memory, void* value)
{
  const Handle attribute(
    H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose, "there is no attribute " + name);
  require_single(Handle(H5Aget_space(attribute), H5Sclose, "can't read " + name), name);
  check(H5Aread(attribute, memory, value), "can't read the attribute " + name);
}

void write_attribute(hid_t object, const std::string& name, const std::vector<std::string>& texts)
{
  const std::string what = "can't write the attribute " + name;
  std::size_t length = 1;
  for (const auto& text : texts)
  {
    length = std::max(length, text.size());
  }
  std::vector<char> bytes(std::max<std::size_t>(1, texts.size()) * length, '\0');
  for (std::size_t i = 0; i < texts.size(); ++i)
  {
    std::copy(texts[i].begin(), texts[i].end(), bytes.begin() + static_cast<long>(i * length));
  }
  const hsize_t count = texts.size();
  const Handle space(H5Screate_simple(1, &count, nullptr), H5Sclose, what);
  const Handle type = text_type(length);
  const Handle attribute(
    H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose, what);
  check(H5Awrite(attribute, type, bytes.data()), what);
}

void write_attribute(hid_t object, const std::string& name, const std::string& text)
{
  const Handle type = text_type(text.size());
  write_attribute_of(object, name, type, type, text.c_str());
}

std::vector<std::string> read_text_attribute(hid_t object, const std::string& name)
{
  const std::string what = "can't read the attribute " + name;
  const Handle attribute(
    H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose, "there is no attribute " + name);
  const Handle type(H5Aget_type(attribute), H5Tclose, what);
  const Handle space(H5Aget_space(attribute), H5Sclose, what);
  const std::size_t length = text_length(type, name);
  const hssize_t count = H5Sget_simple_extent_npoints(space);
  check(count < 0 ? -1 : 0, what);
  std::vector<char> bytes(static_cast<std::size_t>(count) * length + 1);
  check(H5Aread(attribute, type, bytes.data()), what);
  std::vector<std::string> texts;
  for (hssize_t i = 0; i < count; ++i)
  {
    texts.push_back(trimmed(bytes.data() + static_cast<std::size_t>(i) * length, length));
  }
  return texts;
}

bool has_attribute(hid_t object, const std::string& name)
{
  return H5Aexists(object, name.c_str()) > 0;
}

namespace
{

/// Of files that are never on a disk.
Handle memory_access()
{
  const std::size_t growth = 1 << 20; // bytes at a time
  const bool on_disk = false;
  Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "file in memory");
  check(H5Pset_fapl_core(access, growth, on_disk), "file in memory");
  return access;
}

/// HDF5 takes files in memory for the same if they have the same name.
std::string new_name()
{
  static std::atomic<int> count = 0;
  return "file in memory " + std::to_string(++count);
}

}

Handle create_in_memory(hsize_t user_block)
{
  const Handle access = memory_access();
  // Small datasets stand where they are written, one after the other.
  check(H5Pset_small_data_block_size(access, 0), "file in memory");
  const Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose, "file in memory");
  check(H5Pset_userblock(creation, user_block), "file in memory");
  const unsigned chunks =
    1; // half of what a dataset's index has room for: by default it takes 3 KB
  check(H5Pset_istore_k(creation, chunks), "file in memory");
  return { H5Fcreate(new_name().c_str(), H5F_ACC_TRUNC, creation, access), H5Fclose,
    "file in memory" };
}

std::string image_of(hid_t file)
{
  check(H5Fflush(file, H5F_SCOPE_GLOBAL), "file in memory");
  const Handle creation(H5Fget_create_plist(file), H5Pclose, "file in memory");
  hsize_t user_block = 0;
  check(H5Pget_userblock(creation, &user_block), "file in memory");
  const ssize_t size = H5Fget_file_image(file, nullptr, 0); // without the user block
  check(size < 0 ? -1 : 0, "file in memory");
  std::string image(user_block + static_cast<std::size_t>(size), '\0');
  const ssize_t copied =
    H5Fget_file_image(file, image.data() + user_block, static_cast<std::size_t>(size));
  check(copied < 0 ? -1 : 0, "file in memory");
  return image;
}

Handle open_in_memory(std::string_view image)
{
  const Handle access = memory_access();
  // HDF5 copies the bytes and doesn't change these.
  check(H5Pset_file_image(access, const_cast<char*>(image.data()), image.size()), "file in memory");
  return { H5Fopen(new_name().c_str(), H5F_ACC_RDONLY, access), H5Fclose, "file in memory" };
}

}
