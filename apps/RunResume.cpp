#include "apps/RunResume.h"

#include "apps/RunTable.h"

#include "solver/Errors.h"
#include "solver/simulation/Simulation.h"
#include "solver/scene/SceneFile.h"
#include "solver/state/RunRows.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <vector>

namespace vesicle
{
namespace
{

/// The scene without what may change from one sitting to the next, line by line.
std::vector<std::string> fixed_lines(Scene scene)
{
  scene.time.end = 1;
  scene.movie = {};
  scene.output.directory.reset();
  std::istringstream text(write_scene(scene));
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);)
  {
    lines.push_back(line);
  }
  return lines;
}

std::string first_difference(
  const std::vector<std::string>& now, const std::vector<std::string>& then)
{
  std::size_t i = 0;
  while (i < now.size() && i < then.size() && now[i] == then[i])
  {
    ++i;
  }
  const auto line = [i](const std::vector<std::string>& lines)
  { return i < lines.size() && !lines[i].empty() ? lines[i] : std::string("(nothing)"); };
  return fmt::format("'{}' now, '{}' then", line(now), line(then));
}

/// Throws InputError: the run can't go on, as it has something that this program doesn't know.
[[noreturn]] void refuse_version(const std::filesystem::path& file, const std::string& difference)
{
  throw InputError(fmt::format("{}: was written by another version of the program, with {}; go on "
                               "with that version, or start anew with --overwrite",
    file.string(), difference));
}

/// The scene as it was when the run was started.
Scene scene_of(const RunFile& run, const std::filesystem::path& file)
{
  try
  {
    return parse_scene(run.header().scene, file.string());
  }
  catch (const InputError&)
  {
    refuse_version(file, "other keys in its scene");
  }
}

}

void require_same_scene(const Scene& scene, const RunFile& run, const std::filesystem::path& file)
{
  if (run.header().columns != run_columns(rows_of(scene_of(run, file))))
  {
    refuse_version(file, "other columns");
  }
  const auto now = fixed_lines(scene);
  const auto then = fixed_lines(scene_of(run, file));
  if (now != then)
  {
    throw InputError(
      fmt::format("{}: the scene is not the one of this run: {}. Only time.end and the "
                  "movie may change; use another folder or --overwrite",
        file.string(), first_difference(now, then)));
  }
  const double reached = run.state().time;
  if (scene.time.end && *scene.time.end < reached)
  {
    throw InputError(
      fmt::format("{}: the run has reached t = {}, past time.end = {}; set a later end",
        file.string(), reached, *scene.time.end));
  }
}

void require_same_mesh(
  Simulation& simulation, const RunFile& run, const std::filesystem::path& file)
{
  const auto& then = run.header().triangles;
  const std::vector<Triangles> now = simulation.start_triangles();
  if (!std::equal(then.begin(), then.end(), now.begin(), now.end(), same_triangles) ||
    simulation.scales().length != run.header().length_scale)
  {
    throw InputError(file.string() +
      ": the start mesh is not the one of this run; bring the old mesh file back or use "
      "--overwrite");
  }
}

}
