#include "apps/StopBundle.h"

#include "apps/GuiltyTriangles.h"

#include "solver/files/FileBytes.h"
#include "solver/scene/SceneFile.h"
#include "solver/surface/LoopEnergy.h"
#include "vtkfilters/Filters/MeshConversion.h"
#include "vtkfilters/Filters/MeshFiles.h"

#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <fmt/format.h>

namespace vesicle
{
namespace
{

constexpr std::size_t rows_kept = 20;
/// Beyond this a mesh is about to lose its shape (Simulation warns of it, too).
constexpr double well_known = 0.01;

vtkSmartPointer<vtkPolyData> marked(const TriangleMesh& mesh, const std::vector<int>& guilty)
{
  auto surface = to_polydata(mesh);
  vtkNew<vtkUnsignedCharArray> marks;
  marks->SetName("Guilty");
  marks->SetNumberOfTuples(mesh.triangles.rows());
  marks->Fill(0);
  for (const int t : guilty)
    marks->SetValue(t, 1);
  surface->GetCellData()->AddArray(marks);
  return surface;
}

/// The shape has outgrown its mesh.
bool unresolved(const Scene& scene, const TriangleMesh& mesh)
{
  return scene.membrane.bending_rigidity && scene.accuracy.basis == Scene::Basis::loop &&
    loop_energy(mesh).disagreement() > well_known;
}

std::string text_of(
  const StopBundle& bundle, const GuiltyTriangles& guilty, const std::string& advice)
{
  const Vector3& p = guilty.place;
  return fmt::format("{}\n\nReason: {}\nTime of the last good state: {:.6g}\nPlace: {}\n", advice,
    bundle.message, bundle.time,
    guilty.triangles.empty()
      ? "unknown"
      : fmt::format("({:.4g}, {:.4g}, {:.4g}): {}", p.x(), p.y(), p.z(), guilty.why));
}

}

std::string advice(const Scene& scene, const StopBundle& bundle)
{
  const auto triangles = bundle.good.triangles.rows();
  const bool adaptive = scene.accuracy.mesh_motion == Scene::MeshMotion::adaptive;
  if (scene.accuracy.scheme == Scene::Scheme::paper)
    return "Take another preset: the paper's scheme is there to compare with, and is the first to "
           "fail.";
  if (unresolved(scene, bundle.good))
    return adaptive
      ? fmt::format("Raise accuracy.most_triangles: {} don't hold the shape any more.", triangles)
      : fmt::format(
          "Take accuracy.mesh_motion = \"adaptive\" or {} triangles: {} don't hold the shape "
          "any more.",
          4 * triangles, triangles);
  if (scene.time.step)
    return fmt::format(
      "Take time.step = \"auto\", or {:g}: the step is fixed and too long for what "
      "happens here.",
      *scene.time.step / 4);
  if (scene.accuracy.basis == Scene::Basis::linear)
    return fmt::format(
      "Take the preset \"balanced\": flat triangles make forces rougher than the step "
      "control bears.");
  return fmt::format(
    "Take {} triangles and look at failing.vtu; if it stops at the same time, the flow, "
    "load or deflation is what this shape can't bear.",
    4 * triangles);
}

std::string write_stop_bundle(
  const Scene& scene, const StopBundle& bundle, const std::filesystem::path& folder)
{
  make_folder(folder);
  write_mesh(to_polydata(bundle.good), folder / "good.vtu");
  GuiltyTriangles guilty;
  if (bundle.failing)
  {
    guilty = guilty_triangles(*bundle.failing, bundle.good);
    if (bundle.failing->points.allFinite()) // files hold nothing else
      write_mesh(marked(*bundle.failing, guilty.triangles), folder / "failing.vtu");
  }
  const auto rows = bundle.rows.size(), kept = std::min(rows, rows_kept * bundle.vesicles);
  CsvFile(folder / "diagnostics.csv", bundle.columns,
    { bundle.rows.begin() + static_cast<std::ptrdiff_t>(rows - kept), bundle.rows.end() })
    .close();
  replace_file(folder / "scene.toml", write_scene(scene));
  const std::string what_to_try = advice(scene, bundle);
  replace_file(folder / "advice.txt", text_of(bundle, guilty, what_to_try));
  return what_to_try;
}

}
