#pragma once
// What stands where in a run file (RunFile.h describes it): making one from scratch and reading
// one. Include in sources only.

#include "solver/state/Hdf5.h"
#include "solver/state/RunFile.h"

#include <array>

namespace vesicle
{

/// Stands for "no value" in the series: the lowest double, which no quantity of a run can be.
inline constexpr double missing_value = -1.7976931348623157e308;

/// Everything that a run file holds.
struct RunFileContents
{
  RunFile::Header header;
  std::vector<std::vector<double>>
    columns;   ///< of the series, equally long; `missing_value` where empty
  State state; ///< meaningless while there are no rows

  std::size_t rows() const { return columns.empty() ? 0 : columns.front().size(); }
};

/// The bytes of a run file with room for `capacity` rows of the series.
std::vector<char> run_file_image(const RunFileContents& contents, std::size_t capacity);

/// The datasets of an open run file that an append writes to.
struct RunFileDatasets
{
  std::size_t capacity = 0;
  hdf5::Handle committed;
  std::vector<hdf5::Handle> columns;
  std::array<std::vector<hdf5::Handle>, 2> slots; ///< of the state, in the order of for_each_field
  std::vector<hdf5::Shape> state_shapes;          ///< of its fields; empty while there are no rows
};

/// Throw IoError if `file` isn't a run file.
RunFileContents read_contents(hid_t file);
RunFileDatasets open_datasets(hid_t file, const RunFile::Header& header);

/// The shapes that the fields of `state` take in the file.
std::vector<hdf5::Shape> field_shapes(const State& state);
void write_state(const std::vector<hdf5::Handle>& slot, const State& state);

}
