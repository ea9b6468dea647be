#pragma once
// Where a case's rows and pictures go.

#include "apps/validate/Row.h"

#include "render/Chart.h"
#include "render/Picture.h"

#include <chrono>
#include <filesystem>
#include <optional>
#include <vector>

namespace vesicle
{
struct State;
class Simulation;
}

namespace vesicle::validation
{

/// Rows are printed as they come, and the JSON file holds those that came so far.
class Report
{
public:
  struct Options
  {
    bool full = false;
    std::optional<std::filesystem::path> json;
    std::optional<std::filesystem::path> plots; ///< a folder; made if it isn't there
  };
  /// Throws IoError where JSON file or folder can't be written.
  explicit Report(Options options);

  bool full() const { return options_.full; }
  /// The triangles of a simulation: 1,280 in the full set, 320 in the fast one.
  int triangles() const { return full() ? 1280 : 320; }

  /// What the next rows are about; their names are put behind the case's.
  void begin(const std::string& name, const std::string& about);
  void add(Row row);

  /// Charts in one picture, DIR/<name>.png; nothing without a folder.
  void chart(const std::string& name, const std::vector<ChartSpec>& charts, int columns = 1) const;
  /// A state, coloured by an array; nothing without a folder.
  void picture(const std::string& name, Simulation& simulation, const State& state,
    PictureSettings settings) const;
  bool draws() const { return options_.plots.has_value(); }

  const std::vector<Row>& rows() const { return rows_; }
  int failures() const;
  /// The last line.
  void print_total() const;

private:
  using Clock = std::chrono::steady_clock;

  void write_json() const;

  Options options_;
  std::string case_;
  std::vector<Row> rows_;
  Clock::time_point began_, last_;
};

}
