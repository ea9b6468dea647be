#include "apps/SceneEquilibriumFile.h"

#include "apps/Commands.h"
#include "apps/RunFolder.h"
#include "apps/StandardOutput.h"
#include "apps/Warning.h"

#include "solver/Errors.h"
#include "solver/files/FileBytes.h"
#include "solver/mesh/SelfCrossing.h"
#include "solver/simulation/EquilibriumOfScene.h"
#include "vtkfilters/Filters/MeshConversion.h"
#include "vtkfilters/Filters/MeshFiles.h"
#include "vtkfilters/Filters/SceneMesh.h"
#include "vtkfilters/Filters/SceneNumbers.h"

#include "vtkFieldData.h"
#include "vtkPolyData.h"

#include <fmt/format.h>

namespace vesicle
{

void write_equilibrium(
  const EquilibriumReport& report, const TriangleMesh& mesh, const std::filesystem::path& file)
{
  const auto surface = to_polydata(mesh);
  if (keeps_field_data(file))
  {
    add_surface(SurfaceBasis::loop, report.reduced_volume, surface->GetFieldData());
  }
  warn(write_mesh(surface, file));
  if (const auto crossing = find_self_crossing(mesh))
  {
    warn(fmt::format("the membrane passes through itself, {}: its energy doesn't know of contact",
      to_text(*crossing)));
  }
}

EquilibriumReport equilibrium_of_scene(const Scene& scene, bool follow, TriangleMesh& mesh)
{
  std::string notes;
  SceneEquilibrium found = equilibrium_of(scene, start_mesh_of(scene, notes), follow);
  warn(notes);
  warn(found.notes);
  mesh = std::move(found.mesh);
  return report_of(found.equilibrium, mesh);
}

int run_to_equilibrium(
  const Scene& scene, const std::filesystem::path& folder, bool overwrite, bool quiet)
{
  require_equilibrium(scene);
  const RunFolder run(folder, scene.name);
  if (!run.files().empty() && !overwrite)
  {
    throw InputError(fmt::format(
      "{}: there is a run already; replace it by --overwrite, or choose another folder by -o",
      folder.string()));
  }
  TriangleMesh mesh;
  const EquilibriumReport report = equilibrium_of_scene(scene, false, mesh);
  make_folder(folder);
  const auto file = folder / (scene.name + ".vtu");
  write_equilibrium(report, mesh, file);
  replace_file(run.summary(), to_json_text(report));
  if (!quiet)
  {
    print("{}\n{}", file.string(), to_text(report));
  }
  return exit_code::done;
}

}
