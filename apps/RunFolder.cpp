#include "apps/RunFolder.h"

#include "apps/StopBundle.h"

#include "solver/Errors.h"
#include "solver/files/FileBytes.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <system_error>

#include <unistd.h>

namespace vesicle
{
namespace
{

using std::filesystem::path;
using Files = std::vector<path>;

constexpr std::string_view unfinished = ".part";

bool consists_of(std::string_view text, char first, char last)
{
  return std::all_of(text.begin(), text.end(), [=](char c) { return c >= first && c <= last; });
}

/// PREFIX, six or more digits.
bool is_numbered(std::string_view stem, std::string_view prefix)
{
  constexpr std::size_t least_digits = 6;
  return stem.size() >= prefix.size() + least_digits && stem.starts_with(prefix) &&
    consists_of(stem.substr(prefix.size()), '0', '9');
}

/// Files of a folder with that ending, of whose names without it the test holds; empty if there is
/// no such folder.
Files matching(const path& folder, const std::string& ending,
  const std::function<bool(std::string_view stem)>& test)
{
  Files files;
  std::error_code missing;
  for (const auto& entry : std::filesystem::directory_iterator(folder, missing))
  {
    const std::string name = entry.path().filename().string();
    if (name.ends_with(ending) && test(name.substr(0, name.size() - ending.size())))
    {
      files.push_back(entry.path());
    }
  }
  return files;
}

void remove(const Files& files)
{
  for (const auto& file : files)
  {
    std::error_code error;
    std::filesystem::remove(file, error);
    if (error)
    {
      throw IoError(fmt::format("{}: can't be removed: {}", file.string(), error.message()));
    }
  }
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

Files RunFolder::named_files() const
{
  Files files{ checkpoint(), table(), film(), file(".pvd"), file(".vtu.series"), file(".xdmf"),
    summary() };
  for (const char* name : StopBundle::files)
    files.push_back(stopped() / name);
  return files;
}

Files RunFolder::numbered_files(std::string_view before_ending) const
{
  Files found;
  const auto add = [&](const path& folder, const std::string& ending, const auto& test)
  {
    const auto files = matching(folder, std::string(before_ending) + ending, test);
    found.insert(found.end(), files.begin(), files.end());
  };
  const auto is_frame = [&](std::string_view stem) { return is_numbered(stem, name_ + "_"); };
  add(folder_ / "frames", ".vtu", is_frame);
  add(folder_ / "frames", ".h5", is_frame);
  add(pictures(), ".png", [](std::string_view stem) { return is_numbered(stem, "frame_"); });
  add(plots(), ".png",
    [](std::string_view stem) { return !stem.empty() && consists_of(stem, 'a', 'z'); });
  return found;
}

Files RunFolder::files() const
{
  Files found = numbered_files("");
  for (const auto& file : named_files())
  {
    if (is_there(file))
    {
      found.push_back(file);
    }
  }
  return found;
}

void RunFolder::sweep() const
{
  Files parts = numbered_files(unfinished);
  for (const auto& file : named_files())
  {
    const path part = unfinished_name(file);
    if (is_file(part))
    {
      parts.push_back(part);
    }
  }
  remove(parts);
}

void RunFolder::clear_but_checkpoint() const
{
  sweep();
  Files rest = files();
  rest.erase(std::remove(rest.begin(), rest.end(), checkpoint()), rest.end());
  remove(rest);
  for (const auto& folder : { folder_ / "frames", pictures(), plots(), stopped() })
  {
    ::rmdir(folder.c_str()); // if it is one, and empty
  }
}

path run_folder_of(const Scene& scene, const std::string& chosen)
{
  return chosen.empty() ? scene.output.directory.value_or(scene.name) : path(chosen);
}

}
