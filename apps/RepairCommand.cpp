// vesicle repair: a segmentation becomes a mesh to start from.

#include "apps/Commands.h"
#include "apps/JsonText.h"
#include "apps/StandardOutput.h"
#include "apps/Warning.h"

#include "solver/mesh/repair/Repair.h"
#include "vtkfilters/Filters/MeshConversion.h"
#include "vtkfilters/Filters/MeshFiles.h"

#include "vtkPointData.h"
#include "vtkCellData.h"
#include "vtkPolyData.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>

namespace vesicle
{
namespace
{

struct RepairOptions
{
  std::string mesh, output;
  double merge = 0;
  int triangles = 0;
  bool json = false;
  RepairSettings settings;
};

nlohmann::ordered_json figures_json(const MeshFigures& f)
{
  using Json = nlohmann::ordered_json;
  return { { "points", f.points }, { "triangles", f.triangles }, { "components", f.components },
    { "area", f.area }, { "volume", f.volume ? Json(*f.volume) : Json(nullptr) } };
}

nlohmann::ordered_json report_json(const RepairReport& r)
{
  return { { "changed", r.changed_anything() }, { "before", figures_json(r.before) },
    { "after", figures_json(r.after) }, { "merge_distance", r.merge_distance },
    { "merged_points", r.merged_points }, { "unused_points", r.unused_points },
    { "triangles_without_area", r.triangles_without_area },
    { "doubled_triangles", r.doubled_triangles }, { "parted_points", r.parted_points },
    { "scraps", r.scraps }, { "scrap_triangles", r.scrap_triangles },
    { "scrap_area", r.scrap_area }, { "turned_triangles", r.turned_triangles },
    { "filled_holes", r.filled_holes }, { "open_holes", r.open_holes },
    { "smoothing_passes", r.smoothing_passes }, { "resampled", r.resampled } };
}

/// A surface that is as it was keeps its arrays.
void write(vtkPolyData* surface, const Repaired& repaired, const std::string& file)
{
  if (!repaired.report.changed_anything())
  {
    warn(write_mesh(surface, file));
    return;
  }
  if (surface->GetPointData()->GetNumberOfArrays() + surface->GetCellData()->GetNumberOfArrays() >
    0)
  {
    warn(file + ": the arrays of the mesh belong to its old points and triangles and are left out");
  }
  warn(write_mesh(to_polydata(repaired.mesh), file));
}

int repair_mesh(const RepairOptions& options)
{
  require_mesh_ending(options.output);
  RepairSettings settings = options.settings;
  if (options.merge > 0)
  {
    settings.merge = options.merge;
  }
  if (options.triangles > 0)
  {
    settings.triangles = options.triangles;
  }
  const auto surface = without_ghosts(read_mesh(options.mesh));
  const Repaired repaired = repair(to_mesh(surface), settings, options.mesh);
  write(surface, repaired, options.output);
  if (options.json)
  {
    print("{}\n", json_text(report_json(repaired.report), 2));
    return exit_code::done;
  }
  print("{}\n{}", options.output, to_text(repaired.report));
  return exit_code::done;
}

}

void add_repair_command(CLI::App& app, Action& action)
{
  auto options = std::make_shared<RepairOptions>();
  RepairSettings& settings = options->settings;
  auto* command = app.add_subcommand(
    "repair", "Make a segmentation or a scan a clean, closed mesh, and say what was done");
  command->add_option("mesh", options->mesh, fmt::format("Mesh ({})", mesh_endings))->required();
  command->add_option("-o,--output", options->output, "File to write")->required();
  command
    ->add_option("--merge", options->merge,
      "Points nearer than this distance become one; if left out what closes a seam")
    ->check(CLI::PositiveNumber);
  command
    ->add_option("--scraps", settings.scrap_share,
      "Connected parts with less than this share of the largest one's area are dropped")
    ->check(CLI::Range(0., 1.))
    ->capture_default_str();
  command
    ->add_option(
      "--scrap-triangles", settings.scrap_triangles, "Those with fewer triangles are dropped, too")
    ->check(CLI::NonNegativeNumber)
    ->capture_default_str();
  command->add_flag("--largest", settings.largest_only, "Drop all parts but the largest");
  command
    ->add_option("--holes", settings.largest_hole,
      "Holes up to this size are filled: length of the border over the circumference of the sphere "
      "with the surface's area")
    ->check(CLI::NonNegativeNumber)
    ->capture_default_str();
  command
    ->add_option("--smooth", settings.smoothing_passes,
      "Passes of a smoothing that doesn't shrink; about 20 take the voxels' staircases out")
    ->check(CLI::Range(0, 10000))
    ->capture_default_str();
  command
    ->add_option(
      "--triangles", options->triangles, "New points, evenly spaced, and so many triangles a body")
    ->check(CLI::PositiveNumber);
  command->add_flag("--json", options->json, "Print the report as JSON");
  command->footer("Example: vesicle repair mask.vtp --smooth 20 --triangles 1280 -o start.vtu");
  command->callback([options, &action] { action = [options] { return repair_mesh(*options); }; });
}

}
