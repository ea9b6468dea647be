#include "solver/surface/FitRadius.h"

#include "solver/mesh/VertexNormals.h"
#include "solver/surface/NeighbourSearch.h"
#include "solver/surface/ScaleFit.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace vesicle
{

namespace
{

double median(std::vector<double> values)
{
  if (values.empty())
    return 0;
  const auto middle = values.begin() + std::ssize(values) / 2;
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double curvedness(double mean, double gauss)
{
  return std::sqrt(std::max(0., 2 * mean * mean - gauss));
}

/// Of some vertices.
struct Sample
{
  std::vector<double> error, curvature;

  double typical_curvature(const Points& points) const
  {
    return std::max(median(curvature), 1 / box_diagonal(points));
  }
  double typical_error(const Points& points) const
  {
    return median(error) / typical_curvature(points);
  }
};

/// Vertices spread over the mesh and their fits at one radius after the other. As they are for a
/// first judgement, they don't look which way their points face.
class SampleFits
{
public:
  SampleFits(const TriangleMesh& mesh, const Connectivity& connectivity)
    : points_(mesh.points), neighbours_(connectivity.vertex_neighbours),
      area_(vertex_area_vectors(mesh.points, mesh.triangles))
  {
    constexpr int most = 400;
    const std::vector<char> border = border_vertices(connectivity);
    const int n = static_cast<int>(points_.rows()), step = std::max(1, n / most);
    for (int i = 0; i < n; i += step)
      if (!border[i] && neighbours_.size(i) > 0)
        vertices_.push_back(i);
  }

  /// Of those vertices that have a fit: empty unless half of them have.
  Sample at(double radius) const
  {
    const auto count = vertices_.size();
    std::vector<double> error(count, -1), curvature(count, 0);
    parallel_for(count,
      [&](std::size_t k)
      {
        thread_local const auto work = std::make_unique<Workspace>();
        if (!fit(vertices_[k], radius, *work))
          return;
        error[k] = work->fit.mean_error();
        curvature[k] = curvedness(work->fit.surface().mean(), work->fit.surface().gauss());
      });
    Sample sample;
    for (std::size_t k = 0; k < count; ++k)
      if (error[k] >= 0)
      {
        sample.error.push_back(error[k]);
        sample.curvature.push_back(curvature[k]);
      }
    return 2 * sample.error.size() > count ? sample : Sample{};
  }

private:
  struct Workspace
  {
    NeighbourSearch search;
    Candidates candidates;
    ScaleFit fit;
  };

  bool fit(int i, double radius, Workspace& work) const
  {
    constexpr int fewest_points = 12;
    Vector3 sum = area_.row(i);
    work.candidates = {};
    add(i, work.candidates);
    work.search.spread(neighbours_, i,
      [&](int j)
      {
        const double square = (points_.row(j) - points_.row(i)).squaredNorm();
        if (square > radius * radius)
          return false;
        add(j, work.candidates);
        sum += (1 - square / (radius * radius)) * area_.row(j);
        return true;
      });
    const Vector3 normal = sum.normalized();
    return work.fit.choose(work.candidates, points_.row(i), normal, radius, -2) >= fewest_points &&
      work.fit.compute(normal, radius);
  }
  void add(int j, Candidates& to) const
  {
    to.x.push_back(points_(j, 0));
    to.y.push_back(points_(j, 1));
    to.z.push_back(points_(j, 2));
    for (auto* n : { &to.nx, &to.ny, &to.nz })
      n->push_back(0);
  }

  const Points& points_;
  const AdjacencyList& neighbours_;
  Points area_;
  std::vector<int> vertices_;
};

}

double typical_error(const TriangleMesh& mesh, const FittedCurvature& fit)
{
  Sample all;
  for (int i = 0; i < mesh.points.rows(); ++i)
    if (fit.degree[i] > 0 && !fit.border[i])
    {
      all.error.push_back(fit.mean_error[i]);
      all.curvature.push_back(curvedness(fit.curvature.mean[i], fit.curvature.gauss[i]));
    }
  return all.error.empty() ? 0 : all.typical_error(mesh.points);
}

// The error of noise falls as the third power of the radius.
std::optional<double> radius_for_error(
  const TriangleMesh& mesh, const Connectivity& connectivity, double wanted)
{
  constexpr double first = 2, greatest_step = 1.6, smallest_step = 1.1; // in edges, then factors
  constexpr double farthest = 0.7; // of the radius of curvature
  const SampleFits fits(mesh, connectivity);
  double radius = first * mean_edge(mesh.points, connectivity.vertex_neighbours);
  while (radius > 0 && radius < box_diagonal(mesh.points))
  {
    const Sample sample = fits.at(radius);
    double step = greatest_step;
    if (!sample.error.empty())
    {
      const double error = sample.typical_error(mesh.points);
      if (radius * sample.typical_curvature(mesh.points) > farthest)
        return std::nullopt;
      if (error <= wanted)
        return radius;
      step = std::clamp(std::cbrt(error / wanted), smallest_step, greatest_step);
    }
    radius *= step;
  }
  return std::nullopt;
}

}
