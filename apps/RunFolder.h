#pragma once
// The folder that a run writes to, and what it leaves behind there.

#include "solver/scene/Scene.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace vesicle
{

class RunFolder
{
public:
  RunFolder(std::filesystem::path folder, std::string name);

  const std::filesystem::path& folder() const { return folder_; }
  std::filesystem::path checkpoint() const { return file(".h5"); }
  std::filesystem::path table() const { return file(".csv"); }
  std::filesystem::path film() const { return file(".mp4"); }
  std::filesystem::path pictures() const { return folder_ / "movie"; }
  std::filesystem::path plots() const { return folder_ / "plots"; }
  /// What is left where the simulation could not go on (StopBundle.h).
  std::filesystem::path stopped() const { return folder_ / "stopped"; }
  std::filesystem::path summary() const { return folder_ / "summary.json"; }

  /// Locked while somebody writes to the folder.
  std::filesystem::path lock() const { return folder_ / "vesicle.lock"; }

  /// The files of an existing run; empty if there is none.
  std::vector<std::filesystem::path> files() const;
  /// Removes what a run that was killed left unfinished. Throws IoError.
  void sweep() const;
  /// Removes what a run leaves behind and nothing else, but for its checkpoint. Throws IoError.
  void clear_but_checkpoint() const;

private:
  std::filesystem::path file(const std::string& ending) const;
  std::vector<std::filesystem::path> named_files() const;
  /// Frames, pictures and plots, with this before the ending of their names.
  std::vector<std::filesystem::path> numbered_files(std::string_view before_ending) const;

  std::filesystem::path folder_;
  std::string name_;
};

/// Where a run of the scene writes to: `chosen` unless that is empty, else the scene's or ./<name>.
std::filesystem::path run_folder_of(const Scene& scene, const std::string& chosen);

}
