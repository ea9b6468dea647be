#include "solver/state/RunFileHead.h"

#include "solver/Errors.h"
#include "solver/files/Checksum.h"
#include "solver/state/LittleEndian.h"

#include <fmt/format.h>

#include <array>
#include <optional>

namespace vesicle
{
namespace
{

constexpr std::string_view signature = "VESICLE RUN FILE";
constexpr std::string_view hdf5_signature = "\x89HDF\r\n\x1a\n";

[[noreturn]] void damaged()
{
  throw IoError("is damaged: its checksums don't hold; bring a copy of it back, or start anew with "
                "--overwrite");
}

void append_number(std::string& bytes, std::uint64_t number)
{
  append_numbers(bytes, &number, 1);
}

/// What precedes the head's own checksum.
std::string head_bytes(const RunFileHead& head, std::string_view file)
{
  const std::array<std::uint64_t, 8> numbers{ run_file_layout_version, head.slots, head.slot_size,
    head.series, head.row_size, head.capacity, head.committed,
    checksum(file.substr(run_file_head_size, head.slots - run_file_head_size)) };
  std::string bytes(signature);
  append_numbers(bytes, numbers.data(), numbers.size());
  return bytes;
}

void require_signature(std::string_view file)
{
  if (file.substr(0, hdf5_signature.size()) == hdf5_signature)
  {
    throw IoError("is an HDF5 file but not a run file of this version; go on with the version of "
                  "the program that wrote it, or start anew with --overwrite");
  }
  if (file.substr(0, signature.size()) != signature)
  {
    throw IoError("is not a run file");
  }
}

/// Parts of the file that are where they can be, whatever stands in it.
bool fits(const RunFileHead& h, std::size_t size)
{
  const auto follows =
    [](std::uint64_t from, std::uint64_t count, std::uint64_t each, std::uint64_t to)
  {
    return from <= to && (each == 0 ? from == to : count == (to - from) / each) &&
      (each == 0 || (to - from) % each == 0);
  };
  return h.slots >= run_file_head_size && h.committed <= size && size - h.committed == 8 &&
    follows(h.slots, 2, h.slot_size, h.series) &&
    follows(h.series, h.capacity, h.row_size, h.committed);
}

RunFileHead checked_head(std::string_view file)
{
  require_signature(file);
  if (file.size() < run_file_head_size)
  {
    damaged();
  }
  const auto field = [&](std::size_t i)
  { return number_at<std::uint64_t>(file, signature.size() + 8 * i); };
  constexpr std::size_t fields = 8;
  if (checksum(file.substr(0, signature.size() + 8 * fields)) != field(fields))
  {
    damaged();
  }
  if (field(0) != run_file_layout_version)
  {
    throw IoError(
      fmt::format("has layout version {}, this program knows version {}; go on with the "
                  "version of the program that wrote it, or start anew with --overwrite",
        field(0), run_file_layout_version));
  }
  const RunFileHead head{ field(1), field(2), field(3), field(4), field(5), field(6) };
  if (!fits(head, file.size()) || head_bytes(head, file) != file.substr(0, signature.size() + 64))
  {
    damaged();
  }
  return head;
}

/// The commit in a place of its own, if it holds.
std::optional<RunFileCommit> commit_in(
  std::string_view file, const RunFileHead& head, std::uint64_t parity)
{
  const std::size_t place = RunFileCommit{ parity, 0, 0 }.place();
  const auto field = [&](std::size_t i) { return number_at<std::uint64_t>(file, place + 8 * i); };
  const RunFileCommit commit{ field(0), field(1), field(2) };
  const bool holds = commit.bytes() == file.substr(place, 32) && commit.rows % 2 == parity &&
    commit.rows <= head.capacity &&
    checksum(file.substr(head.slot(commit.rows), head.slot_size)) == commit.state &&
    checksum(file.substr(head.series, commit.rows * head.row_size)) == commit.series;
  return holds ? std::optional(commit) : std::nullopt;
}

}

std::string RunFileCommit::bytes() const
{
  std::string bytes;
  for (const std::uint64_t number : { rows, state, series })
  {
    append_number(bytes, number);
  }
  append_number(bytes, checksum(bytes));
  return bytes;
}

void write_head(const RunFileHead& head, std::string& file)
{
  std::string bytes = head_bytes(head, file);
  append_number(bytes, checksum(bytes));
  file.replace(0, bytes.size(), bytes);
}

CheckedRunFile checked_run_file(std::string_view file)
{
  const RunFileHead head = checked_head(file);
  const auto even = commit_in(file, head, 0), odd = commit_in(file, head, 1);
  if (!even && !odd)
  {
    damaged();
  }
  return { head, !odd || (even && even->rows > odd->rows) ? *even : *odd };
}

}
