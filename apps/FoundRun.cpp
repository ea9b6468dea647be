#include "apps/FoundRun.h"

#include "solver/Errors.h"
#include "solver/Joined.h"
#include "solver/files/FileBytes.h"

#include <fmt/format.h>

#include <algorithm>

namespace vesicle
{
namespace
{

/// Of checkpoints and of series.
std::vector<std::string> run_names(const std::filesystem::path& folder)
{
  std::vector<std::string> names;
  std::error_code unreadable;
  for (const auto& entry : std::filesystem::directory_iterator(folder, unreadable))
  {
    const std::string ending = entry.path().extension().string();
    const std::string name = entry.path().stem().string();
    if ((ending == ".h5" || ending == ".pvd") && !name.ends_with(".part"))
    {
      names.push_back(name);
    }
  }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

}

FoundRun run_in(const std::filesystem::path& folder)
{
  const auto names = run_names(folder);
  if (names.empty())
  {
    throw InputError(folder.string() +
      ": there is no run in this folder, that is neither <name>.h5 nor <name>.pvd; give the folder "
      "that `vesicle run` wrote to");
  }
  if (names.size() > 1)
  {
    throw InputError(
      fmt::format("{}: there are several runs in this folder: {}; give the series of "
                  "one of them, as {}",
        folder.string(), joined(names, ", "), (folder / (names.front() + ".pvd")).string()));
  }
  FoundRun run{ RunFolder(folder, names.front()), names.front(), {}, {} };
  const auto series = folder / (run.name + ".pvd");
  run.beside = run_beside(series);
  if (is_there(series))
  {
    run.frames = read_series(series);
  }
  return run;
}

}
