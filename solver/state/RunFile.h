#pragma once
// The HDF5 run file: checkpoint and scalar time series of a run.
//   /scene           string: the scene as TOML, every setting spelled out
//   /triangles       int32  #triangles × 3
//   /state/…         the last accepted State, one dataset a field
//   /series/<name>   double, one entry an accepted step, chunked and extendable; missing values hold
//                    the dataset's attribute `missing_value`
//   attributes of /  vesicle_version, length_scale, time_scale, energy_scale, viscosity
// Every append leaves a file from which a run can go on, also if the program is killed in between.

#include "solver/state/State.h"

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
    Triangles triangles;
    double length_scale = 1, time_scale = 1, energy_scale = 1, viscosity = 1;
    std::vector<std::string> columns; ///< names of the scalar series
  };

  /// Creates `file` (which must not exist). Throws IoError.
  static RunFile create(const std::filesystem::path& file, const Header& header);
  /// Opens an existing file to go on with it. Throws IoError (missing, locked, not a run file).
  static RunFile open(const std::filesystem::path& file);
  ~RunFile();
  RunFile(RunFile&&) noexcept;
  RunFile& operator=(RunFile&&) noexcept;

  const Header& header() const;
  /// The last checkpointed state, bit for bit.
  State state() const;
  /// The scalar series so far: one row an accepted step, values in the order of header().columns.
  std::vector<std::vector<std::optional<double>>> series() const;

  /// Appends one row to the series (values in the order of the columns) and replaces the state.
  void append(const State& state, const std::vector<std::optional<double>>& row);

private:
  struct Impl;
  explicit RunFile(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}
