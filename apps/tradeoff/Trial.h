#pragma once
// One run of a trade-off: what it was to be, what became of it.

#include "apps/tradeoff/Settings.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace vesicle::tradeoff
{

struct Trial
{
  enum class Outcome
  {
    waiting, ///< not run (yet)
    finished,
    failed,  ///< the simulation could not go on
    refused, ///< the scene can't be computed with these settings
    left_out ///< would have overrun the budget
  };
  explicit Trial(Settings s = {}) : settings(std::move(s)) {}

  Settings settings;
  Scene scene; ///< with these settings, unless refused
  Outcome outcome = Outcome::waiting;
  std::string message; ///< why it is neither finished nor waiting
  double cpu_seconds = 0;
  double steps = 0, rejected = 0;
  double end = 0; ///< in time
  /// By the names of observables (Observables.h): of the last row or rows, without those that are
  /// undefined; and the largest magnitude of each column over the run.
  std::map<std::string, double> values, scales;
  std::optional<double> space_estimate, time_estimate; ///< the run's own, relative

  bool finished() const { return outcome == Outcome::finished; }
  /// Of all vesicles.
  double triangles() const
  {
    return static_cast<double>(settings.triangles) * static_cast<double>(scene.vesicles());
  }
  std::optional<double> value(const std::string& observable) const
  {
    const auto found = values.find(observable);
    return found == values.end() ? std::nullopt : std::optional(found->second);
  }
};

const char* outcome_name(Trial::Outcome outcome);

/// Where the runs of a trade-off are: DIR/runs/<label>, beside <label>.toml.
class TrialFolder
{
public:
  explicit TrialFolder(const std::filesystem::path& folder) : folder_(folder / "runs") {}

  const std::filesystem::path& folder() const { return folder_; }
  std::filesystem::path scene_file(const Settings& settings) const;
  std::filesystem::path run_folder(const Settings& settings) const;

private:
  std::filesystem::path folder_;
};

/// Fills the trial from what a run of its scene left in the folder; false where there is no such run, or
/// one of another scene, or one that was interrupted (how far that came is filled in).
bool read_trial(const TrialFolder& folder, Trial& trial);

/// What a run is likely to take on one processor, of `steps` steps; `triangles` of all vesicles.
double expected_seconds(const Scene& scene, double triangles, double steps);

}
