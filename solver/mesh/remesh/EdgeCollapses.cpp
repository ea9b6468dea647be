#include "solver/mesh/remesh/EdgeCollapses.h"

#include "solver/mesh/Connectivity.h"

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
  Collapses(EditableMesh& mesh, double longest)
    : mesh_(mesh), longest_(longest),
      connectivity_(mesh.triangles, static_cast<int>(mesh.points.rows())),
      goal_(mesh.points.rows(), -1), locked_(mesh.points.rows(), false),
      valence_(mesh.points.rows())
  {
    for (int i = 0; i < mesh.points.rows(); ++i)
      valence_[i] = connectivity_.vertex_neighbours.size(i);
  }
  /// Plans to merge a and b, if that is possible.
  bool collapse(int a, int b);
  void apply();

private:
  bool possible(const std::vector<int>& common, int a, int b) const;
  double longest_after(int from, int to) const;
  bool faces_outward_after(int from, int to) const;
  bool fits(int from, int to) const
  {
    return longest_after(from, to) <= longest_ && faces_outward_after(from, to);
  }

  EditableMesh& mesh_;
  double longest_;
  Connectivity connectivity_;
  std::vector<int> goal_; ///< the vertex that a vertex is merged into, −1 if it stays
  std::vector<bool> locked_;
  std::vector<int> valence_;
};

/// The longest edge that the vertex `to` has if `from` is merged into it.
double Collapses::longest_after(int from, int to) const
{
  const AdjacencyList& around = connectivity_.vertex_neighbours;
  double result = 0;
  for (const int* i = around.begin(from); i != around.end(from); ++i)
    result = *i == to ? result : std::max(result, mesh_.length(to, *i));
  return result;
}

bool Collapses::faces_outward_after(int from, int to) const
{
  const AdjacencyList& around = connectivity_.vertex_triangles;
  for (const int* t = around.begin(from); t != around.end(from); ++t)
  {
    Eigen::Vector3i corners = mesh_.triangles.row(*t);
    if ((corners.array() != to).all())
    {
      corners = (corners.array() == from).select(to, corners);
      if (!mesh_.faces_outward(corners[0], corners[1], corners[2]))
        return false;
    }
  }
  return true;
}

/// The result is a manifold if the ends have two neighbours in common, those facing the edge (link
/// condition: T. K. Dey, H. Edelsbrunner, S. Guha, D. V. Nekhayev, Publ. Inst. Math. 66 (1999) 23).
bool Collapses::possible(const std::vector<int>& common, int a, int b) const
{
  const int after = valence_[a] + valence_[b] - 4;
  return common.size() == 2 && valence_[common[0]] > least_collapsed_valence &&
    valence_[common[1]] > least_collapsed_valence && after >= least_collapsed_valence &&
    after <= std::max({ valence_[a], valence_[b], largest_collapsed_valence });
}

bool Collapses::collapse(int a, int b)
{
  if (locked_[a] || locked_[b])
    return false;
  const AdjacencyList& around = connectivity_.vertex_neighbours;
  std::vector<int> common;
  std::set_intersection(
    around.begin(a), around.end(a), around.begin(b), around.end(b), std::back_inserter(common));
  if (!possible(common, a, b))
    return false;
  const double tie = 1 + 1e-9; // rounding shan't decide between equals
  if (longest_after(b, a) * tie < longest_after(a, b))
    std::swap(a, b);
  if (!fits(a, b))
    std::swap(a, b);
  if (!fits(a, b))
    return false;
  goal_[a] = b;
  locked_[a] = true;
  for (const int* i = around.begin(a); i != around.end(a); ++i)
    locked_[*i] = true;
  valence_[b] += valence_[a] - 4;
  --valence_[common[0]];
  --valence_[common[1]];
  return true;
}

void Collapses::apply()
{
  std::vector<int> number(goal_.size(), -1);
  int points = 0;
  for (int i = 0; i < static_cast<int>(goal_.size()); ++i)
  {
    if (goal_[i] < 0)
    {
      mesh_.points.row(points) = mesh_.points.row(i).eval();
      mesh_.normals.row(points) = mesh_.normals.row(i).eval();
      if (mesh_.sizes.size() > 0)
        mesh_.sizes[points] = mesh_.sizes[i];
      number[i] = points++;
    }
  }
  mesh_.points.conservativeResize(points, Eigen::NoChange);
  mesh_.normals.conservativeResize(points, Eigen::NoChange);
  if (mesh_.sizes.size() > 0)
    mesh_.sizes.conservativeResize(points);
  const auto renumbered = [&](int i) { return number[goal_[i] < 0 ? i : goal_[i]]; };
  std::ranges::transform(mesh_.references, mesh_.references.begin(), renumbered);
  int triangles = 0;
  for (int t = 0; t < mesh_.triangles.rows(); ++t)
  {
    Eigen::RowVector3i row = mesh_.triangles.row(t);
    for (int& corner : row)
      corner = renumbered(corner);
    if (row[0] != row[1] && row[1] != row[2] && row[2] != row[0])
      mesh_.triangles.row(triangles++) = row;
  }
  mesh_.triangles.conservativeResize(triangles, Eigen::NoChange);
}
}

int collapse_edges(EditableMesh& mesh, double length, double longest, int most)
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
