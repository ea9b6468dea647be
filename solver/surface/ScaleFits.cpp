#include "solver/surface/ScaleFits.h"

#include "solver/mesh/VertexNormals.h"

#include <memory>
#include <tuple>

namespace vesicle
{

namespace
{

// Twice the six unknowns.
constexpr int fewest_points = 12;
// The part of the radius over which area vectors are added up, and the least cosine between the
// sums of two vertices that are fitted together; those of two in neighbourhoods of a cluster may
// differ more.
constexpr double normal_share = 1. / 3, least_cosine = 0.3, least_cosine_in_cluster = 0;
// A cluster's radius: its vertices' neighbourhoods have most points in common.
constexpr double cluster_share = 1. / 4;
// Normals found at once between two words of progress.
constexpr int normals_at_once = 8192;

}

ScaleFits::ScaleFits(const TriangleMesh& mesh, const Connectivity& connectivity, double radius,
  const ProgressCallback& progress)
  : points_(mesh.points), neighbours_(connectivity.vertex_neighbours), radius_(radius),
    clusters_(points_, neighbours_, cluster_share * radius),
    normal_(Points::Zero(mesh.points.rows(), 3))
{
  const Points area = vertex_area_vectors(mesh.points, mesh.triangles);
  parallel_for_in_parts(static_cast<int>(points_.rows()), normals_at_once, progress,
    [&](int i)
    {
      thread_local const auto search = std::make_unique<NeighbourSearch>();
      normal_.row(i) = smoothed_normal(i, area, *search);
    });
}

Vector3 ScaleFits::smoothed_normal(int i, const Points& area, NeighbourSearch& search) const
{
  const double square = normal_share * normal_share * radius_ * radius_;
  Vector3 sum = area.row(i);
  search.spread(neighbours_, i,
    [&](int j)
    {
      const bool is_near = (points_.row(j) - points_.row(i)).squaredNorm() <= square;
      if (is_near)
        sum += area.row(j);
      return is_near;
    });
  return sum.normalized();
}

void ScaleFits::begin(int cluster, Workspace& work) const
{
  const int centre = clusters_[cluster].front();
  const Eigen::RowVector3d at = points_.row(centre), normal = normal_.row(centre);
  const double reach = (1 + cluster_share) * radius_;
  work.search.spread(neighbours_, centre,
    [&](int j)
    {
      return (points_.row(j) - at).squaredNorm() <= reach * reach &&
        normal_.row(j).dot(normal) >= least_cosine_in_cluster;
    });
  work.candidate = work.search.found();
  work.candidate.push_back(centre);
  Candidates& candidates = work.candidates;
  for (const auto& [column, point, to] :
    { std::tuple(0, &points_, &candidates.x), { 1, &points_, &candidates.y },
      { 2, &points_, &candidates.z }, { 0, &normal_, &candidates.nx },
      { 1, &normal_, &candidates.ny }, { 2, &normal_, &candidates.nz } })
  {
    to->clear();
    for (const int j : work.candidate)
      to->push_back((*point)(j, column));
  }
}

bool ScaleFits::fit(int i, Workspace& work) const
{
  const Vector3 normal = normal_.row(i);
  return !normal.isZero(0) &&
    work.fit.choose(work.candidates, points_.row(i), normal, radius_, least_cosine) >=
    fewest_points &&
    work.fit.compute(normal, radius_);
}

double ScaleFits::laplacian(
  int i, const Vector3& normal, const Eigen::VectorXd& field, Workspace& work) const
{
  work.fit.choose(work.candidates, points_.row(i), normal_.row(i), radius_, least_cosine);
  work.field.clear();
  for (const int k : work.fit.chosen())
    work.field.push_back(field[work.candidate[k]]);
  return work.fit.laplacian(normal, radius_, work.field);
}

}
