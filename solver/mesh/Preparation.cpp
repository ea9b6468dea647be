#include "solver/mesh/Preparation.h"

#include "solver/Errors.h"
#include "solver/Joined.h"
#include "solver/mesh/MeshInspection.h"
#include "solver/mesh/MeshIntegrals.h"
#include "solver/mesh/PointHash.h"
#include "solver/mesh/PolygonMesh.h"
#include "solver/mesh/Seams.h"
#include "solver/mesh/SelfCrossing.h"
#include "solver/mesh/Topology.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vesicle
{

namespace
{
/// Twice a triangle's area below this part of its longest edge squared: a line, up to rounding.
constexpr double degenerate_area = 1e-10;
/// Points nearer than this part of the mesh's diagonal are one point, written twice.
constexpr double duplicate_distance = 1e-9;
/// |V| below this part of A^{3/2} is no volume but rounding: the surface is folded flat.
constexpr double no_volume = 1e-10;

/// The checks of one mesh, each of which throws at the first fault it finds.
class Preparation
{
public:
  Preparation(TriangleMesh& mesh, const std::string& name)
    : mesh_(mesh), name_(name), inspection_(mesh)
  {
  }

  void check_duplicates() const;
  void check_areas() const;
  void check_edges() const;
  void check_vertices() const;
  void check_components() const;
  void check_genus() const;
  void check_crossing() const;
  /// These change the mesh, and say what they did.
  std::string orient() const;
  std::string drop_unused_points() const;

private:
  template<typename... Arguments>
  [[noreturn]] void fail(fmt::format_string<Arguments...> text, Arguments&&... arguments) const
  {
    throw InputError(name_ + ": " + fmt::format(text, std::forward<Arguments>(arguments)...));
  }
  Vector3 point(int i) const { return mesh_.points.row(i); }
  std::string place_of_edge(int e) const;
  double diagonal() const;

  TriangleMesh& mesh_;
  const std::string& name_;
  MeshInspection inspection_;
};

std::string Preparation::place_of_edge(int e) const
{
  const EdgeUse& use = inspection_.edges()[e].front();
  return fmt::format("edge {}–{} {}", use.a, use.b, near_text((point(use.a) + point(use.b)) / 2));
}

/// Of the bounding box of the points in use.
double Preparation::diagonal() const
{
  Vector3 low = point(mesh_.triangles(0, 0));
  Vector3 high = low;
  for (const int vertex : mesh_.triangles.reshaped())
  {
    low = low.cwiseMin(point(vertex));
    high = high.cwiseMax(point(vertex));
  }
  return (high - low).norm();
}

void Preparation::check_duplicates() const
{
  const double size = diagonal();
  if (!(size > 0))
    fail("all points coincide {}", near_text(point(mesh_.triangles(0, 0))));
  const Vector3 origin = point(mesh_.triangles(0, 0));
  PointHash seen(duplicate_distance * size);
  for (int i = 0; i < mesh_.points.rows(); ++i)
  {
    if (!inspection_.used(i))
      continue;
    if (const int twin = seen.find(point(i) - origin); twin >= 0)
    {
      fail(
        "duplicate points {} and {} {}: merge points that coincide by --merge {:.2g} (vesicle run, "
        "info, curvature), vesicle.merge in a scene, or vtkCleanPolyData (ParaView's Clean)",
        twin, i, near_text(point(i)), merge_distance(duplicate_distance * size));
    }
    seen.insert(point(i) - origin, i);
  }
}

void Preparation::check_areas() const
{
  for (int t = 0; t < mesh_.triangles.rows(); ++t)
  {
    const int i = mesh_.triangles(t, 0), j = mesh_.triangles(t, 1), k = mesh_.triangles(t, 2);
    const auto [a, b, c] = corners(mesh_, t);
    const double longest =
      std::max({ (b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm() });
    if (i == j || j == k || k == i || (b - a).cross(c - a).norm() <= degenerate_area * longest)
    {
      fail("degenerate triangle {} (points {}, {}, {}) without area {}: remove it by merging its "
           "points (vtkCleanPolyData) or remesh the surface",
        t, i, j, k, near_text((a + b + c) / 3));
    }
  }
}

void Preparation::check_edges() const
{
  if (const int e = inspection_.first_nonmanifold_edge(); e >= 0)
  {
    fail("{} triangles meet at {}: a membrane has two at every edge; remove inner walls and double "
         "triangles",
      inspection_.edges()[e].size(), place_of_edge(e));
  }
  if (const int e = inspection_.first_border_edge(); e >= 0)
  {
    if (const auto gap = seam_gap(mesh_))
    {
      fail("open border at {}: the corners of neighbouring triangles differ by up to {:.2g};"
           " merge them by --merge {:.2g} (vesicle run, info, curvature), in a scene vesicle.merge",
        place_of_edge(e), *gap, merge_distance(*gap));
    }
    const int holes = inspection_.holes();
    fail("open border at {}: the mesh has {} hole{} and a vesicle none; close {} "
         "(vtkFillHolesFilter), or merge points along a seam (vtkCleanPolyData)",
      place_of_edge(e), holes, holes == 1 ? "" : "s", holes == 1 ? "it" : "them");
  }
}

void Preparation::check_vertices() const
{
  if (const int v = inspection_.first_nonmanifold_vertex(); v >= 0)
  {
    fail("two parts of the surface touch in point {} {} only: give each part its own point, or "
         "remove one of them",
      v, near_text(point(v)));
  }
}

void Preparation::check_components() const
{
  const std::vector<int> starts = inspection_.component_vertices();
  if (starts.size() > 1)
  {
    fail(
      "the mesh has {} separate components, the first with point {} {}, the second with point {} "
      "{}: simulate one vesicle at a time; keep one of them "
      "(vtkPolyDataConnectivityFilter, ParaView's Connectivity)",
      starts.size(), starts[0], near_text(point(starts[0])), starts[1],
      near_text(point(starts[1])));
  }
}

void Preparation::check_genus() const
{
  if (const int genus = topology(mesh_).genus.value_or(0); genus != 0)
  {
    Vector3 middle = Vector3::Zero();
    for (const int vertex : mesh_.triangles.reshaped())
      middle += point(vertex) / static_cast<double>(mesh_.triangles.size());
    fail(
      "the surface about its centre {} has genus {} ({} handle{}, as a torus has one): a vesicle "
      "here is a deformed sphere, of genus 0",
      near_text(middle), genus, genus, genus == 1 ? "" : "s");
  }
}

void Preparation::check_crossing() const
{
  if (const auto crossing = find_self_crossing(mesh_))
  {
    fail("the surface crosses itself: {}; part the sheets there, or remesh a smoother surface",
      to_text(*crossing));
  }
}

std::string Preparation::orient() const
{
  MeshInspection::Reorientation change = inspection_.reorientation();
  if (change.contradicting_edge >= 0)
  {
    fail(
      "the surface has one side only (it can't be oriented), seen at {}: a vesicle has an inside "
      "and an outside",
      place_of_edge(change.contradicting_edge));
  }
  const auto flip = [this](const std::vector<bool>& flipped)
  {
    for (int t = 0; t < mesh_.triangles.rows(); ++t)
      if (flipped[t])
        std::swap(mesh_.triangles(t, 1), mesh_.triangles(t, 2));
  };
  flip(change.flipped);
  const double volume = flat_volume(mesh_);
  if (std::abs(volume) <= no_volume * std::pow(flat_area(mesh_), 1.5))
  {
    fail("the surface encloses no volume {}: it is folded flat",
      near_text(point(mesh_.triangles(0, 0))));
  }
  if (volume < 0)
  {
    flip(std::vector<bool>(mesh_.triangles.rows(), true));
    change.flipped.flip();
  }
  const auto count = std::ranges::count(change.flipped, true);
  if (count == 0)
    return {};
  if (count == mesh_.triangles.rows())
    return "the triangles faced inward and were turned outward";
  return fmt::format("{} of {} triangles faced inward and were turned outward, as the others",
    count, mesh_.triangles.rows());
}

std::string Preparation::drop_unused_points() const
{
  const int points = static_cast<int>(mesh_.points.rows());
  const int used = inspection_.used_vertices();
  if (used == points)
    return {};
  std::vector<int> number(points, -1);
  int next = 0;
  for (int i = 0; i < points; ++i)
  {
    if (inspection_.used(i))
    {
      number[i] = next;
      mesh_.points.row(next++) = point(i).transpose();
    }
  }
  mesh_.points.conservativeResize(used, Eigen::NoChange);
  for (int& vertex : mesh_.triangles.reshaped())
    vertex = number[vertex];
  return points - used == 1
    ? std::string("a point that no triangle uses was dropped")
    : fmt::format("{} points that no triangle uses were dropped", points - used);
}
}

void check_indices(const TriangleMesh& mesh, const std::string& name)
{
  const auto points = mesh.points.rows();
  if (points == 0 || mesh.triangles.rows() == 0)
  {
    throw InputError(fmt::format(
      "{}: the mesh is empty ({} points, {} triangles)", name, points, mesh.triangles.rows()));
  }
  PolygonList triangles;
  triangles.corners.reserve(mesh.triangles.size());
  for (const auto& row : mesh.triangles.rowwise())
  {
    triangles.corners.insert(triangles.corners.end(), { row[0], row[1], row[2] });
    triangles.close(triangles.size());
  }
  check_points(mesh.points, name);
  check_corners(triangles, points, name, 0, "triangle");
}

// The order goes from causes to consequences: an unmerged seam, for instance, also looks open.
std::string prepare_for_dynamics(TriangleMesh& mesh, const std::string& name)
{
  check_indices(mesh, name);
  const Preparation preparation(mesh, name);
  preparation.check_duplicates();
  preparation.check_genus(); // where it is known already: no remedy below helps against a handle
  preparation.check_areas();
  preparation.check_edges();
  preparation.check_vertices();
  preparation.check_components();
  std::vector<std::string> changes{ preparation.orient() };
  preparation.check_genus();
  preparation.check_crossing();
  changes.push_back(preparation.drop_unused_points());
  std::erase(changes, "");
  return changes.empty() ? "" : fmt::format("{}: {}", name, joined(changes, "; "));
}

}
