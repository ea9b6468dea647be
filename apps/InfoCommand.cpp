// vesicle info: what a mesh is.

#include "apps/Commands.h"
#include "apps/JsonText.h"
#include "apps/MeshReport.h"
#include "apps/RunReport.h"
#include "apps/StandardOutput.h"

#include "solver/files/FileBytes.h"
#include "vtkfilters/Filters/MeshConversion.h"
#include "vtkfilters/Filters/MeshFiles.h"
#include "vtkfilters/Filters/SceneNumbers.h"
#include "vtkfilters/Filters/SeriesFile.h"

#include "vtkFieldData.h"
#include "vtkPolyData.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>

namespace vesicle
{
namespace
{

struct InfoOptions
{
  std::string file;
  double merge = 0;
  bool json = false;
};

MeshReport report_of(const std::filesystem::path& file, double merge)
{
  auto surface = without_ghosts(read_mesh(file));
  if (merge > 0)
  {
    surface = merged(surface, merge);
  }
  return MeshReport(to_mesh(surface), surface_basis(surface->GetFieldData()));
}

void print_mesh(const InfoOptions& options)
{
  const MeshReport report = report_of(options.file, options.merge);
  if (options.json)
  {
    print("{}\n", json_text(to_json(report), 2));
    return;
  }
  print("{}\n{}", options.file, to_text(report));
}

/// A frame a line; as JSON an array of the meshes' objects with time and file.
void print_series(const InfoOptions& options)
{
  auto all = nlohmann::ordered_json::array();
  if (!options.json)
  {
    print("{:>12} {:>10} {:>14} {:>14} {:>14} {:>12} {:>10} {:>10} {:>8}\n", "time", "triangles",
      "area", "volume", "reduced volume", "E/8piEB", "min angle", "edge ratio", "surface");
  }
  for (const auto& frame : read_series(options.file))
  {
    const MeshReport r = report_of(frame.file, options.merge);
    if (options.json)
    {
      nlohmann::ordered_json entry{ { "time", frame.time }, { "file", frame.file.string() } };
      entry.update(to_json(r));
      all.push_back(entry);
      continue;
    }
    const auto cell = [](std::optional<double> value)
    { return value ? fmt::format("{:.8g}", *value) : std::string("-"); };
    print("{:>12.6g} {:>10} {:>14.8g} {:>14} {:>14} {:>12} {:>10.2f} {:>10.3f} {:>8}\n", frame.time,
      r.triangles, r.area, cell(r.volume), cell(r.reduced_volume), cell(r.energy_over_8pi),
      r.quality.min_angle_deg, r.quality.edge_ratio, surface_name(r));
  }
  if (options.json)
  {
    print("{}\n", json_text(all, 2));
  }
}

void print_run(const InfoOptions& options)
{
  const RunReport report = report_of_run(options.file);
  options.json ? print("{}\n", json_text(to_json(report), 2)) : print("{}", to_text(report));
}

}

void add_info_command(CLI::App& app, Action& action)
{
  auto options = std::make_shared<InfoOptions>();
  auto* command = app.add_subcommand(
    "info", "Area, volume, reduced volume, energy and quality of a mesh; how far a run has come");
  command
    ->add_option("mesh", options->file,
      fmt::format("Mesh ({}), series (.pvd .vtu.series) or folder of a run", mesh_endings))
    ->required();
  command->add_option("--merge", options->merge, "Points nearer than this distance count as one")
    ->check(CLI::PositiveNumber);
  command->add_flag("--json", options->json, "Print JSON");
  command->footer("Example: vesicle info cell.stl --json\n"
                  "         vesicle info pear");
  command->callback(
    [options, &action]
    {
      action = [options]
      {
        if (is_folder(options->file))
        {
          print_run(*options);
        }
        else
        {
          is_series(options->file) ? print_series(*options) : print_mesh(*options);
        }
        return exit_code::done;
      };
    });
}

}
