#pragma once
// Small owners around the HDF5 C API: what is opened is closed, and what fails is an IoError with
// the library's own reason. Include in sources only.

#include <hdf5.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vesicle::hdf5
{

/// Keeps the library from printing its error stack while in scope.
class QuietErrors
{
public:
  QuietErrors();
  ~QuietErrors();
  QuietErrors(const QuietErrors&) = delete;
  QuietErrors& operator=(const QuietErrors&) = delete;

private:
  H5E_auto2_t print_ = nullptr;
  void* data_ = nullptr;
};

/// Owns an HDF5 identifier of any kind.
class Handle
{
public:
  using Close = herr_t (*)(hid_t);

  Handle() = default;
  /// Throws IoError "what: reason" if `id` is none.
  Handle(hid_t id, Close close, const std::string& what);
  ~Handle() { reset(); }
  Handle(Handle&& other) noexcept;
  Handle& operator=(Handle&& other) noexcept;

  operator hid_t() const { return id_; }
  void reset();

private:
  hid_t id_ = H5I_INVALID_HID;
  Close close_ = nullptr;
};

/// Throws IoError "what: reason" if `status` is an error.
void check(herr_t status, const std::string& what);
/// What the library says about its last failure, from the outermost call to the cause.
std::string failure();

using Shape = std::vector<hsize_t>; ///< empty: a scalar

/// The stored (little-endian, whatever the machine) and the machine's type of a number.
template<class T>
hid_t file_type();
template<class T>
hid_t memory_type();
template<>
inline hid_t file_type<double>()
{
  return H5T_IEEE_F64LE;
}
template<>
inline hid_t memory_type<double>()
{
  return H5T_NATIVE_DOUBLE;
}
template<>
inline hid_t file_type<std::int64_t>()
{
  return H5T_STD_I64LE;
}
template<>
inline hid_t memory_type<std::int64_t>()
{
  return H5T_NATIVE_INT64;
}
template<>
inline hid_t file_type<int>()
{
  return H5T_STD_I32LE;
}
template<>
inline hid_t memory_type<int>()
{
  return H5T_NATIVE_INT;
}

Handle create_group(hid_t parent, const std::string& name);
Handle open_group(hid_t parent, const std::string& name);
/// How many groups and datasets are in it.
std::size_t member_count(hid_t group);
Handle open_dataset(hid_t parent, const std::string& name);
Shape shape_of(hid_t dataset, const std::string& name);
/// What stands in a group, in alphabetical order.
std::vector<std::string> names_in(hid_t group);

/// A dataset in one piece that gets its place in the file when it is written.
template<class T>
Handle create_dataset(hid_t parent, const std::string& name, const Shape& shape);
/// A table: a dataset of records, each of doubles with these names, next to each other.
Handle create_table(hid_t parent, const std::string& name, const std::vector<std::string>& columns,
  const Shape& records);
/// `values` record by record.
void write_table(hid_t table, const double* values, const std::string& name);
std::vector<std::string> columns_of_table(hid_t table, const std::string& name);
/// Where in the file a dataset's first byte is; nothing while it has none.
std::optional<std::uint64_t> place_of(hid_t dataset);
/// A dataset in one compressed chunk, to be written as a whole.
template<class T>
Handle create_compressed_dataset(hid_t parent, const std::string& name, const Shape& shape);
template<class T>
void write(hid_t dataset, const T* values, const std::string& name);
template<class T>
void read(hid_t dataset, T* values, const std::string& name);

void write_text(hid_t parent, const std::string& name, const std::string& text);
std::string read_text(hid_t parent, const std::string& name);

template<class T>
void write_attribute(hid_t object, const std::string& name, T value);
template<class T>
T read_attribute(hid_t object, const std::string& name);
void write_attribute(hid_t object, const std::string& name, const std::vector<std::string>& texts);
void write_attribute(hid_t object, const std::string& name, const std::string& text);
/// Of one text or a list.
std::vector<std::string> read_text_attribute(hid_t object, const std::string& name);
bool has_attribute(hid_t object, const std::string& name);

/// A file that is built in memory; it has room for datasets of one chunk each. The first
/// `user_block` bytes (a power of two from 512, or 0) are not HDF5's.
Handle create_in_memory(hsize_t user_block = 0);
/// The bytes that a file would have on disk, the user block zero.
std::string image_of(hid_t file);
/// For reading. HDF5 trusts what stands in a file: damaged bytes may crash it.
Handle open_in_memory(std::string_view image);

// ---------------------------------------------------------------------------------------------

Handle create_dataset_of(hid_t parent, const std::string& name, const Shape& shape, hid_t type);
Handle create_compressed_dataset_of(
  hid_t parent, const std::string& name, const Shape& shape, hid_t type);
void write_attribute_of(
  hid_t object, const std::string& name, hid_t stored, hid_t memory, const void* value);
void read_attribute_of(hid_t object, const std::string& name, hid_t memory, void* value);

template<class T>
Handle create_dataset(hid_t parent, const std::string& name, const Shape& shape)
{
  return create_dataset_of(parent, name, shape, file_type<T>());
}

template<class T>
Handle create_compressed_dataset(hid_t parent, const std::string& name, const Shape& shape)
{
  return create_compressed_dataset_of(parent, name, shape, file_type<T>());
}

template<class T>
void write(hid_t dataset, const T* values, const std::string& name)
{
  check(H5Dwrite(dataset, memory_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values),
    "can't write " + name);
}

template<class T>
void read(hid_t dataset, T* values, const std::string& name)
{
  check(H5Dread(dataset, memory_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values),
    "can't read " + name);
}

template<class T>
void write_attribute(hid_t object, const std::string& name, T value)
{
  write_attribute_of(object, name, file_type<T>(), memory_type<T>(), &value);
}

template<class T>
T read_attribute(hid_t object, const std::string& name)
{
  T value{};
  read_attribute_of(object, name, memory_type<T>(), &value);
  return value;
}

}
