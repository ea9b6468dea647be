#include "solver/mesh/repair/Smoothing.h"

#include "solver/mesh/Connectivity.h"

namespace vesicle
{
namespace
{

constexpr double lambda = 0.5, mu = -0.53;

void move_to_neighbours(
  Points& points, const AdjacencyList& neighbours, const std::vector<char>& fixed, double share)
{
  const Points before = points;
  for (int i = 0; i < before.rows(); ++i)
  {
    if (fixed[i] || neighbours.size(i) == 0)
      continue;
    Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
    for (const int* j = neighbours.begin(i); j != neighbours.end(i); ++j)
      sum += before.row(*j);
    points.row(i) += share * (sum / neighbours.size(i) - before.row(i));
  }
}

}

void smooth_noise(TriangleMesh& mesh, int passes)
{
  const Connectivity connectivity(mesh.triangles, static_cast<int>(mesh.points.rows()));
  const std::vector<char> border = border_vertices(connectivity);
  for (int i = 0; i < passes; ++i)
    for (const double share : { lambda, mu })
      move_to_neighbours(mesh.points, connectivity.vertex_neighbours, border, share);
}

}
