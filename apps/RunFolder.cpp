#include "apps/RunFolder.h"

#include "solver/Errors.h"

#include <fmt/format.h>

#include <regex>
#include <system_error>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace vesicle
{
namespace
{

using std::filesystem::path;

/// HDF5 locks what it writes to with flock().
bool is_locked(const path& file)
{
  const int descriptor = open(file.c_str(), O_RDONLY);
  if (descriptor < 0)
  {
    return false;
  }
  const bool locked = flock(descriptor, LOCK_EX | LOCK_NB) != 0;
  close(descriptor);
  return locked;
}

/// Files of a folder whose names match; empty if there is no such folder.
std::vector<path> matching(const path& folder, const std::regex& name)
{
  std::vector<path> files;
  std::error_code missing;
  for (const auto& entry : std::filesystem::directory_iterator(folder, missing))
  {
    if (std::regex_match(entry.path().filename().string(), name))
    {
      files.push_back(entry.path());
    }
  }
  return files;
}

std::string literally(const std::string& text)
{
  return std::regex_replace(text, std::regex(R"([.^$|()\[\]{}*+?\\])"), R"(\$&)");
}

}

RunFolder::RunFolder(path folder, std::string name)
  : folder_(std::move(folder)), name_(std::move(name))
{
}

path RunFolder::file(const std::string& ending) const
{
  return folder_ / (name_ + ending);
}

std::vector<path> RunFolder::leftovers() const
{
  std::vector<path> found;
  std::error_code ignored;
  for (const auto& candidate :
    { checkpoint(), table(), film(), file(".pvd"), file(".vtu.series"), file(".xdmf"), summary() })
  {
    if (std::filesystem::exists(candidate, ignored))
    {
      found.push_back(candidate);
    }
  }
  const auto add = [&](const std::vector<path>& files)
  { found.insert(found.end(), files.begin(), files.end()); };
  add(matching(folder_ / "frames", std::regex(literally(name_) + R"(_\d{6,}(\.part)?\.(vtu|h5))")));
  add(matching(pictures(), std::regex(R"(frame_\d{6,}\.png)")));
  add(matching(plots(), std::regex(R"([a-z]+\.png)")));
  return found;
}

void RunFolder::clear() const
{
  if (is_locked(checkpoint()))
  {
    throw IoError(checkpoint().string() + ": locked by another run; wait for it or end it");
  }
  for (const auto& file : leftovers())
  {
    std::error_code error;
    std::filesystem::remove(file, error);
    if (error)
    {
      throw IoError(fmt::format("{}: can't be removed: {}", file.string(), error.message()));
    }
  }
  std::error_code not_empty;
  std::filesystem::remove(folder_ / "frames", not_empty);
  std::filesystem::remove(pictures(), not_empty);
  std::filesystem::remove(plots(), not_empty);
}

}
