#include "solver/mesh/MeshInspection.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace vesicle
{

DisjointSets::DisjointSets(int n) : parent(n)
{
  std::iota(parent.begin(), parent.end(), 0);
}

int DisjointSets::find(int i)
{
  while (parent[i] != i)
  {
    parent[i] = parent[parent[i]];
    i = parent[i];
  }
  return i;
}

// The smaller number represents the set.
void DisjointSets::unite(int i, int j)
{
  const auto [low, high] = std::minmax({ find(i), find(j) });
  parent[high] = low;
}

template<typename Condition>
int MeshInspection::first_edge(Condition holds) const
{
  for (int e = 0; e < uses.size(); ++e)
  {
    if (holds(uses[e].size()))
    {
      return e;
    }
  }
  return -1;
}

MeshInspection::MeshInspection(const TriangleMesh& mesh)
  : uses(mesh.triangles), triangles(mesh.triangles), is_used(mesh.points.rows(), false)
{
  for (const int vertex : mesh.triangles.reshaped())
  {
    is_used[vertex] = true;
  }
}

int MeshInspection::first_open_edge() const
{
  return first_edge([](std::size_t sides) { return sides == 1; });
}

int MeshInspection::first_crowded_edge() const
{
  return first_edge([](std::size_t sides) { return sides > 2; });
}

int MeshInspection::holes() const
{
  DisjointSets borders(static_cast<int>(is_used.size()));
  std::vector<int> ends;
  for (int e = 0; e < uses.size(); ++e)
  {
    if (uses[e].size() == 1)
    {
      borders.unite(uses[e][0].a, uses[e][0].b);
      ends.push_back(uses[e][0].a);
    }
  }
  std::ranges::transform(ends, ends.begin(), [&](int v) { return borders.find(v); });
  std::ranges::sort(ends);
  return static_cast<int>(std::unique(ends.begin(), ends.end()) - ends.begin());
}

// Corner 3t + k is corner k of triangle t. Corners of one vertex in triangles that share an edge
// there belong to one fan.
int MeshInspection::first_pinched_vertex() const
{
  const auto corner_of = [&](int triangle, int vertex)
  {
    const auto row = triangles.row(triangle);
    return 3 * triangle + (row[0] == vertex ? 0 : row[1] == vertex ? 1 : 2);
  };
  DisjointSets fans(3 * static_cast<int>(triangles.rows()));
  for (int e = 0; e < uses.size(); ++e)
  {
    const EdgeUse& first = uses[e].front();
    for (const EdgeUse& use : uses[e])
    {
      fans.unite(corner_of(first.triangle, use.a), corner_of(use.triangle, use.a));
      fans.unite(corner_of(first.triangle, use.b), corner_of(use.triangle, use.b));
    }
  }
  std::vector<int> fan(is_used.size(), -1);
  int pinched = -1;
  for (int t = 0; t < triangles.rows(); ++t)
  {
    for (const int vertex : triangles.row(t))
    {
      const int here = fans.find(corner_of(t, vertex));
      if (fan[vertex] >= 0 && fan[vertex] != here && (pinched < 0 || vertex < pinched))
      {
        pinched = vertex;
      }
      fan[vertex] = here;
    }
  }
  return pinched;
}

int MeshInspection::used_vertices() const
{
  return static_cast<int>(std::ranges::count(is_used, true));
}

std::vector<int> MeshInspection::component_vertices() const
{
  DisjointSets components(static_cast<int>(is_used.size()));
  for (int e = 0; e < uses.size(); ++e)
  {
    components.unite(uses[e].front().a, uses[e].front().b);
  }
  std::vector<int> vertices;
  for (int v = 0; v < static_cast<int>(is_used.size()); ++v)
  {
    if (is_used[v] && components.find(v) == v)
    {
      vertices.push_back(v);
    }
  }
  return vertices;
}

bool MeshInspection::oriented() const
{
  for (int e = 0; e < uses.size(); ++e)
  {
    if (uses[e].size() == 2 && uses[e][0].forward == uses[e][1].forward)
    {
      return false;
    }
  }
  return true;
}

// Two nodes a triangle, as it is and turned over: an edge unites the nodes that agree there. The
// surface is one-sided where a triangle agrees with itself turned over.
MeshInspection::Turns MeshInspection::turns_to_agree() const
{
  const int count = static_cast<int>(triangles.rows());
  DisjointSets sides(2 * count);
  Turns result{ std::vector<bool>(count, false), -1 };
  for (int e = 0; e < uses.size(); ++e)
  {
    if (uses[e].size() != 2)
    {
      continue;
    }
    const EdgeUse& s = uses[e][0];
    const EdgeUse& t = uses[e][1];
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
  {
    result.turned[t] = sides.find(t) > sides.find(t + count);
  }
  return result;
}

}
