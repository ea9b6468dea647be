#pragma once
// What a run leaves for whoever wants to know why it stopped: the folder `stopped` beside its other files.

#include "apps/CsvFile.h"

#include "solver/simulation/Simulation.h"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace vesicle
{

struct StopBundle
{
  static constexpr std::array files{ "good.vtu", "failing.vtu", "diagnostics.csv", "scene.toml",
    "advice.txt" };

  std::string message; ///< of the error
  double time = 0;     ///< of the last good state
  TriangleMesh good;   ///< the last good shape, in the scene's units; the start where there is none
  std::optional<TriangleMesh>
    failing;                        ///< what couldn't be accepted; empty where nothing came so far
  std::vector<std::string> columns; ///< of the diagnostics
  std::vector<Row> rows;            ///< a line each
  std::size_t vesicles = 1;
};

/// good.vtu and failing.vtu, the latter with the cell array Guilty (1 where guilty_triangles() says so),
/// diagnostics.csv (the last rows), scene.toml, advice.txt. Returns the advice. Throws IoError.
std::string write_stop_bundle(
  const Scene& scene, const StopBundle& bundle, const std::filesystem::path& folder);

/// One sentence of what to try.
std::string advice(const Scene& scene, const StopBundle& bundle);

}
