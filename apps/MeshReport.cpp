#include "apps/MeshReport.h"

#include "apps/JsonText.h"

#include "solver/mesh/BodyOrientation.h"
#include "solver/mesh/Connectivity.h"
#include "solver/mesh/MeshInspection.h"
#include "solver/mesh/MeshIntegrals.h"
#include "solver/mesh/Seams.h"
#include "solver/mesh/Topology.h"
#include "solver/surface/SurfaceMeasures.h"
#include "solver/scene/SceneNames.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <numbers>
#include <utility>

namespace vesicle
{
namespace
{

long used_vertices(const TriangleMesh& mesh)
{
  const Connectivity connectivity(mesh.triangles, static_cast<int>(mesh.points.rows()));
  long used = 0;
  for (int i = 0; i < mesh.points.rows(); ++i)
  {
    used += connectivity.vertex_triangles.size(i) > 0;
  }
  return used;
}

std::string facing_text(const BodyOrientation& orientation)
{
  std::string text;
  for (std::size_t i = 0; i < orientation.bodies.size(); ++i)
  {
    if (orientation.turned[i] || orientation.inner_side[i])
      text += fmt::format("{}{} {}", text.empty() ? "" : "; ", to_text(orientation.bodies[i]),
        orientation.inner_side[i] ? "is the inner side of a shell"
                                  : "is inside out and measured as facing outward");
  }
  return text;
}

std::string text(std::optional<double> value)
{
  return value ? fmt::format("{:.8g}", *value) : "undefined (the mesh isn't closed and oriented)";
}

}

MeshReport::MeshReport(TriangleMesh mesh, SurfaceBasis wanted)
  : vertices(used_vertices(mesh)), triangles(mesh.triangles.rows()),
    topology(vesicle::topology(mesh)),
    nonmanifold(MeshInspection(mesh).nonmanifold_place(mesh.points)),
    self_crossing(find_self_crossing(mesh)), seam_gap(vesicle::seam_gap(mesh)),
    quality(mesh_quality(mesh))
{
  // One body that faces inward has a negative volume; of several, those inside out are turned.
  if (BodyOrientation orientation(mesh); orientation.bodies.size() > 1)
  {
    facing = facing_text(orientation);
    mesh.triangles = std::move(orientation.triangles);
  }
  if (!topology.closed || !topology.oriented)
  {
    area = flat_area(mesh);
    return;
  }
  if (topology.manifold && vertices == mesh.points.rows())
  {
    basis = wanted;
  }
  const SurfaceMeasures measures = surface_measures(basis, mesh);
  area = measures.area;
  volume = measures.volume;
  reduced_volume = vesicle::reduced_volume(area, std::abs(*volume));
  energy_over_8pi = measures.bending_energy / (8 * std::numbers::pi);
}

nlohmann::ordered_json to_json(const MeshReport& r)
{
  return { { "vertices", r.vertices }, { "triangles", r.triangles },
    { "closed", r.topology.closed }, { "oriented", r.topology.oriented },
    { "manifold", r.topology.manifold }, { "components", r.topology.components },
    { "genus", r.topology.genus ? nlohmann::ordered_json(*r.topology.genus) : nullptr },
    { "area", json_number(r.area) }, { "volume", json_number(r.volume) },
    { "reduced_volume", json_number(r.reduced_volume) },
    { "energy_over_8pi", json_number(r.energy_over_8pi) },
    { "min_angle_deg", json_number(r.quality.min_angle_deg) },
    { "edge_ratio", json_number(r.quality.edge_ratio) }, { "basis", name_of(basis_names, r.basis) },
    { "self_crossing",
      r.self_crossing
        ? nlohmann::ordered_json::array({ r.self_crossing->first, r.self_crossing->second })
        : nlohmann::ordered_json() } };
}

std::string surface_name(const MeshReport& r)
{
  return r.basis == SurfaceBasis::loop ? "Loop" : "flat";
}

std::string to_text(const MeshReport& r)
{
  const bool inward = r.volume && *r.volume < 0;
  const std::string closed = r.topology.closed ? "yes"
    : !r.seam_gap
    ? "no"
    : fmt::format("no; corners of neighbouring triangles differ by up to {:.2g}: --merge {:.2g}",
        *r.seam_gap, merge_distance(*r.seam_gap));
  const std::string oriented = !r.topology.oriented ? "no"
    : inward                                        ? "yes, inward"
    : r.facing.empty()                              ? "yes"
                                                    : "yes; " + r.facing;
  return fmt::format("  vertices         {}\n"
                     "  triangles        {}\n"
                     "  closed           {}\n"
                     "  oriented         {}\n"
                     "  manifold         {}\n"
                     "  crosses itself   {}\n"
                     "  components       {}\n"
                     "  genus            {}\n"
                     "  surface          {}\n"
                     "  area             {:.8g}\n"
                     "  volume           {}\n"
                     "  reduced volume   {}\n"
                     "  energy / 8 pi EB {}\n"
                     "  smallest angle   {:.2f} degrees\n"
                     "  edge ratio       {:.3f}\n",
    r.vertices, r.triangles, closed, oriented,
    r.nonmanifold.empty() ? "yes" : "no (" + r.nonmanifold + ")",
    r.self_crossing ? "yes (" + to_text(*r.self_crossing) + ")" : "no", r.topology.components,
    r.topology.genus ? std::to_string(*r.topology.genus)
                     : "undefined (the mesh isn't closed, oriented and manifold)",
    surface_name(r), r.area, text(r.volume), text(r.reduced_volume), text(r.energy_over_8pi),
    r.quality.min_angle_deg, r.quality.edge_ratio);
}

}
