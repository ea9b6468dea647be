#pragma once
// Runs of a scene with many settings, each a process of its own in a folder of its own.

#include "apps/ParameterGrid.h"

#include <filesystem>
#include <string>
#include <vector>

namespace vesicle
{

class ChildRun;

struct SweepSettings
{
  std::filesystem::path scene, folder;
  std::vector<std::string> overrides; ///< of all runs
  std::vector<ParameterRange> ranges;
  int jobs = 1;    ///< runs at a time
  int threads = 0; ///< of each; 0: the processors shared out
  bool movies = false, quiet = false;
};

class ParameterSweep
{
public:
  /// Reads the scene with each setting: throws InputError where one can't be run.
  explicit ParameterSweep(SweepSettings settings);

  /// Runs what is missing or goes on with it, until Ctrl-C. The table is written anew after each
  /// run. Returns the exit code: the largest of the runs'. Throws IoError.
  int run();
  /// <folder>/sweep.csv: a row a run with folder, settings, state and its last row of diagnostics.
  void write_table() const;
  std::filesystem::path table() const;
  /// A job array for Slurm that does the same, a run a job.
  void write_slurm(const std::filesystem::path& file) const;

private:
  std::filesystem::path folder_of(const GridPoint& point) const;
  std::vector<std::string> arguments_of(const GridPoint& point) const;
  std::string state_of(const GridPoint& point) const;
  int record(const GridPoint& point, const ChildRun& child) const;

  SweepSettings settings_;
  std::vector<GridPoint> grid_;
};

}
