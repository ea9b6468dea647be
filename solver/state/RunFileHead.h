#pragma once
// The first 16 KiB of a run file, HDF5's user block: where in the file the numbers stand that change
// from step to step, and checksums over all of it. It is checked before HDF5 sees the file, since
// HDF5 trusts what it reads. Include in sources only.
//
//   at      what (integers of 8 bytes, the lowest first; the rest is zero)
//   0       "VESICLE RUN FILE", layout version, then the fields of RunFileHead in order, checksum of
//           what HDF5 keeps from byte 16384 to `slots` (names, scene, triangles), checksum of the
//           bytes before
//   4096, 8192
//           the last two commits, that of an even number of rows first: rows, checksum of the state
//           in /state/<rows modulo 2>, checksum of the rows of /series, checksum of the bytes before
//   slots   the states' fields, those of /state/0 then those of /state/1, in the order of
//           for_each_field; behind them the rows of /series and /committed

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace vesicle
{

inline constexpr std::size_t run_file_head_size = 16384;
inline constexpr std::uint64_t run_file_layout_version = 5; ///< of everything in the file

/// Places are bytes from the file's beginning; each part begins where the one before ends.
struct RunFileHead
{
  std::uint64_t slots = 0;     ///< place of the two states
  std::uint64_t slot_size = 0; ///< bytes of each
  std::uint64_t series = 0;    ///< place of the rows
  std::uint64_t row_size = 0;  ///< bytes of each
  std::uint64_t capacity = 0;  ///< how many rows there is room for
  std::uint64_t committed = 0; ///< place of the number of rows, the last 8 bytes of the file

  std::uint64_t slot(std::uint64_t rows) const { return slots + rows % 2 * slot_size; }
  std::uint64_t row(std::uint64_t index) const { return series + index * row_size; }
};

/// What makes the first `rows` rows and the state behind them count.
struct RunFileCommit
{
  std::uint64_t rows = 0;
  std::uint64_t state = 0;  ///< checksum
  std::uint64_t series = 0; ///< checksum

  std::uint64_t place() const { return 4096 * (1 + rows % 2); }
  std::string bytes() const;
};

/// Puts the head at the beginning of a file's bytes, with the checksum of what it finds there.
void write_head(const RunFileHead& head, std::string& file);

struct CheckedRunFile
{
  RunFileHead head;
  RunFileCommit commit; ///< the last one that holds
};

/// Throws IoError unless the bytes are those of a run file of this layout, undamaged.
CheckedRunFile checked_run_file(std::string_view file);

}
