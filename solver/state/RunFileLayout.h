#pragma once
// What stands where in a run file (RunFile.h describes it): making one from scratch and reading
// one. Include in sources only.

#include "solver/state/Hdf5.h"
#include "solver/state/RunFile.h"
#include "solver/state/RunFileHead.h"

namespace vesicle
{

/// Stands for "no value" in the series: the lowest double, which no quantity of a run can be.
inline constexpr double missing_value = -1.7976931348623157e308;

/// Everything that a run file holds.
struct RunFileContents
{
  RunFile::Header header;
  std::vector<double> series; ///< row by row; `missing_value` where empty
  State state;                ///< meaningless while there are no rows

  /// Numbers of a step, and the steps.
  std::size_t row_length() const { return header.columns.size() * header.triangles.size(); }
  std::size_t rows() const { return series.size() / row_length(); }
};

struct RunFileImage
{
  std::string bytes; ///< of the whole file
  RunFileHead head;
};

/// With room for `capacity` rows of the series.
RunFileImage run_file_image(const RunFileContents& contents, std::size_t capacity);
/// Throws IoError if the bytes aren't those of a run file, undamaged, whose state and series are
/// finite.
RunFileContents read_contents(const std::string& file);

/// The name of a field of `state` that has something else than numbers; empty: none. Step sizes may be
/// infinite where nothing limits them.
std::string first_unusable_field(const State& state);
/// The shapes that the fields of `state` take in the file.
std::vector<hdf5::Shape> field_shapes(const State& state);
/// What stands in the state's slot, all fields one after the other.
std::string state_bytes(const State& state);
std::string numbers_bytes(const std::vector<double>& numbers);

}
