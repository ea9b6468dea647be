#include "apps/SceneCheck.h"

#include "apps/JsonText.h"
#include "apps/RunFolder.h"

#include "solver/Joined.h"
#include "solver/mesh/JoinedMesh.h"
#include "solver/mesh/MeshIntegrals.h"
#include "solver/scene/MeasuredText.h"
#include "solver/simulation/EquilibriumOfScene.h"
#include "solver/simulation/Simulation.h"
#include "solver/simulation/SystemOfScene.h"
#include "solver/surface/SurfaceMeasures.h"
#include "vtkfilters/Filters/SceneMesh.h"
#include "vtkfilters/Filters/VelocityFieldFile.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace vesicle
{
namespace
{

/// Of all vesicles; radius and reduced volume are the first one's.
void measure(SceneCheck& check, const Scene& scene, const std::vector<StartMesh>& start)
{
  std::vector<TriangleMesh> meshes;
  for (const StartMesh& own : start)
  {
    meshes.push_back(own.mesh);
  }
  const TriangleMesh mesh = joined(meshes);
  check.vesicles = scene.vesicles();
  check.vertices = mesh.points.rows();
  check.triangles = mesh.triangles.rows();
  check.quality = mesh_quality(mesh);
  const SurfaceMeasures measures = surface_measures(scene.accuracy.basis, mesh);
  check.area = measures.area;
  check.volume = measures.volume;
  const SurfaceMeasures first = surface_measures(scene.accuracy.basis, meshes.front());
  check.reduced_volume = reduced_volume(first.area, first.volume);
  check.radius = scales_of(scene, meshes.front()).length;
  check.viscosity_ratio = scene.fluid.viscosity_ratio;
  check.units = scene.units;
}

std::string existing_run(const std::filesystem::path& folder, const std::string& name)
{
  return RunFolder(folder, name).files().empty() ? std::string()
                                                 : folder.string() +
      ": there is a run already, which --resume goes on with and --overwrite replaces";
}

std::string gigabytes(double bytes)
{
  return fmt::format("{:.3g} GB", bytes / 1e9);
}

std::string time_text(double seconds)
{
  if (seconds < 120)
  {
    return fmt::format("{:.2g} s", seconds);
  }
  return seconds < 7200 ? fmt::format("{:.2g} min", seconds / 60)
                        : fmt::format("{:.3g} h", seconds / 3600);
}

/// Of what is counted, and known but for rounding: 2.4/0.1 is 24.
double whole(double count)
{
  return std::floor(count + 1e-6);
}

/// One line a number, those that the scene has.
std::string numbers_text(const SceneCheck& c)
{
  std::string text =
    fmt::format("  {:<17}{}\n", "r0", measured_text(c.radius, "length", c.units, 6));
  const auto add = [&text](const char* name, const std::optional<double>& value, const char* what)
  {
    if (value)
    {
      text += fmt::format("  {:<17}{:<12.6g} {}\n", name, *value, what);
    }
  };
  if (c.numbers)
  {
    text += fmt::format("  {:<17}{:<12} {}\n", "time unit",
      measured_text(c.numbers->time_unit, "time", c.units, 6), "mu r0^3/EB");
    add("Bo", c.numbers->bond, "load over bending");
    add("Ca", c.numbers->capillary, "flow over bending");
    add("duration", c.numbers->duration, "time.end in the shortest time of flow, load and bending");
  }
  add("viscosity ratio", c.viscosity_ratio, "inside over outside");
  add("reduced volume", c.reduced_volume, "6 sqrt(pi) V/A^(3/2)");
  return text;
}

std::string mesh_text(const SceneCheck& c)
{
  const MeshQuality& q = c.quality;
  const auto length = [&](double value) { return measured_text(value, "length", c.units, 4); };
  const std::string vesicles =
    c.vesicles > 1 ? fmt::format("  {:<17}{}\n", "vesicles", c.vesicles) : std::string();
  return vesicles +
    fmt::format("  {:<17}{}\n  {:<17}{}\n  {:<17}{} (mean), {} to {}\n"
                "  {:<17}{:.1f} degrees\n  {:<17}{}\n  {:<17}{}\n",
      "triangles", c.triangles, "vertices", c.vertices, "edges", length(q.mean_edge),
      length(q.min_edge), length(q.min_edge * q.edge_ratio), "smallest angle", q.min_angle_deg,
      "area", measured_text(c.area, "area", c.units, 8), "volume",
      measured_text(c.volume, "volume", c.units, 8));
}

std::string cost_text(const SceneCheck& c)
{
  std::string text = fmt::format(
    "  {:<17}{} of {}\n", "memory", gigabytes(c.cost.memory), gigabytes(c.available.memory));
  if (!c.numbers)
  {
    return text;
  }
  text += fmt::format("  {:<17}{} on one core\n", "a step", time_text(c.cost.step_seconds));
  if (c.cost.steps > 0)
  {
    text += fmt::format("  {:<17}at least {:.0f}, {} on one core\n", "steps", whole(c.cost.steps),
      time_text(c.cost.seconds));
  }
  if (c.cost.frames > 0)
  {
    text += fmt::format("  {:<17}{:.0f}, {} before compression, of {} free\n", "frames",
      whole(c.cost.frames), gigabytes(c.cost.disk), gigabytes(c.available.disk));
  }
  return text;
}

/// Each line of a text moved in.
std::string indented(const std::string& text)
{
  std::string result = "  ";
  for (const char c : text)
  {
    result += c;
    if (c == '\n')
    {
      result += "  ";
    }
  }
  return result;
}

}

SceneCheck check_scene(const Scene& scene, const std::filesystem::path& folder)
{
  SceneCheck check;
  check.folder = folder;
  check.available = resources_for(folder);
  std::string notes;
  if (scene.time.equilibrium)
  {
    require_equilibrium(scene);
    measure(check, scene, { { start_mesh_of(scene, notes), {} } });
  }
  else
  {
    require_affordable(scene, shape_triangles(scene), check.available);
    std::vector<StartMesh> start = start_meshes_of(scene);
    std::string field_notes;
    const Scene complete = with_velocity_field(scene, field_notes);
    start.front().notes = lines({ start.front().notes, field_notes });
    const Simulation simulation(complete, start);
    measure(check, scene, start);
    check.numbers = simulation.numbers();
    notes = simulation.notes();
  }
  check.cost = cost_of(scene, static_cast<double>(check.triangles));
  check.warnings = lines({ notes, existing_run(folder, scene.name) });
  return check;
}

std::string to_text(const SceneCheck& c)
{
  return fmt::format("numbers\n{}\nmesh\n{}\ncost, roughly\n{}\n{}", numbers_text(c), mesh_text(c),
    cost_text(c),
    c.warnings.empty() ? "no warnings\n" : "warnings\n" + indented(c.warnings) + '\n');
}

nlohmann::ordered_json to_json(const SceneCheck& c)
{
  using Json = nlohmann::ordered_json;
  const auto known = [&](double value) { return value > 0 ? json_number(value) : Json(nullptr); };
  const DimensionlessNumbers numbers = c.numbers.value_or(DimensionlessNumbers{});
  Json all{ { "folder", c.folder.string() },
    { "numbers",
      { { "r0", c.radius }, { "time_unit", c.numbers ? Json(numbers.time_unit) : Json(nullptr) },
        { "bond", json_number(numbers.bond) }, { "capillary", json_number(numbers.capillary) },
        { "duration", json_number(numbers.duration) }, { "viscosity_ratio", c.viscosity_ratio },
        { "reduced_volume", c.reduced_volume } } },
    { "mesh",
      { { "triangles", c.triangles }, { "vertices", c.vertices }, { "area", c.area },
        { "volume", c.volume }, { "mean_edge", c.quality.mean_edge },
        { "min_edge", c.quality.min_edge },
        { "max_edge", c.quality.min_edge * c.quality.edge_ratio },
        { "min_angle_deg", c.quality.min_angle_deg } } },
    { "cost",
      { { "memory_bytes", c.cost.memory },
        { "step_seconds", c.numbers ? Json(c.cost.step_seconds) : Json(nullptr) },
        { "least_steps", known(whole(c.cost.steps)) }, { "least_seconds", known(c.cost.seconds) },
        { "frames", known(whole(c.cost.frames)) }, { "disk_bytes", known(c.cost.disk) } } },
    { "warnings", c.warnings } };
  if (c.vesicles > 1)
  {
    all["mesh"]["vesicles"] = c.vesicles;
  }
  return all;
}

}
