#include "solver/mesh/remesh/EdgeEdits.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace vesicle
{

namespace
{
/// Vertices of the input may have any number of neighbours; collapses shan't make more or less.
constexpr int least_collapsed_valence = 4;
constexpr int largest_collapsed_valence = 9;

/// The collapses of one call: none touches the triangles of another.
class Collapses
{
public:
  Collapses(DraftMesh& mesh, double longest)
    : mesh(mesh), longest(longest),
      connectivity(mesh.triangles, static_cast<int>(mesh.points.rows())),
      goal(mesh.points.rows(), -1), locked(mesh.points.rows(), false), valence(mesh.points.rows())
  {
    for (int i = 0; i < mesh.points.rows(); ++i)
    {
      valence[i] = connectivity.vertex_neighbours.size(i);
    }
  }
  /// Plans to draw a and b together, if that is possible.
  bool collapse(int a, int b);
  void apply();

private:
  bool possible(const std::vector<int>& common, int a, int b) const;
  double longest_after(int from, int to) const;
  bool faces_outward_after(int from, int to) const;
  bool fits(int from, int to) const
  {
    return longest_after(from, to) <= longest && faces_outward_after(from, to);
  }

  DraftMesh& mesh;
  double longest;
  Connectivity connectivity;
  std::vector<int> goal; ///< the vertex that a vertex is drawn to, −1 if it stays
  std::vector<bool> locked;
  std::vector<int> valence;
};

/// The longest edge that the vertex `to` has if `from` is drawn to it.
double Collapses::longest_after(int from, int to) const
{
  const AdjacencyList& around = connectivity.vertex_neighbours;
  double result = 0;
  for (const int* i = around.begin(from); i != around.end(from); ++i)
  {
    result = *i == to ? result : std::max(result, mesh.length(to, *i));
  }
  return result;
}

bool Collapses::faces_outward_after(int from, int to) const
{
  const AdjacencyList& around = connectivity.vertex_triangles;
  for (const int* t = around.begin(from); t != around.end(from); ++t)
  {
    Eigen::Vector3i corners = mesh.triangles.row(*t);
    if ((corners.array() != to).all())
    {
      corners = (corners.array() == from).select(to, corners);
      if (!mesh.faces_outward(corners[0], corners[1], corners[2]))
      {
        return false;
      }
    }
  }
  return true;
}

/// The result is a manifold if the ends have two neighbours in common, those facing the edge (link
/// condition: T. K. Dey, H. Edelsbrunner, S. Guha, D. V. Nekhayev, Publ. Inst. Math. 66 (1999) 23).
bool Collapses::possible(const std::vector<int>& common, int a, int b) const
{
  const int after = valence[a] + valence[b] - 4;
  return common.size() == 2 && valence[common[0]] > least_collapsed_valence &&
    valence[common[1]] > least_collapsed_valence && after >= least_collapsed_valence &&
    after <= std::max({ valence[a], valence[b], largest_collapsed_valence });
}

bool Collapses::collapse(int a, int b)
{
  if (locked[a] || locked[b])
  {
    return false;
  }
  const AdjacencyList& around = connectivity.vertex_neighbours;
  std::vector<int> common;
  std::set_intersection(
    around.begin(a), around.end(a), around.begin(b), around.end(b), std::back_inserter(common));
  if (!possible(common, a, b))
  {
    return false;
  }
  const double tie = 1 + 1e-9; // rounding shan't decide between equals
  if (longest_after(b, a) * tie < longest_after(a, b))
  {
    std::swap(a, b);
  }
  if (!fits(a, b))
  {
    std::swap(a, b);
  }
  if (!fits(a, b))
  {
    return false;
  }
  goal[a] = b;
  locked[a] = true;
  for (const int* i = around.begin(a); i != around.end(a); ++i)
  {
    locked[*i] = true;
  }
  valence[b] += valence[a] - 4;
  --valence[common[0]];
  --valence[common[1]];
  return true;
}

void Collapses::apply()
{
  std::vector<int> number(goal.size(), -1);
  int points = 0;
  for (int i = 0; i < static_cast<int>(goal.size()); ++i)
  {
    if (goal[i] < 0)
    {
      mesh.points.row(points) = mesh.points.row(i).eval();
      mesh.normals.row(points) = mesh.normals.row(i).eval();
      number[i] = points++;
    }
  }
  mesh.points.conservativeResize(points, Eigen::NoChange);
  mesh.normals.conservativeResize(points, Eigen::NoChange);
  const auto renumbered = [&](int i) { return number[goal[i] < 0 ? i : goal[i]]; };
  std::ranges::transform(mesh.references, mesh.references.begin(), renumbered);
  int triangles = 0;
  for (int t = 0; t < mesh.triangles.rows(); ++t)
  {
    Eigen::RowVector3i row = mesh.triangles.row(t);
    for (int& corner : row)
    {
      corner = renumbered(corner);
    }
    if (row[0] != row[1] && row[1] != row[2] && row[2] != row[0])
    {
      mesh.triangles.row(triangles++) = row;
    }
  }
  mesh.triangles.conservativeResize(triangles, Eigen::NoChange);
}
}

int collapse_edges(DraftMesh& mesh, double length, double longest, int most)
{
  const EdgeUses edges(mesh.triangles);
  Collapses collapses(mesh, longest);
  int count = 0;
  for (const int e : mesh.edges_between(-1, length, edges))
  {
    const auto [a, b, triangle, forward] = edges[e].front();
    count += count < most && collapses.collapse(a, b);
  }
  collapses.apply();
  return count;
}

}
