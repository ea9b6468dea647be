// vesicle fill: copies of a scene's vesicle at random in a box, a tube or a ball.

#include "apps/Commands.h"
#include "apps/StandardOutput.h"
#include "apps/Warning.h"

#include "solver/Errors.h"
#include "solver/files/FileBytes.h"
#include "solver/mesh/JoinedMesh.h"
#include "solver/mesh/MeshIntegrals.h"
#include "solver/scene/SceneFile.h"
#include "solver/simulation/Filling.h"
#include "solver/simulation/StartOverlap.h"
#include "vtkfilters/Filters/MeshConversion.h"
#include "vtkfilters/Filters/MeshFiles.h"
#include "vtkfilters/Filters/SceneMesh.h"
#include "vtkfilters/Filters/SceneNumbers.h"

#include "vtkPolyData.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>
#include <numbers>

namespace vesicle
{
namespace
{

struct FillOptions
{
  std::string scene, output;
  std::vector<std::string> overrides;
  std::array<double, 3> box{};
  std::array<double, 2> tube{};
  double ball = 0;
  std::array<double, 3> center{};
  double gap = 0.1;
  bool aligned = false;
  FillSettings settings;
};

FillRegion region_of(const FillOptions& o)
{
  FillRegion region;
  if (o.tube[0] > 0)
    region = { FillRegion::Kind::tube, Vector3(o.tube[1], 0, 0), o.tube[0] };
  else if (o.ball > 0)
    region = { FillRegion::Kind::ball, Vector3::Zero(), o.ball };
  else if (o.box[0] > 0)
    region.sides = Vector3(o.box[0], o.box[1], o.box[2]);
  else
    throw InputError("there is no region to fill: give --box, --tube or --ball");
  region.center = Vector3(o.center.data());
  return region;
}

/// The turn that a scene gives its vesicle, and then the placement's.
std::array<double, 4> rotation_of(const Scene::Vesicle& vesicle, const Placement& placement)
{
  const Eigen::AngleAxisd turn(placement.turn * Eigen::Quaterniond(orientation(vesicle)));
  const Vector3& axis = turn.axis();
  return { axis[0], axis[1], axis[2], turn.angle() * 180 / std::numbers::pi };
}

Scene::Vesicle placed(Scene::Vesicle vesicle, const Placement& placement, bool aligned)
{
  if (vesicle.mesh_file)
    vesicle.mesh_center = placement.center;
  else
    vesicle.center = placement.center;
  if (!aligned)
    vesicle.rotation = rotation_of(vesicle, placement);
  return vesicle;
}

Scene filled_scene(Scene scene, const std::vector<Placement>& placements, bool aligned)
{
  const Scene::Vesicle alone = scene.vesicle;
  scene.vesicle = placed(alone, placements.front(), aligned);
  for (std::size_t i = 1; i < placements.size(); ++i)
  {
    Scene::Companion companion = scene.companion();
    companion.vesicle = placed(alone, placements[i], aligned);
    scene.companions.push_back(std::move(companion));
  }
  return scene;
}

void write_meshes(const std::vector<TriangleMesh>& meshes, const std::string& file)
{
  std::vector<int> ids;
  for (std::size_t v = 0; v < meshes.size(); ++v)
    ids.insert(ids.end(), meshes[v].points.rows(), static_cast<int>(v));
  const auto surface = to_polydata(joined(meshes));
  add_vesicle_ids(ids, surface);
  warn(write_mesh(surface, file));
}

int fill_region(FillOptions options)
{
  const bool to_scene = options.output.ends_with(".toml");
  if (!to_scene)
    require_mesh_ending(options.output);
  const Scene scene = read_scene(options.scene, options.overrides).alone(0);
  std::string notes;
  TriangleMesh shape = start_mesh_of(scene, notes);
  warn(notes);
  shape.points.rowwise() -= volume_centroid(shape).transpose();
  const double volume = flat_volume(shape), r0 = std::cbrt(3 * volume / (4 * std::numbers::pi));
  options.settings.region = region_of(options);
  options.settings.gap = options.gap * r0;
  options.settings.turned = !options.aligned;
  options.settings.wall = scene.wall;
  const std::vector<Placement> placements = fill(shape, options.settings);
  std::vector<TriangleMesh> meshes;
  for (const Placement& p : placements)
    meshes.push_back(
      { (shape.points * p.turn.toRotationMatrix().transpose()).rowwise() + p.center.transpose(),
        shape.triangles });
  if (const auto overlap = find_overlap(meshes))
    throw InputError(to_text(*overlap) + ": take a larger --gap, or more triangles");
  if (to_scene)
    replace_file(
      options.output, write_editable_scene(filled_scene(scene, placements, options.aligned)));
  else
    write_meshes(meshes, options.output);
  print("{}\n{} vesicles of {} triangles, {:.3g}% of the region's volume\n", options.output,
    meshes.size(), shape.triangles.rows(),
    100 * static_cast<double>(meshes.size()) * volume / options.settings.region.volume());
  return exit_code::done;
}

}

void add_fill_command(CLI::App& app, Action& action)
{
  auto options = std::make_shared<FillOptions>();
  FillSettings& settings = options->settings;
  auto* command = app.add_subcommand(
    "fill", "Copies of a scene's vesicle at random places, apart from each other");
  command->add_option("scene", options->scene, "Scene (TOML), whose first vesicle is copied")
    ->required();
  command
    ->add_option("-o,--output", options->output,
      "Scene (.toml) to write, the same but for its vesicles; or all of them as one mesh")
    ->required();
  command->add_option("--count", settings.count, "How many")
    ->required()
    ->check(CLI::Range(1, 100'000));
  const std::string about = " around --center, in the scene's length";
  auto* box = command->add_option("--box", options->box, "Sides x y z of a box" + about)
                ->check(CLI::PositiveNumber);
  auto* tube =
    command->add_option("--tube", options->tube, "Radius and length of a cylinder along x" + about)
      ->check(CLI::PositiveNumber)
      ->excludes(box);
  command->add_option("--ball", options->ball, "Radius of a ball" + about)
    ->check(CLI::PositiveNumber)
    ->excludes(box)
    ->excludes(tube);
  command->add_option("--center", options->center, "Of box, tube or ball; the origin if left out")
    ->check(CLI::Number);
  command
    ->add_option("--gap", options->gap,
      "Between two vesicles, and above the scene's wall, at the least; in r0 of the vesicle")
    ->check(CLI::NonNegativeNumber)
    ->capture_default_str();
  command->add_option("--seed", settings.seed, "Of the random numbers")->capture_default_str();
  command->add_flag(
    "--aligned", options->aligned, "All as the scene has it, none turned at random");
  command
    ->add_option(
      "--set", options->overrides, "table.key=value instead of the scene's, once a setting")
    ->allow_extra_args(false);
  command->footer("Example: vesicle fill pear.toml --count 64 --box 12 12 12 --seed 1 -o box.toml");
  command->callback([options, &action] { action = [options] { return fill_region(*options); }; });
}

}
