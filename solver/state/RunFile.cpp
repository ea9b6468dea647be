#include "solver/state/RunFile.h"

#include "solver/Errors.h"
#include "solver/files/FileBytes.h"
#include "solver/state/RunFileLayout.h"
#include "solver/state/StateFields.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <system_error>

namespace vesicle
{
namespace
{

using hdf5::Handle;
using hdf5::QuietErrors;

constexpr std::size_t first_capacity = 256; // rows: 2 KiB a column

/// Runs `work` with the file's name before the message of whatever fails.
template<class Work>
auto about(const std::filesystem::path& file, const Work& work)
{
  try
  {
    return work();
  }
  catch (const IoError& error)
  {
    throw IoError(file.string() + ": " + error.what());
  }
}

std::string reason_for_no_open(const std::filesystem::path& file)
{
  const std::string reasons = hdf5::failure();
  const auto says = [&](const char* text) { return reasons.find(text) != std::string::npos; };
  if (says("unable to lock file"))
  {
    return "locked by another run (or open in another program); wait for it or end it";
  }
  if (says("file signature not found"))
  {
    return "is not an HDF5 file";
  }
  if (says("Permission denied") || says("Read-only"))
  {
    return "can't be written: no permission";
  }
  return fmt::format("can't be opened as an HDF5 file ({})",
    std::filesystem::is_directory(file) ? "it is a folder" : reasons);
}

/// Opens for writing and locks. HDF5 locks against other processes only; within this one it would
/// share the open file.
Handle open_locked(const std::filesystem::path& file)
{
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "access properties");
  const bool lock = true, do_without_where_impossible = true; // file systems that know no locks
  hdf5::check(H5Pset_file_locking(access, lock, do_without_where_impossible), "file locking");
  const hid_t id = H5Fopen(file.c_str(), H5F_ACC_RDWR, access);
  if (id < 0)
  {
    throw IoError(reason_for_no_open(file));
  }
  Handle handle(id, H5Fclose, "file");
  if (H5Fget_obj_count(handle, H5F_OBJ_FILE) > 1)
  {
    throw IoError("locked by another run in this program");
  }
  return handle;
}

void check_columns(const std::vector<std::string>& columns)
{
  const std::set<std::string> different(columns.begin(), columns.end());
  const bool usable = std::all_of(columns.begin(), columns.end(),
    [](const std::string& name)
    { return !name.empty() && name != "." && name.find('/') == std::string::npos; });
  if (columns.empty() || different.size() != columns.size() || !usable)
  {
    throw IoError("the series needs columns with different names, not empty and without '/'");
  }
}

bool all_finite(std::int64_t)
{
  return true;
}
/// Step sizes may be infinite where nothing limits them.
bool all_finite(double)
{
  return true;
}
bool all_finite(const Points& points)
{
  return points.allFinite();
}
bool all_finite(const Eigen::VectorXd& vector)
{
  return vector.allFinite();
}

void check_state(const State& state)
{
  for_each_field(state,
    [](const std::string& name, const auto& field)
    {
      if (!all_finite(field))
      {
        throw NumericalError(
          "the state's " + name + " isn't finite: it can't be saved as a state to go on from");
      }
    });
}

std::vector<double> checked_row(
  const std::vector<std::string>& columns, const std::vector<std::optional<double>>& row)
{
  if (row.size() != columns.size())
  {
    throw IoError(fmt::format("a row of {} values for {} columns", row.size(), columns.size()));
  }
  std::vector<double> values;
  for (std::size_t i = 0; i < row.size(); ++i)
  {
    if (row[i] && (!std::isfinite(*row[i]) || *row[i] == missing_value))
    {
      throw NumericalError(fmt::format("{} = {} can't be saved: not finite", columns[i], *row[i]));
    }
    values.push_back(row[i].value_or(missing_value));
  }
  return values;
}

}

struct RunFile::Impl
{
  std::filesystem::path file;
  RunFileContents contents; // as committed
  State previous;           // the state before the last append, should that have to be taken back
  Handle hdf;
  RunFileDatasets datasets;

  Impl(std::filesystem::path path, Handle handle)
    : file(std::move(path)), contents(read_contents(handle)), hdf(std::move(handle)),
      datasets(open_datasets(hdf, contents.header))
  {
  }

  bool has_room_for(const State& state) const
  {
    return contents.rows() < datasets.capacity && field_shapes(state) == datasets.state_shapes;
  }

  /// The order matters: until /committed is written the file says what it said before.
  void write_in_place(const State& state, const std::vector<double>& row)
  {
    const std::size_t rows = contents.rows() + 1;
    for (std::size_t i = 0; i < row.size(); ++i)
    {
      hdf5::write_element(datasets.columns[i], rows - 1, row[i], contents.header.columns[i]);
    }
    write_state(datasets.slots[rows % 2], state);
    flush();
    const auto committed = static_cast<std::int64_t>(rows);
    hdf5::write(datasets.committed, &committed, "committed");
    flush();
  }

  void flush() { hdf5::check(H5Fflush(hdf, H5F_SCOPE_LOCAL), "can't write"); }

  /// Replaces the file by a new one with `next` and room for `capacity` rows.
  void rewrite(const RunFileContents& next, std::size_t capacity)
  {
    const std::filesystem::path part = file.string() + ".part";
    const auto image = run_file_image(next, capacity);
    write_to_disk(part, { image.data(), image.size() }, IfExists::replace);
    try
    {
      Handle handle = open_locked(part);
      RunFileDatasets opened = open_datasets(handle, next.header);
      std::filesystem::rename(part, file);
      datasets = std::move(opened);
      hdf = std::move(handle);
    }
    catch (const std::exception& error)
    {
      std::error_code ignored;
      std::filesystem::remove(part, ignored);
      throw IoError(error.what());
    }
  }

  void append(const State& state, const std::vector<double>& row)
  {
    const bool in_place = has_room_for(state);
    if (in_place)
    {
      write_in_place(state, row);
    }
    add_to_contents(state, row);
    if (!in_place)
    {
      try
      {
        rewrite(contents, std::max(first_capacity, 2 * contents.rows()));
      }
      catch (...)
      {
        remove_last_row();
        throw;
      }
    }
  }

  void add_to_contents(const State& state, const std::vector<double>& row)
  {
    for (std::size_t i = 0; i < row.size(); ++i)
    {
      contents.columns[i].push_back(row[i]);
    }
    std::swap(contents.state, previous);
    contents.state = state;
  }

  void remove_last_row()
  {
    for (auto& column : contents.columns)
    {
      column.pop_back();
    }
    std::swap(contents.state, previous);
  }

  /// A clean end: the datasets as long as the series.
  void cut()
  {
    if (datasets.capacity != contents.rows())
    {
      rewrite(contents, contents.rows());
    }
  }
};

RunFile::RunFile(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

RunFile::RunFile(RunFile&&) noexcept = default;

RunFile& RunFile::operator=(RunFile&& other) noexcept
{
  std::swap(impl_, other.impl_);
  return *this;
}

RunFile::~RunFile()
{
  if (!impl_)
  {
    return;
  }
  const QuietErrors quiet;
  try
  {
    impl_->cut();
  }
  catch (const std::exception&)
  {
    // The file is whole without being cut.
  }
  impl_.reset();
}

RunFile RunFile::create(const std::filesystem::path& file, const Header& header)
{
  const QuietErrors quiet;
  about(file, [&] { check_columns(header.columns); });
  std::error_code ignored;
  if (std::filesystem::exists(file, ignored))
  {
    throw IoError(file.string() + ": exists already; go on with it or remove it");
  }
  RunFileContents contents;
  contents.header = header;
  contents.columns.resize(header.columns.size());
  const auto image = about(file, [&] { return run_file_image(contents, 0); });
  write_to_disk(file, { image.data(), image.size() }, IfExists::fail);
  return open(file);
}

RunFile RunFile::open(const std::filesystem::path& file)
{
  const QuietErrors quiet;
  std::error_code missing;
  // Without links, so that a rename replaces the file and not a link to it.
  const auto real = std::filesystem::canonical(file, missing);
  if (missing)
  {
    throw IoError(file.string() + ": can't be opened: " + missing.message());
  }
  if (std::filesystem::is_regular_file(real) && std::filesystem::is_empty(real))
  {
    throw IoError(file.string() + ": is not an HDF5 file"); // HDF5 would make it one
  }
  return about(file, [&] { return RunFile(std::make_unique<Impl>(real, open_locked(real))); });
}

const RunFile::Header& RunFile::header() const
{
  return impl_->contents.header;
}

State RunFile::state() const
{
  if (impl_->contents.rows() == 0)
  {
    throw IoError(impl_->file.string() + ": holds no state yet");
  }
  return impl_->contents.state;
}

std::vector<std::vector<std::optional<double>>> RunFile::series() const
{
  const auto& columns = impl_->contents.columns;
  std::vector<std::vector<std::optional<double>>> rows(impl_->contents.rows());
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    for (const auto& column : columns)
    {
      rows[i].push_back(
        column[i] == missing_value ? std::nullopt : std::optional<double>(column[i]));
    }
  }
  return rows;
}

void RunFile::append(const State& state, const std::vector<std::optional<double>>& row)
{
  const QuietErrors quiet;
  const auto values = checked_row(header().columns, row);
  check_state(state);
  about(impl_->file, [&] { impl_->append(state, values); });
}

}
