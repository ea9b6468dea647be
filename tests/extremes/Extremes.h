#pragma once
// What becomes of scenes at the ends of what can be asked for.

#include "solver/mesh/TriangleMesh.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace vesicle::test
{

/// One scene of a row of a map: `axis` is what is varied, `value` how far.
struct Cell
{
  std::string axis, value;
  std::string scene; ///< TOML
  double strain =
    1; ///< how far the fluid is sheared, or how many of its own times the membrane has
  std::function<TriangleMesh()>
    mesh = {}; ///< makes what it starts from; empty: what the scene says
};

struct CellResult
{
  enum class End
  {
    runs,    ///< to its end, and everything that can be checked is right
    refused, ///< before it started
    stopped, ///< the simulation could not go on
    crawls,  ///< more steps than its strain allows
    wrong    ///< an answer that can't be, or an error that isn't one of the three
  };
  End end;
  std::string message; ///< why it doesn't run
  double time = 0;     ///< that it came to
  int steps = 0;       ///< accepted and refused ones
  double energy = 0;   ///< E/8πEB at the end
  double longest = 0;  ///< semi-axis at the end, in the scene's units
  double estimate = 0; ///< the run's own error, in space and time
  /// What the membrane's energy changed by less the power of all that acts on it, over the sum of
  /// what came in and what was lost; empty: no energy, or no steps between.
  std::optional<double> imbalance = std::nullopt;
};

/// Accepted and refused steps a unit of strain.
inline constexpr double most_steps = 400;

/// The rows of a map on meshes of so many triangles.
std::vector<Cell> extremes(int triangles);
CellResult run_cell(const Cell& cell);
/// By how much two runs of a cell differ at the end, relative: in energy or in length, whichever is more.
double difference(const CellResult& a, const CellResult& b);
const char* end_name(CellResult::End end);

}
