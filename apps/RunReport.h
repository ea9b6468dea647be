#pragma once
// What `vesicle info` says of a run.

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace vesicle
{

struct RunReport
{
  std::filesystem::path folder;
  std::string name;
  std::string state;         ///< running, finished, steady, interrupted, failed, killed
  std::string reason;        ///< why it is so, in words
  std::string remedy;        ///< a command that goes on; empty: there is nothing to go on with
  double time = 0;           ///< that was reached
  std::optional<double> end; ///< of the scene; empty: until steady, or unknown
  std::size_t frames = 0;
  double last_frame_time = 0;
  std::filesystem::path last_frame;
  using LastRow = std::map<std::string, std::optional<double>>;
  LastRow last;                ///< row of the table, by column; of several vesicles the first's
  std::vector<LastRow> others; ///< of the further vesicles
};

/// Of the one run in a folder; nothing there is changed, and it may be under way. Throws
/// InputError.
RunReport report_of_run(const std::filesystem::path& folder);

std::string to_text(const RunReport& report);
nlohmann::ordered_json to_json(const RunReport& report);

}
