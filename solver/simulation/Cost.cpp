#include "solver/simulation/Cost.h"

#include "solver/Errors.h"
#include "solver/files/FileBytes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>
#include <string>

#include <unistd.h>

namespace vesicle
{

namespace
{

// Fitted to 320, 1,280 and 5,120 triangles on flat triangles and on Loop's surface, one vesicle and two, and
// 64 and 1,000 of 320: the memory, with a dense matrix and without, and the time of a step on one core. What a mesh
// fixes is there once for all vesicles on it.
constexpr double program_bytes = 7e7;
constexpr double flat_bytes_a_triangle = 2.3e4, loop_bytes_a_triangle = 4.4e4,
                 loop_bytes_a_shared_triangle = 9.1e4;
constexpr double dense_bytes_a_pair = 27;
constexpr double flat_seconds_a_pair = 1.7e-8, loop_seconds_a_pair = 2.5e-8;
// From so many triangles on, clusters act on clusters: the time grows as their number.
constexpr double most_paired_triangles = 8e3;
// Points, triangles and a dozen point arrays.
constexpr double frame_bytes_a_triangle = 120;
// Colours and depths, with the samples that smooth edges.
constexpr double bytes_a_pixel = 64;
// More than this is a mistake, whatever the machine.
constexpr double most_frames = 1e6, most_steps = 1e9;

// Runs that write less than this are begun on any disk: a full one stops them with its own message.
constexpr double least_refused = 1e9;

/// The whole number in a file of the system, infinite where there is none ("max").
double number_in(const char* file)
{
  std::ifstream in(file);
  double number;
  return in >> number ? number : INFINITY;
}

std::string gigabytes(double bytes)
{
  return bytes < 1e12 ? fmt::format("{:.3g} GB", bytes / 1e9)
                      : fmt::format("{:.3g} TB", bytes / 1e12);
}

double step_seconds(const Scene& scene, double triangles)
{
  if (scene.accuracy.basis == Scene::Basis::linear)
    return flat_seconds_a_pair * triangles * triangles;
  const bool clusters =
    scene.accuracy.layer == LayerMethod::automatic || scene.accuracy.layer == LayerMethod::tree;
  return loop_seconds_a_pair * triangles *
    (clusters ? std::min(triangles, most_paired_triangles) : triangles);
}

/// Of all vesicles the part that has meshes of its own: shapes of as many triangles have one.
double different_meshes(const Scene& scene)
{
  std::set<std::string> meshes;
  for (std::size_t v = 0; v < scene.vesicles(); ++v)
  {
    const Scene::Vesicle& vesicle = v == 0 ? scene.vesicle : scene.companions[v - 1].vesicle;
    meshes.insert(
      vesicle.mesh_file ? vesicle.mesh_file->string() : std::to_string(vesicle.shape.triangles));
  }
  return static_cast<double>(meshes.size()) / static_cast<double>(scene.vesicles());
}

double loop_bytes(const Scene& scene, double triangles)
{
  return triangles *
    (loop_bytes_a_triangle + loop_bytes_a_shared_triangle * different_meshes(scene));
}

}

double shape_triangles(const Scene& scene)
{
  double sum = 0;
  const auto add = [&](const Scene::Vesicle& vesicle)
  { sum += vesicle.mesh_file ? 0 : vesicle.shape.triangles; };
  add(scene.vesicle);
  for (const Scene::Companion& companion : scene.companions)
    add(companion.vesicle);
  return sum;
}

Cost cost_of(const Scene& scene, double triangles)
{
  const bool flat = scene.accuracy.basis == Scene::Basis::linear,
             dense = flat || scene.accuracy.layer == LayerMethod::dense;
  const double pairs = triangles * triangles;
  Cost cost;
  cost.memory = program_bytes +
    (flat ? flat_bytes_a_triangle * triangles : loop_bytes(scene, triangles)) +
    (dense ? dense_bytes_a_pair * pairs : 0);
  if (scene.time.end && scene.time.output_every > 0)
    cost.frames = *scene.time.end / scene.time.output_every + 1;
  if (scene.time.end && scene.time.step)
    cost.steps = *scene.time.end / *scene.time.step;
  cost.steps = std::max(cost.steps, cost.frames - 1);
  cost.step_seconds = step_seconds(scene, triangles);
  cost.seconds = cost.steps * cost.step_seconds;
  cost.disk = cost.frames * frame_bytes_a_triangle * triangles;
  cost.picture = bytes_a_pixel * scene.movie.size[0] * scene.movie.size[1];
  return cost;
}

Resources resources_for(const std::filesystem::path& folder)
{
  const double pages = static_cast<double>(sysconf(_SC_PHYS_PAGES));
  const double page = static_cast<double>(sysconf(_SC_PAGE_SIZE));
  Resources available;
  available.memory = std::min(pages * page, number_in("/sys/fs/cgroup/memory.max"));
  std::filesystem::path existing = std::filesystem::absolute(folder);
  std::error_code unknown;
  while (!is_there(existing) && existing.has_relative_path())
    existing = existing.parent_path();
  const auto space = std::filesystem::space(existing, unknown);
  available.disk = unknown ? INFINITY : static_cast<double>(space.available);
  return available;
}

namespace
{

/// The problem, behind the scene's file where there is one.
[[noreturn]] void refuse(const Scene& scene, const std::string& problem)
{
  throw InputError(scene.file.empty() ? problem : scene.file.string() + ": " + problem);
}

void require_memory(const Scene& scene, double memory, double available)
{
  if (!(memory <= available))
    refuse(scene,
      fmt::format("the run would take about {} of memory, of {} that there are: take fewer "
                  "triangles (vesicle.triangles)",
        gigabytes(memory), gigabytes(available)));
}

}

void require_memory(const Scene& scene, double triangles)
{
  require_memory(scene, cost_of(scene, triangles).memory, resources_for(".").memory);
}

void require_affordable(const Scene& scene, double triangles, const Resources& available)
{
  const Cost cost = cost_of(scene, triangles);
  require_memory(scene, cost.memory, available.memory);
  if (!(cost.picture <= available.memory))
    refuse(scene,
      fmt::format(
        "a picture of the movie would take about {} of memory, of {} that there are: take "
        "a smaller movie.size",
        gigabytes(cost.picture), gigabytes(available.memory)));
  if (!(cost.frames <= most_frames))
    refuse(scene,
      fmt::format("the run would write {:.3g} frames, over {:.0e}: take a longer "
                  "time.output_every, or an earlier time.end",
        cost.frames, most_frames));
  if (!(cost.disk <= std::max(available.disk, least_refused)))
    refuse(scene,
      fmt::format("the run would write {:.3g} frames, {} of which {} are free: take "
                  "a longer time.output_every, or fewer triangles",
        cost.frames, gigabytes(cost.disk), gigabytes(available.disk)));
  if (!(cost.steps <= most_steps))
    refuse(scene,
      fmt::format("the run would take {:.3g} steps, over {:.0e}: take a longer "
                  "time.step, or an earlier time.end",
        cost.steps, most_steps));
}

}
