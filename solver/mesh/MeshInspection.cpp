#include "solver/mesh/MeshInspection.h"

#include "solver/mesh/DisjointSets.h"

#include <fmt/format.h>

#include <algorithm>

namespace vesicle
{

template<typename Condition>
int MeshInspection::first_edge(Condition holds) const
{
  for (int e = 0; e < uses_.size(); ++e)
    if (holds(uses_[e].size()))
      return e;
  return -1;
}

MeshInspection::MeshInspection(const TriangleMesh& mesh)
  : uses_(mesh.triangles), triangles_(mesh.triangles), is_used_(mesh.points.rows(), false)
{
  for (const int vertex : mesh.triangles.reshaped())
    is_used_[vertex] = true;
}

int MeshInspection::first_border_edge() const
{
  return first_edge([](std::size_t sides) { return sides == 1; });
}

int MeshInspection::first_nonmanifold_edge() const
{
  return first_edge([](std::size_t sides) { return sides > 2; });
}

int MeshInspection::holes() const
{
  DisjointSets borders(static_cast<int>(is_used_.size()));
  std::vector<int> ends;
  for (int e = 0; e < uses_.size(); ++e)
  {
    if (uses_[e].size() == 1)
    {
      borders.unite(uses_[e][0].a, uses_[e][0].b);
      ends.push_back(uses_[e][0].a);
    }
  }
  std::ranges::transform(ends, ends.begin(), [&](int v) { return borders.find(v); });
  std::ranges::sort(ends);
  return static_cast<int>(std::unique(ends.begin(), ends.end()) - ends.begin());
}

// Corner 3t + k is corner k of triangle t. Corners of one vertex in triangles that share an edge
// there belong to one fan.
int MeshInspection::first_nonmanifold_vertex() const
{
  const auto corner_of = [&](int triangle, int vertex)
  {
    const auto row = triangles_.row(triangle);
    return 3 * triangle + (row[0] == vertex ? 0 : row[1] == vertex ? 1 : 2);
  };
  DisjointSets fans(3 * static_cast<int>(triangles_.rows()));
  for (int e = 0; e < uses_.size(); ++e)
  {
    const EdgeUse& first = uses_[e].front();
    for (const EdgeUse& use : uses_[e])
    {
      fans.unite(corner_of(first.triangle, use.a), corner_of(use.triangle, use.a));
      fans.unite(corner_of(first.triangle, use.b), corner_of(use.triangle, use.b));
    }
  }
  std::vector<int> fan(is_used_.size(), -1);
  int pinched = -1;
  for (int t = 0; t < triangles_.rows(); ++t)
  {
    for (const int vertex : triangles_.row(t))
    {
      const int here = fans.find(corner_of(t, vertex));
      if (fan[vertex] >= 0 && fan[vertex] != here && (pinched < 0 || vertex < pinched))
        pinched = vertex;
      fan[vertex] = here;
    }
  }
  return pinched;
}

int MeshInspection::used_vertices() const
{
  return static_cast<int>(std::ranges::count(is_used_, true));
}

std::vector<int> MeshInspection::component_vertices() const
{
  DisjointSets components(static_cast<int>(is_used_.size()));
  for (int e = 0; e < uses_.size(); ++e)
    components.unite(uses_[e].front().a, uses_[e].front().b);
  std::vector<int> vertices;
  for (int v = 0; v < static_cast<int>(is_used_.size()); ++v)
    if (is_used_[v] && components.find(v) == v)
      vertices.push_back(v);
  return vertices;
}

bool MeshInspection::oriented() const
{
  for (int e = 0; e < uses_.size(); ++e)
    if (uses_[e].size() == 2 && uses_[e][0].forward == uses_[e][1].forward)
      return false;
  return true;
}

// Two nodes a triangle, as it is and turned over: an edge unites the nodes that agree there. The
// surface is one-sided where a triangle agrees with itself turned over.
MeshInspection::Reorientation MeshInspection::reorientation() const
{
  const int count = static_cast<int>(triangles_.rows());
  DisjointSets sides(2 * count);
  Reorientation result{ std::vector<bool>(count, false), -1 };
  for (int e = 0; e < uses_.size(); ++e)
  {
    if (uses_[e].size() != 2)
      continue;
    const EdgeUse& s = uses_[e][0];
    const EdgeUse& t = uses_[e][1];
    const int turn = s.forward == t.forward ? count : 0;
    sides.unite(s.triangle, t.triangle + turn);
    sides.unite(s.triangle + count, t.triangle + (count - turn));
    if (sides.find(s.triangle) == sides.find(s.triangle + count))
    {
      result.contradicting_edge = e;
      return result;
    }
  }
  // The smallest number represents a set: it is that of the component's first triangle as it is.
  for (int t = 0; t < count; ++t)
    result.flipped[t] = sides.find(t) > sides.find(t + count);
  return result;
}

std::string MeshInspection::nonmanifold_place(const Points& points) const
{
  const auto point = [&](int i) -> Vector3 { return points.row(i); };
  if (const int e = first_nonmanifold_edge(); e >= 0)
  {
    const EdgeUse& use = uses_[e].front();
    return fmt::format("{} triangles at edge {}–{} {}", uses_[e].size(), use.a, use.b,
      near_text((point(use.a) + point(use.b)) / 2));
  }
  if (const int v = first_nonmanifold_vertex(); v >= 0)
    return fmt::format("two parts share only point {} {}", v, near_text(point(v)));
  return {};
}

std::string near_text(const Vector3& x)
{
  return fmt::format("near ({:.6g}, {:.6g}, {:.6g})", x.x(), x.y(), x.z());
}

}
