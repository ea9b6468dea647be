#pragma once

#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace vesicle::test
{

/// A folder of one's own, removed in the end.
class TemporaryFolder
{
public:
  TemporaryFolder()
  {
    const std::string name = "vesicle-" + std::string(6, 'X'); // which mkdtemp makes unique
    std::string pattern = (std::filesystem::temp_directory_path() / name).string();
    if (!mkdtemp(pattern.data()))
    {
      throw std::runtime_error("no temporary folder");
    }
    path_ = pattern;
  }
  ~TemporaryFolder()
  {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

private:
  std::filesystem::path path_;
};

}
