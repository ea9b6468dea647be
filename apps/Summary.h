#pragma once
// summary.json: what a run was, what it gave and with what it was computed.

#include "solver/dynamics/Diagnostics.h"
#include "solver/scene/Scene.h"
#include "solver/simulation/DimensionlessNumbers.h"
#include "solver/simulation/ErrorEstimate.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace vesicle
{

struct RunSummary
{
  Scene scene;
  std::string outcome;           ///< finished, steady, interrupted or failed
  std::string message;           ///< why it failed
  std::vector<Diagnostics> last; ///< of the last state, each vesicle's; none was reached: empty
  std::optional<ErrorEstimate> errors;
  DimensionlessNumbers numbers;
  std::size_t frames = 0;
  int triangles = 0;
  double wall_seconds = 0; ///< of this sitting
  double cpu_seconds = 0;  ///< of this sitting, of all threads
  std::int64_t steps = 0;  ///< of this sitting
  bool resumed = false;
  std::string movie_note;
};

/// Throws IoError.
void write_summary(const RunSummary& summary, const std::filesystem::path& file);

}
