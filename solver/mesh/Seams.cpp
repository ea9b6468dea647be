#include "solver/mesh/Seams.h"

#include "solver/mesh/EdgeUses.h"
#include "solver/mesh/PointHash.h"

#include <algorithm>
#include <vector>

namespace vesicle
{
namespace
{

constexpr double nearest_twin = 1e-4; // of the diagonal

std::vector<int> border_points(const Triangles& triangles)
{
  const EdgeUses uses(triangles);
  std::vector<int> points;
  for (int e = 0; e < uses.size(); ++e)
    if (uses[e].size() == 1)
      points.insert(points.end(), { uses[e][0].a, uses[e][0].b });
  std::ranges::sort(points);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

}

std::optional<double> seam_gap(const TriangleMesh& mesh)
{
  const std::vector<int> border = border_points(mesh.triangles);
  if (border.empty())
    return {};
  const Eigen::RowVector3d low = mesh.points.colwise().minCoeff();
  const double diagonal = box_diagonal(mesh.points);
  if (!(diagonal > 0))
    return {};
  PointHash seen(nearest_twin * diagonal);
  std::size_t twins = 0;
  double gap = 0;
  for (const int i : border)
  {
    const Vector3 x = (mesh.points.row(i) - low).transpose();
    const int twin = seen.find(x);
    if (twin < 0)
    {
      seen.insert(x, i);
      continue;
    }
    ++twins;
    gap = std::max(gap, (mesh.points.row(i) - mesh.points.row(twin)).norm());
  }
  // Of two twins one is found, of more all but one.
  if (2 * twins < border.size() / 2)
    return {};
  return gap;
}

double merge_distance(double gap)
{
  return 2 * gap;
}

}
