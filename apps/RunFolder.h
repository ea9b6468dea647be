#pragma once
// The folder that a run writes to, and what it leaves behind there.

#include <filesystem>
#include <string>
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
  std::filesystem::path summary() const { return folder_ / "summary.json"; }

  /// The files of an existing run; empty if there is none.
  std::vector<std::filesystem::path> leftovers() const;
  /// Removes what a run leaves behind and nothing else. Throws IoError if another run holds it.
  void clear() const;

private:
  std::filesystem::path file(const std::string& ending) const;

  std::filesystem::path folder_;
  std::string name_;
};

}
