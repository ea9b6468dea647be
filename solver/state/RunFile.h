#pragma once
// The HDF5 run file: checkpoint and scalar time series of a run.
//   /scene           text: the scene as TOML, every setting spelled out
//   /triangles/vesicle_0   int32  #triangles × 3, of the start mesh, and so on for each vesicle
//   /series          a table: one record an accepted step, its fields (double) the columns in
//                    order; missing values hold the dataset's attribute `missing_value` (the lowest
//                    double). Of several vesicles one record a step and vesicle
//   /committed       int64: how many steps of the series count. While a run is under way the
//                    table is longer (room to come, filled with missing_value); closing the file
//                    cuts it
//   /state/0, /state/1
//                    one dataset a field of State, those of a vesicle in a group vesicle_0, … The
//                    last accepted state is in /state/<committed modulo 2>, the other is older
//   attributes of /  format, layout_version, vesicle_version, length_scale, time_scale,
//                    energy_scale, viscosity
// All datasets are plain and contiguous, without chunks, filters or NaN. HDF5's user block has
// checksums of everything (RunFileHead.h), by which a damaged file is told before HDF5 sees it.
//
// Every append leaves a file from which a run can go on, whatever happens in the middle of it: it
// writes the new row, the older of the two states and the checksums that make them count, in place
// and without HDF5, and brings that to the disk. When there is no room for another row (or the
// state has another size) a whole new file with twice the room takes the place of the old one by a
// rename. So a full disk doesn't hurt what has been saved either.
//
// Who writes the file has to keep others from doing so (FileLock.h).

#include "solver/dynamics/State.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vesicle
{

class RunFile
{
public:
  struct Header
  {
    std::string scene;
    std::vector<Triangles> triangles; ///< of each vesicle
    double length_scale = 1, time_scale = 1, energy_scale = 1, viscosity = 1;
    std::vector<std::string> columns; ///< names of the scalar series, at least one, all different
  };

  /// Creates `file` or replaces it by one without rows. Throws IoError.
  static RunFile create(const std::filesystem::path& file, const Header& header);
  /// Reads an existing file to go on with it, and leaves it alone until something is appended.
  /// Throws InputError if there is none, IoError if it isn't a run file of this layout, undamaged.
  static RunFile open(const std::filesystem::path& file);
  ~RunFile();
  RunFile(RunFile&&) noexcept;
  RunFile& operator=(RunFile&&) noexcept;

  const Header& header() const;
  /// How many steps were appended so far.
  std::size_t rows() const;
  /// The last checkpointed state, bit for bit. Throws IoError if nothing was appended yet.
  State state() const;
  /// The scalar series so far: one row an accepted step, values in the order of header().columns, of
  /// each vesicle one after the other.
  std::vector<std::vector<std::optional<double>>> series() const;

  /// Appends a step to the series (values in the order of the columns, of each vesicle one after the
  /// other) and replaces the state.
  /// Throws as require_finite does, and IoError if the file can't be written; what was appended
  /// before is then still there.
  void append(const State& state, const std::vector<std::optional<double>>& row);
  /// Cuts the series to their length. The file is whole without that. Throws IoError.
  void close();

private:
  struct Impl;
  explicit RunFile(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// Throws NumericalError naming what isn't finite of a state and a row of these columns for each of its
/// vesicles: neither is to be saved.
void require_finite(const State& state, const std::vector<std::string>& columns,
  const std::vector<std::optional<double>>& row);

}
