// vesicle shape: a start shape as a mesh file.

#include "apps/Commands.h"
#include "apps/MeshReport.h"
#include "apps/Warning.h"
#include "apps/StandardOutput.h"

#include "solver/surface/StartShape.h"
#include "vtkfilters/Filters/MeshConversion.h"
#include "vtkfilters/Filters/MeshFiles.h"
#include "vtkfilters/Filters/SceneNumbers.h"

#include "vtkFieldData.h"
#include "vtkPolyData.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>

namespace vesicle
{
namespace
{

struct ShapeOptions
{
  std::string kind;
  ShapeRequest request;
  double reduced_volume = 0;
  std::string basis = "loop";
  std::vector<double> modes; ///< l, m, amplitude one after the other
  std::string file;
};

int make(ShapeOptions options, bool with_reduced_volume)
{
  options.request.kind = shape_kind(options.kind);
  if (with_reduced_volume)
  {
    options.request.reduced_volume = options.reduced_volume;
  }
  for (std::size_t i = 0; i + 2 < options.modes.size(); i += 3)
  {
    options.request.modes.push_back({ static_cast<int>(options.modes[i]),
      static_cast<int>(options.modes[i + 1]), options.modes[i + 2] });
  }
  const std::string file = options.file.empty() ? options.kind + ".vtu" : options.file;
  require_mesh_ending(file);
  const auto basis = options.basis == "linear" ? SurfaceBasis::linear : SurfaceBasis::loop;
  const TriangleMesh mesh = make_start_shape(options.request, basis);
  warn(start_shape_warning(options.request, basis, mesh));
  const MeshReport report(mesh, basis);
  const auto surface = to_polydata(mesh);
  if (keeps_field_data(file)) // else nothing that was asked for is lost
  {
    add_surface(basis, *report.reduced_volume, surface->GetFieldData());
  }
  warn(write_mesh(surface, file));
  print("{}\n{}", file, to_text(report));
  return exit_code::done;
}

}

void add_shape_command(CLI::App& app, Action& action)
{
  auto options = std::make_shared<ShapeOptions>();
  auto* command = app.add_subcommand(
    "shape", "Write a start shape of radius 1 (that of the sphere of its volume)");
  command
    ->add_option(
      "kind", options->kind, "sphere prolate oblate ellipsoid discocyte perturbed stomatocyte")
    ->required();
  auto* reduced = command->add_option("--reduced-volume", options->reduced_volume,
    "6 sqrt(pi) V / A^(3/2) of the surface, 1 for a sphere");
  command
    ->add_option("--basis", options->basis,
      "The surface that the mesh stands for: loop, the smooth one through its points, or linear, "
      "its "
      "flat triangles (as the presets fast and paper have it)")
    ->check(CLI::IsMember({ "linear", "loop" }))
    ->capture_default_str();
  command
    ->add_option("--triangles", options->request.triangles,
      "Met exactly if a multiple of 10 or 12 (above 2,000 of 40 or 48), else the nearest")
    ->capture_default_str();
  command->add_option(
    "--semi-axes", options->request.semi_axes, "a b c of an ellipsoid; their ratios matter");
  command->add_option("--mode", options->modes, "l m amplitude of a perturbed sphere, once a mode")
    ->type_size(3)
    ->allow_extra_args(false);
  command->add_option("-o,--output", options->file, "File to write; KIND.vtu if left out");
  command->footer(
    "Example: vesicle shape prolate --reduced-volume 0.95 --triangles 1280 -o pear.stl");
  command->callback([options, reduced, &action]
    { action = [options, reduced] { return make(*options, reduced->count() > 0); }; });
}

}
