#include "solver/mesh/repair/Repair.h"

#include "solver/Errors.h"
#include "solver/mesh/BodyOrientation.h"
#include "solver/mesh/MeshInspection.h"
#include "solver/mesh/MeshIntegrals.h"
#include "solver/mesh/Preparation.h"
#include "solver/mesh/Seams.h"
#include "solver/mesh/Topology.h"
#include "solver/mesh/remesh/Remesh.h"
#include "solver/mesh/repair/Cleaning.h"
#include "solver/mesh/repair/Components.h"
#include "solver/mesh/repair/Holes.h"
#include "solver/mesh/repair/Sheets.h"
#include "solver/mesh/repair/Smoothing.h"

#include <fmt/format.h>

#include <algorithm>

namespace vesicle
{
namespace
{

/// Points nearer than this part of the mesh's diagonal are one, as prepare_for_dynamics() has it.
constexpr double duplicate_distance = 1e-9;

void turn(TriangleMesh& mesh, int triangle)
{
  std::swap(mesh.triangles(triangle, 1), mesh.triangles(triangle, 2));
}

MeshFigures figures_of(const TriangleMesh& mesh)
{
  const Topology is = topology(mesh);
  MeshFigures figures{ mesh.points.rows(), mesh.triangles.rows(), is.components, flat_area(mesh),
    {} };
  if (is.closed && is.oriented)
    figures.volume = flat_volume(mesh);
  return figures;
}

class Repairing
{
public:
  Repairing(TriangleMesh mesh, const RepairSettings& settings, const std::string& name)
    : mesh_(std::move(mesh)), settings_(settings), name_(name)
  {
    check_indices(mesh_, name_);
    report_.before = figures_of(mesh_);
  }

  Repaired result()
  {
    clean();
    report_.parted_points = part_sheets(mesh_);
    drop_scraps();
    const std::vector<bool> turned = turn_to_agree();
    report_.filled_holes = fill_holes(mesh_, settings_.largest_hole);
    report_.open_holes = MeshInspection(mesh_).holes();
    turn_outward(turned);
    report_.unused_points = drop_unused_points(mesh_);
    smooth_noise(mesh_, report_.smoothing_passes = settings_.smoothing_passes);
    if (settings_.triangles)
      resample(*settings_.triangles);
    report_.after = figures_of(mesh_);
    return { std::move(mesh_), std::move(report_) };
  }

private:
  double merging_distance() const;
  void clean();
  void drop_scraps();
  std::vector<bool> turn_to_agree();
  void turn_outward(const std::vector<bool>& turned_before);
  void resample(int triangles);
  TriangleMesh resampled(TriangleMesh body, int triangles);
  std::string place_of_edge(const EdgeUse& use) const;

  TriangleMesh mesh_;
  const RepairSettings& settings_;
  const std::string& name_;
  RepairReport report_;
};

double Repairing::merging_distance() const
{
  if (settings_.merge)
    return *settings_.merge;
  const double seam = merge_distance(seam_gap(mesh_).value_or(0));
  return std::max(seam, duplicate_distance * box_diagonal(mesh_.points));
}

void Repairing::clean()
{
  report_.merge_distance = merging_distance();
  if (!(report_.merge_distance > 0))
    throw InputError(name_ + ": all points coincide");
  report_.merged_points = merge_points(mesh_, report_.merge_distance);
  const DroppedTriangles dropped = drop_idle_triangles(mesh_);
  report_.triangles_without_area = dropped.without_area;
  report_.doubled_triangles = dropped.doubled;
  if (mesh_.triangles.rows() == 0)
    throw InputError(fmt::format("{}: no triangle is left once points nearer than {:.3g} are one; "
                                 "choose a smaller distance (--merge)",
      name_, report_.merge_distance));
}

void Repairing::drop_scraps()
{
  const std::vector<Component> components = components_of(mesh_);
  const auto by_area = [](const Component& l, const Component& r) { return l.area < r.area; };
  const auto largest = std::ranges::max_element(components, by_area);
  const double area = flat_area(mesh_);
  std::vector<bool> kept(mesh_.triangles.rows(), true);
  for (const Component& component : components)
  {
    const bool is_largest = &component == &*largest;
    const bool scrap = settings_.largest_only ||
      component.area < settings_.scrap_share * largest->area ||
      static_cast<int>(component.triangles.size()) < settings_.scrap_triangles;
    if (is_largest || !scrap)
      continue;
    ++report_.scraps;
    report_.scrap_triangles += static_cast<int>(component.triangles.size());
    report_.scrap_area += component.area / area;
    for (const int t : component.triangles)
      kept[t] = false;
  }
  keep_triangles(mesh_, kept);
}

std::string Repairing::place_of_edge(const EdgeUse& use) const
{
  return near_text((mesh_.points.row(use.a) + mesh_.points.row(use.b)).transpose() / 2);
}

/// As most of their component face; returns which were turned.
std::vector<bool> Repairing::turn_to_agree()
{
  const MeshInspection inspection(mesh_);
  MeshInspection::Reorientation change = inspection.reorientation();
  if (change.contradicting_edge >= 0)
    throw InputError(
      fmt::format("{}: the surface has one side only, seen {}: a vesicle has an inside "
                  "and an outside; cut it there, or segment it anew",
        name_, place_of_edge(inspection.edges()[change.contradicting_edge].front())));
  for (const Component& component : components_of(mesh_))
  {
    const auto turned =
      std::ranges::count_if(component.triangles, [&](int t) { return change.flipped[t]; });
    const bool most = 2 * turned > static_cast<std::ptrdiff_t>(component.triangles.size());
    for (const int t : component.triangles)
    {
      change.flipped[t] = change.flipped[t] != most;
      if (change.flipped[t])
        turn(mesh_, t);
    }
  }
  return change.flipped;
}

void Repairing::turn_outward(const std::vector<bool>& turned_before)
{
  const Triangles before = mesh_.triangles;
  mesh_.triangles = BodyOrientation(mesh_).triangles;
  for (std::size_t t = 0; t < turned_before.size(); ++t)
  {
    const bool turned_now =
      before(static_cast<int>(t), 1) != mesh_.triangles(static_cast<int>(t), 1);
    report_.turned_triangles += turned_now != turned_before[t];
  }
}

TriangleMesh Repairing::resampled(TriangleMesh body, int triangles)
{
  prepare_for_dynamics(body, name_);
  Remeshed result = remesh(body, triangles);
  const RemeshReport& r = result.report;
  report_.resampled.push_back(
    fmt::format("{} to {} triangles; largest distance {:.1e} r0, smallest angle {:.0f} degrees",
      body.triangles.rows(), r.triangles, r.max_distance, r.quality.min_angle_deg));
  return std::move(result.mesh);
}

/// Each body by itself; one that faces inward, as the inner side of a shell does, faces inward
/// again.
void Repairing::resample(int triangles)
{
  TriangleMesh all;
  for (const Component& component : components_of(mesh_))
  {
    const TriangleMesh body = part_of(mesh_, component.triangles);
    const bool inward = flat_volume(body) < 0;
    TriangleMesh fresh = resampled(body, triangles);
    for (int t = 0; inward && t < fresh.triangles.rows(); ++t)
      turn(fresh, t);
    const auto points = all.points.rows(), first = all.triangles.rows();
    all.points.conservativeResize(points + fresh.points.rows(), 3);
    all.points.bottomRows(fresh.points.rows()) = fresh.points;
    all.triangles.conservativeResize(first + fresh.triangles.rows(), 3);
    all.triangles.bottomRows(fresh.triangles.rows()) =
      fresh.triangles.array() + static_cast<int>(points);
  }
  mesh_ = std::move(all);
}

std::string figures_text(const char* when, const MeshFigures& f)
{
  return fmt::format("  {:<8}{:>9} points, {:>9} triangles, {:>4} component{}, area {:.8g}, {}\n",
    when, f.points, f.triangles, f.components, f.components == 1 ? "" : "s", f.area,
    f.volume ? fmt::format("volume {:.8g}", *f.volume) : std::string("not closed and oriented"));
}

std::string counted(int count, const char* one, const char* several)
{
  return fmt::format("{} {}", count, count == 1 ? one : several);
}

}

bool RepairReport::changed_anything() const
{
  return merged_points > 0 || unused_points > 0 || triangles_without_area > 0 ||
    doubled_triangles > 0 || parted_points > 0 || scraps > 0 || turned_triangles > 0 ||
    filled_holes > 0 || smoothing_passes > 0 || !resampled.empty();
}

Repaired repair(TriangleMesh mesh, const RepairSettings& settings, const std::string& name)
{
  return Repairing(std::move(mesh), settings, name).result();
}

std::string to_text(const RepairReport& r)
{
  std::string text;
  const auto add = [&text](bool done, const std::string& line)
  { text += done ? "  " + line + '\n' : ""; };
  add(r.merged_points > 0,
    fmt::format("{} merged with another nearer than {:.3g}",
      counted(r.merged_points, "point", "points"), r.merge_distance));
  add(r.triangles_without_area > 0,
    counted(r.triangles_without_area, "triangle", "triangles") + " without area dropped");
  add(r.doubled_triangles > 0,
    counted(r.doubled_triangles, "triangle", "triangles") + " that were there twice dropped");
  add(r.parted_points > 0,
    counted(r.parted_points, "point", "points") + " where sheets touched parted");
  add(r.scraps > 0,
    fmt::format("{} dropped: {}, {:.2g}% of the area", counted(r.scraps, "scrap", "scraps"),
      counted(r.scrap_triangles, "triangle", "triangles"), 100 * r.scrap_area));
  add(
    r.turned_triangles > 0, counted(r.turned_triangles, "triangle", "triangles") + " turned over");
  add(r.filled_holes > 0, counted(r.filled_holes, "hole", "holes") + " filled");
  add(r.unused_points > 0,
    counted(r.unused_points, "point", "points") + " that no triangle uses dropped");
  add(r.smoothing_passes > 0,
    fmt::format("smoothed in {}", counted(r.smoothing_passes, "pass", "passes")));
  for (const std::string& body : r.resampled)
    add(true, "resampled from " + body);
  add(!r.changed_anything(), "nothing to repair");
  add(r.open_holes > 0,
    counted(r.open_holes, "hole is", "holes are") + " left open: a larger --holes fills more");
  return text + figures_text("before", r.before) + figures_text("after", r.after);
}

}
