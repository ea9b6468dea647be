#include "solver/state/RunFile.h"

#include "solver/Errors.h"
#include "solver/files/Checksum.h"
#include "solver/files/FileBytes.h"
#include "solver/files/OpenFile.h"
#include "solver/state/LittleEndian.h"
#include "solver/state/RunFileLayout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

namespace vesicle
{
namespace
{

using hdf5::QuietErrors;

constexpr const char* remedy =
  "Check the units of the scene, or try a milder flow, load or deflation.";
constexpr std::size_t first_capacity = 256; // rows

/// Runs `work` with the file's name before the message of what fails, unless it is there already.
template<class Work>
void about(const std::filesystem::path& file, const Work& work)
{
  try
  {
    work();
  }
  catch (const IoError& error)
  {
    const std::string message = error.what();
    const std::string name = file.string() + ": ";
    throw IoError(message.starts_with(name) ? message : name + message);
  }
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

std::vector<double> numbers_of(const std::vector<std::optional<double>>& row)
{
  std::vector<double> values;
  std::transform(row.begin(), row.end(), std::back_inserter(values),
    [](const std::optional<double>& value) { return value.value_or(missing_value); });
  return values;
}

}

void require_finite(const State& state, const std::vector<std::string>& columns,
  const std::vector<std::optional<double>>& row)
{
  if (row.size() != columns.size() * state.vesicles.size())
  {
    throw IoError(fmt::format("a row of {} values for {} columns of {} vesicles", row.size(),
      columns.size(), state.vesicles.size()));
  }
  for (std::size_t i = 0; i < row.size(); ++i)
  {
    if (row[i] && (!std::isfinite(*row[i]) || *row[i] == missing_value))
    {
      throw NumericalError(fmt::format("{} = {}, beyond what can be computed with. {}",
        columns[i % columns.size()], *row[i], remedy));
    }
  }
  if (const std::string field = first_unusable_field(state); !field.empty())
  {
    throw NumericalError(fmt::format("{} isn't finite. {}", field, remedy));
  }
}

struct RunFile::Impl
{
  std::filesystem::path path;
  RunFileContents contents; // as committed

  // Once something was appended in this sitting: the file and how it is laid out.
  std::optional<OpenFile> file;
  RunFileHead head;
  std::vector<hdf5::Shape> state_shapes;
  std::uint64_t series_checksum = 0;

  bool has_room_for(const State& state) const
  {
    return file && contents.rows() < head.capacity && field_shapes(state) == state_shapes;
  }

  /// Changes numbers only: the next row, the older of the two states, then what makes them count.
  /// The checksums tell if the disk got these in another order.
  void write_in_place(const State& state, const std::vector<double>& row)
  {
    const std::uint64_t rows = contents.rows();
    const std::string row_bytes = numbers_bytes(row), fields = state_bytes(state);
    const RunFileCommit commit{ rows + 1, checksum(fields), checksum(row_bytes, series_checksum) };
    std::string committed;
    append_numbers(committed, &commit.rows, 1);
    file->write_at(head.row(rows), row_bytes);
    file->write_at(head.slot(commit.rows), fields);
    file->write_at(commit.place(), commit.bytes());
    file->write_at(head.committed, committed);
    file->sync();
    series_checksum = commit.series;
  }

  /// Replaces the file by a new one with `next` and room for `capacity` rows.
  void rewrite(RunFileContents next, std::size_t capacity)
  {
    const RunFileImage image = run_file_image(next, capacity);
    replace_file(path, image.bytes);
    file.emplace(path);
    head = image.head;
    state_shapes = field_shapes(next.state);
    series_checksum = checksum(numbers_bytes(next.series));
    contents = std::move(next);
  }

  void append(const State& state, const std::vector<double>& row)
  {
    if (has_room_for(state))
    {
      write_in_place(state, row);
      contents.series.insert(contents.series.end(), row.begin(), row.end());
      contents.state = state;
    }
    else
    {
      RunFileContents next = contents;
      next.series.insert(next.series.end(), row.begin(), row.end());
      next.state = state;
      const std::size_t capacity = std::max(first_capacity, 2 * next.rows());
      rewrite(std::move(next), capacity);
    }
  }

  void close()
  {
    file.reset();
    const std::string bytes = run_file_image(contents, contents.rows()).bytes;
    if (!is_there(path) || read_file(path) != bytes)
    {
      replace_file(path, bytes);
    }
  }
};

RunFile::RunFile(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

RunFile::~RunFile() = default;

RunFile::RunFile(RunFile&&) noexcept = default;

RunFile& RunFile::operator=(RunFile&&) noexcept = default;

RunFile RunFile::create(const std::filesystem::path& file, const Header& header)
{
  const QuietErrors quiet;
  auto impl = std::make_unique<Impl>();
  impl->path = file;
  impl->contents.header = header;
  about(file,
    [&]
    {
      check_columns(header.columns);
      replace_file(file, run_file_image(impl->contents, 0).bytes);
    });
  return RunFile(std::move(impl));
}

RunFile RunFile::open(const std::filesystem::path& file)
{
  const QuietErrors quiet;
  auto impl = std::make_unique<Impl>();
  impl->path = file;
  const std::string bytes = read_file(file);
  about(file, [&] { impl->contents = read_contents(bytes); });
  return RunFile(std::move(impl));
}

void RunFile::close()
{
  const QuietErrors quiet;
  about(impl_->path, [&] { impl_->close(); });
}

const RunFile::Header& RunFile::header() const
{
  return impl_->contents.header;
}

std::size_t RunFile::rows() const
{
  return impl_->contents.rows();
}

State RunFile::state() const
{
  if (rows() == 0)
  {
    throw IoError(impl_->path.string() + ": holds no state yet");
  }
  return impl_->contents.state;
}

std::vector<std::vector<std::optional<double>>> RunFile::series() const
{
  const std::size_t length = impl_->contents.row_length();
  std::vector<std::vector<std::optional<double>>> rows(this->rows());
  auto value = impl_->contents.series.begin();
  for (auto& row : rows)
  {
    for (std::size_t i = 0; i < length; ++i, ++value)
    {
      row.push_back(*value == missing_value ? std::nullopt : std::optional<double>(*value));
    }
  }
  return rows;
}

void RunFile::append(const State& state, const std::vector<std::optional<double>>& row)
{
  const QuietErrors quiet;
  require_finite(state, header().columns, row);
  about(impl_->path, [&] { impl_->append(state, numbers_of(row)); });
}

}
