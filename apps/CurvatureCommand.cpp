// vesicle curvature: the curvature filter on a mesh file.

#include "apps/Commands.h"
#include "apps/CurvatureSummary.h"
#include "apps/StandardOutput.h"
#include "apps/Warning.h"

#include "solver/Errors.h"
#include "vtkfilters/Filters/MeshConversion.h"
#include "vtkfilters/Filters/MeshFiles.h"
#include "vtkfilters/Filters/VtkMessages.h"

#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVesicleCurvatureFilter.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>

namespace vesicle
{
namespace
{

struct CurvatureOptions
{
  std::string mesh;
  std::string output;
  std::string scheme = "fit";
  double rigidity = 1;
  double radius = 0;
  double rings = 0;
  bool all = false;
  bool no_force = false;
  double merge = 0;
  std::string undefined = "zero";
  bool summary = false;
  std::string summary_file;
  int bins = 20;
};

vtkIdType undefined_vertices(vtkPolyData* surface)
{
  auto* valid =
    vtkUnsignedCharArray::SafeDownCast(surface->GetPointData()->GetArray("Curvature_Valid"));
  vtkIdType undefined = 0;
  for (vtkIdType i = 0; i < valid->GetNumberOfValues(); ++i)
  {
    undefined += valid->GetValue(i) == 0;
  }
  return undefined;
}

void warn_of(const std::string& mesh, const std::string& text)
{
  warn(text.empty() ? "" : mesh + ": " + text);
}

void summarize(const CurvatureOptions& options, vtkPolyData* surface)
{
  const CurvatureSummary summary = curvature_summary(surface, options.bins);
  if (options.summary)
  {
    print("{}", to_text(summary));
  }
  if (!options.summary_file.empty())
  {
    write_summary(summary, options.summary_file);
  }
}

/// Before anything is computed.
void require_something_to_do(const CurvatureOptions& options)
{
  if (!options.output.empty())
  {
    require_mesh_ending(options.output);
  }
  if (!options.summary_file.empty())
  {
    require_summary_ending(options.summary_file);
  }
  if (options.output.empty() && options.summary_file.empty() && !options.summary)
  {
    throw InputError("curvature: nothing to do: give a file by -o, --summary or --summary-file");
  }
}

int write_curvature(const CurvatureOptions& options)
{
  require_something_to_do(options);
  auto surface = read_mesh(options.mesh);
  if (options.merge > 0)
  {
    surface = merged(surface, options.merge);
  }
  vtkNew<vtkVesicleCurvatureFilter> filter;
  filter->SetInputData(surface);
  filter->SetSchemeByName(options.scheme.c_str());
  filter->SetCurvatureTypeToMean();
  filter->SetBendingRigidity(options.rigidity);
  filter->SetFitRadius(options.radius);
  filter->SetFitRings(options.rings);
  filter->SetPrincipalCurvatures(options.all);
  filter->SetShapeDescriptors(options.all);
  filter->SetBendingForce(!options.no_force && !options.output.empty());
  filter->SetUndefinedIsNaN(options.undefined == "nan");
  {
    const VtkMessages messages;
    filter->Update();
    if (messages.any_error())
    {
      throw InputError(options.mesh + ": " + messages.first_error());
    }
    for (const std::string& warning : messages.warnings())
    {
      warn_of(options.mesh, warning);
    }
  }
  if (!options.output.empty())
  {
    warn(write_mesh(filter->GetOutput(), options.output));
  }
  summarize(options, filter->GetOutput());
  const vtkIdType undefined = undefined_vertices(filter->GetOutput());
  if (undefined > 0)
  {
    warn_of(options.mesh,
      fmt::format("curvature is undefined at {} of {} vertices (open border, torn or "
                  "unused); see Curvature_Valid",
        undefined, surface->GetNumberOfPoints()));
  }
  return exit_code::done;
}

}

void add_curvature_command(CLI::App& app, Action& action)
{
  auto options = std::make_shared<CurvatureOptions>();
  auto* command =
    app.add_subcommand("curvature", "Curvatures and bending force of any triangle mesh");
  command->add_option("mesh", options->mesh, fmt::format("Mesh ({})", mesh_endings))->required();
  command->add_option(
    "-o,--output", options->output, "File to write; .vtu, .vtp, .vtk and .ply hold arrays");
  command->add_option("--scheme", options->scheme, "How curvatures are found")
    ->check(CLI::IsMember({ "fit", "cotan", "loop" }))
    ->capture_default_str();
  auto* radius = command->add_option("--radius", options->radius,
    "Length scale of the fit, for noisy meshes: above their noise, below the radii of curvature");
  radius->check(CLI::PositiveNumber);
  command->add_option("--rings", options->rings, "The same in mean lengths of the mesh's edges")
    ->check(CLI::PositiveNumber)
    ->excludes(radius);
  command->add_flag("--all", options->all,
    "Principal curvatures and directions, curvedness, shape index and H² as well");
  command->add_flag(
    "--no-force", options->no_force, "Without Δ_s H and the force, half of the work with a radius");
  command->add_option("--bending-rigidity", options->rigidity, "EB, multiplies the force")
    ->check(CLI::NonNegativeNumber)
    ->capture_default_str();
  command->add_option("--merge", options->merge, "Points nearer than this distance become one")
    ->check(CLI::PositiveNumber);
  command
    ->add_option("--undefined", options->undefined,
      "What arrays hold where nothing is defined, at open borders say; Curvature_Valid tells where")
    ->check(CLI::IsMember({ "zero", "nan" }))
    ->capture_default_str();
  command->add_flag("--summary", options->summary,
    "Print mean, deviation, percentiles and a histogram of H and K (with --all of all), by area");
  command->add_option(
    "--summary-file", options->summary_file, "The same numbers as a file, .json or .csv");
  command->add_option("--bins", options->bins, "Of the histograms")
    ->check(CLI::Range(2, 1000))
    ->capture_default_str();
  command->footer("Example: vesicle curvature cell.ply -o cell.vtu\n"
                  "         vesicle curvature cell.ply --summary\n"
                  "         vesicle curvature segmented.vtp --radius 12 --all -o segmented.vtu");
  command->callback(
    [options, &action] { action = [options] { return write_curvature(*options); }; });
}

}
