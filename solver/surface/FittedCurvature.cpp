#include "solver/surface/FittedCurvature.h"

#include "solver/Errors.h"
#include "solver/surface/NearestFits.h"
#include "solver/surface/ScaleFits.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace vesicle
{

namespace
{

// Vertices that a thread fits one after the other, and how many such blocks are done between two
// words of progress, some hundredths of a second.
constexpr int block_size = 64, blocks_at_once = 64;
// The same of vertices at a length scale, in clusters.
constexpr int vertices_at_once = 4096, least_clusters_at_once = 16;

/// Of successive vertices: Δ_s f = Σ_k weight_k (f(neighbour_k) − f(vertex)), k from one start to
/// the next.
struct LaplacianRows
{
  std::vector<int> start{ 0 };
  std::vector<int> neighbour;
  std::vector<double> weight;

  void add(const std::vector<int>& neighbours, std::span<const double> weights)
  {
    neighbour.insert(neighbour.end(), neighbours.begin(), neighbours.end());
    weight.insert(weight.end(), weights.begin(), weights.end());
  }
  bool is_empty(int row) const { return start[row] == start[row + 1]; }
  void end_row() { start.push_back(static_cast<int>(neighbour.size())); }
  double times(int row, const Eigen::VectorXd& f, double at_vertex) const
  {
    double sum = 0;
    for (int k = start[row]; k < start[row + 1]; ++k)
      sum += weight[k] * (f[neighbour[k]] - at_vertex);
    return sum;
  }
};

FittedCurvature zeros(int n)
{
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(n);
  return { { Points::Zero(n, 3), zero, zero, zero }, Points::Zero(n, 3), zero, zero,
    Eigen::VectorXi::Zero(n), {} };
}

/// Mean length of the edges at a vertex.
double edge_length(const Points& points, const AdjacencyList& neighbours, int i)
{
  double sum = 0;
  for (const int* j = neighbours.begin(i); j != neighbours.end(i); ++j)
    sum += (points.row(*j) - points.row(i)).norm();
  return sum / neighbours.size(i);
}

/// The fits of a mesh and what they give.
class Fits
{
public:
  Fits(const TriangleMesh& mesh, const Connectivity& connectivity)
    : mesh_(mesh), connectivity_(connectivity), n_(static_cast<int>(mesh.points.rows())),
      blocks_((n_ + block_size - 1) / block_size), rows_(blocks_), result_(zeros(n_))
  {
    result_.border = border_vertices(connectivity);
  }

  /// All but Δ_s H.
  void fit_at_scale(const ScaleFits& fits, const ProgressCallback& progress);
  /// Where there is no fit yet.
  void fit_to_nearest(const ProgressCallback& progress);
  /// By the same fits.
  void add_laplacian(const ScaleFits* at_scale, const ProgressCallback& progress);

  FittedCurvature result() && { return std::move(result_); }

private:
  template<typename Fit>
  void write(int i, int degree, const Fit& fit, double error);
  /// Calls visit(i, its row's block, the row's number, workspace).
  template<typename Workspace, typename Visit>
  void for_each_vertex(const ProgressCallback& progress, const Visit& visit);
  /// Calls visit(i, workspace) in each cluster of which the workspace has begun.
  template<typename Visit>
  void for_each_in_cluster(
    const ScaleFits& fits, const ProgressCallback& progress, const Visit& visit);

  const TriangleMesh& mesh_;
  const Connectivity& connectivity_;
  int n_, blocks_;
  std::vector<LaplacianRows> rows_; ///< of the fits to the nearest vertices
  FittedCurvature result_;
};

template<typename Fit>
void Fits::write(int i, int degree, const Fit& fit, double error)
{
  const MongePatch& surface = fit.surface();
  result_.curvature.normal.row(i) = surface.normal();
  result_.curvature.mean[i] = surface.mean();
  result_.curvature.gauss[i] = surface.gauss();
  result_.direction.row(i) = surface.direction();
  result_.mean_error[i] = error;
  result_.residual[i] =
    fit.residual() / edge_length(mesh_.points, connectivity_.vertex_neighbours, i);
  result_.degree[i] = degree;
}

template<typename Workspace, typename Visit>
void Fits::for_each_vertex(const ProgressCallback& progress, const Visit& visit)
{
  parallel_for_in_parts(blocks_, blocks_at_once, progress,
    [&](int block)
    {
      thread_local const auto work = std::make_unique<Workspace>();
      const int first = block * block_size, last = std::min(first + block_size, n_);
      for (int i = first; i < last; ++i)
        visit(i, rows_[block], i - first, *work);
    });
}

template<typename Visit>
void Fits::for_each_in_cluster(
  const ScaleFits& fits, const ProgressCallback& progress, const Visit& visit)
{
  const int clusters = fits.clusters().size();
  const int at_once =
    std::max(least_clusters_at_once, static_cast<int>(vertices_at_once * double(clusters) / n_));
  parallel_for_in_parts(clusters, at_once, progress,
    [&](int cluster)
    {
      thread_local const auto work = std::make_unique<ScaleFits::Workspace>();
      fits.begin(cluster, *work);
      for (const int i : fits.clusters()[cluster])
        visit(i, *work);
    });
}

void Fits::fit_at_scale(const ScaleFits& fits, const ProgressCallback& progress)
{
  constexpr int degree = 2;
  for_each_in_cluster(fits, progress,
    [&](int i, ScaleFits::Workspace& work)
    {
      if (fits.fit(i, work))
        write(i, degree, work.fit, work.fit.mean_error());
    });
}

void Fits::fit_to_nearest(const ProgressCallback& progress)
{
  const NearestFits fits(mesh_, connectivity_, result_.border);
  for_each_vertex<NearestFits::Workspace>(progress,
    [&](int i, LaplacianRows& rows, int, NearestFits::Workspace& work)
    {
      if (const int degree = result_.degree[i] > 0 ? 0 : fits.fit(i, work); degree > 0)
      {
        const auto row = work.fit.laplacian(work.patch);
        rows.add(work.search.found(), row);
        write(i, degree, work.fit, work.fit.mean_error(row));
      }
      rows.end_row();
    });
}

void Fits::add_laplacian(const ScaleFits* at_scale, const ProgressCallback& progress)
{
  Curvature& c = result_.curvature;
  if (at_scale)
    for_each_in_cluster(*at_scale, part_of(progress, 0, 0.9),
      [&](int i, ScaleFits::Workspace& work)
      { c.laplacian_mean[i] = at_scale->laplacian(i, c.normal.row(i), c.mean, work); });
  struct Nothing
  {
  };
  for_each_vertex<Nothing>(part_of(progress, at_scale ? 0.9 : 0, 1),
    [&](int i, const LaplacianRows& rows, int row, Nothing&)
    {
      if (!rows.is_empty(row) || !at_scale)
        c.laplacian_mean[i] = rows.times(row, c.mean, c.mean[i]);
    });
}

void require_sense(double radius, const Points& points)
{
  const double most =
    points.rows() > 0 ? (points.colwise().maxCoeff() - points.colwise().minCoeff()).norm() / 2 : 0;
  if (radius > most && points.rows() > 0)
    throw InputError(
      fmt::format("a fit radius of {:g} is too large for the mesh, half the diagonal of "
                  "whose box is {:.3g}: take one below its radii of curvature",
        radius, most));
}

}

FittedCurvature fitted_curvature(const TriangleMesh& mesh, const Connectivity& connectivity,
  const FitOptions& options, const ProgressCallback& progress)
{
  require_sense(options.radius, mesh.points);
  Fits fits(mesh, connectivity);
  std::optional<ScaleFits> at_scale;
  if (options.radius > 0)
  {
    at_scale.emplace(mesh, connectivity, options.radius, part_of(progress, 0, 0.1));
    fits.fit_at_scale(*at_scale, part_of(progress, 0.1, 0.6));
  }
  fits.fit_to_nearest(part_of(progress, at_scale ? 0.6 : 0, at_scale ? 0.65 : 0.95));
  if (options.laplacian)
    fits.add_laplacian(
      at_scale ? &*at_scale : nullptr, part_of(progress, at_scale ? 0.65 : 0.95, 1));
  return std::move(fits).result();
}

FittedCurvature fitted_curvature(const TriangleMesh& mesh)
{
  return fitted_curvature(mesh, Connectivity(mesh.triangles, static_cast<int>(mesh.points.rows())));
}

}
