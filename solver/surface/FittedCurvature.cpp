#include "solver/surface/FittedCurvature.h"

#include "solver/mesh/VertexNormals.h"
#include "solver/surface/HeightFit.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

namespace vesicle
{

namespace
{

// Measured choices: the header tells on what. Twice the 14 unknowns of a quartic through the vertex
// are asked for; on a regular mesh these are three rings, of which the weights favour two.
constexpr int fewest_rings = 2, most_rings = 8, wanted_neighbours = 28;
// The two rings of a regular vertex give the local size σ; weights are exp(−decay d²/σ²).
constexpr int size_neighbours = 18;
// On a border one-sided fits of high order amplify errors: the far neighbours must steady them.
constexpr double inner_decay = 4, border_decay = 1;
// Beyond the first ring a neighbour must face roughly as the vertex does, or the surface is no
// height over the tangent plane there.
constexpr double least_normal_cosine = 0.3;
// Vertices that a thread fits one after the other, and how many such blocks are done between two words
// of progress, some hundredths of a second.
constexpr int block_size = 256, blocks_at_once = 32;

/// What a thread keeps from a vertex to the next.
struct Workspace
{
  std::vector<unsigned> seen; ///< of each vertex: the last search that came by
  unsigned search = 0;
  std::vector<int> neighbour;
  std::vector<double> squares;
  Patch patch;
  HeightFit fit;
};

/// Of successive vertices: Δ_s f = Σ_k weight_k (f(neighbour_k) − f(vertex)), k from one start to the
/// next.
struct LaplacianRows
{
  std::vector<int> start{ 0 };
  std::vector<int> neighbour;
  std::vector<double> weight;

  double times(int row, const Eigen::VectorXd& f, double at_vertex) const
  {
    double sum = 0;
    for (int k = start[row]; k < start[row + 1]; ++k)
      sum += weight[k] * (f[neighbour[k]] - at_vertex);
    return sum;
  }
};

class Fitter
{
public:
  Fitter(
    const TriangleMesh& mesh, const Connectivity& connectivity, const std::vector<char>& border)
    : points_(mesh.points), neighbours_(connectivity.vertex_neighbours), border_(border),
      normal_(vertex_normals(mesh.points, mesh.triangles))
  {
  }

  /// Writes the vertex's values, but for Δ_s H, and appends the row that gives it.
  void fit(int i, Workspace& work, FittedCurvature& result, LaplacianRows& rows) const;

private:
  void gather(int i, Workspace& work) const;
  template<typename Accept>
  void visit(int from, Workspace& work, const Accept& accept) const;
  void describe(int i, Workspace& work) const;
  double edge_length(int i) const;

  const Points& points_;
  const AdjacencyList& neighbours_;
  const std::vector<char>& border_;
  Points normal_;
};

/// Adds those neighbours of `from` that weren't seen and that are accepted.
template<typename Accept>
void Fitter::visit(int from, Workspace& work, const Accept& accept) const
{
  for (const int* j = neighbours_.begin(from); j != neighbours_.end(from); ++j)
  {
    if (work.seen[*j] == work.search)
      continue;
    work.seen[*j] = work.search;
    if (accept(*j))
      work.neighbour.push_back(*j);
  }
}

void Fitter::gather(int i, Workspace& work) const
{
  if (++work.search == 0 || work.seen.size() != border_.size())
  {
    work.seen.assign(border_.size(), 0);
    work.search = 1;
  }
  work.seen[i] = work.search;
  std::vector<int>& found = work.neighbour;
  found.clear();
  visit(i, work, [&](int j) { return !normal_.row(j).isZero(0); });
  const Vector3 normal = normal_.row(i);
  const auto faces_likewise = [&](int j)
  { return normal_.row(j).dot(normal) >= least_normal_cosine; };
  for (std::size_t ring = 1, first = 0; ring < most_rings && first < found.size() &&
       (ring < fewest_rings || found.size() < wanted_neighbours);
       ++ring)
    for (const std::size_t last = found.size(); first < last; ++first)
      visit(found[first], work, faces_likewise);
}

/// Root mean square of the smallest distances, of which the squares are given and reordered.
double local_size(std::vector<double>& squares)
{
  const auto count = std::min<std::ptrdiff_t>(size_neighbours, std::ssize(squares));
  const auto end = squares.begin() + count;
  std::nth_element(squares.begin(), end, squares.end());
  return count > 0
    ? std::sqrt(std::accumulate(squares.begin(), end, 0.) / static_cast<double>(count))
    : 0;
}

void Fitter::describe(int i, Workspace& work) const
{
  Patch& patch = work.patch;
  const auto count = std::ssize(work.neighbour);
  patch.offset.resize(count, 3);
  work.squares.resize(count);
  for (std::ptrdiff_t k = 0; k < count; ++k)
  {
    patch.offset.row(k) = points_.row(work.neighbour[k]) - points_.row(i);
    work.squares[k] = patch.offset.row(k).squaredNorm();
  }
  patch.weight = work.squares;
  patch.size = local_size(work.squares);
  const double factor =
    -0.5 * (border_[i] ? border_decay : inner_decay) / (patch.size * patch.size);
  for (double& weight : patch.weight)
    weight = std::exp(factor * weight);
}

/// Mean length of the edges at a vertex.
double Fitter::edge_length(int i) const
{
  double sum = 0;
  for (const int* j = neighbours_.begin(i); j != neighbours_.end(i); ++j)
    sum += (points_.row(*j) - points_.row(i)).norm();
  return sum / neighbours_.size(i);
}

/// Fewest neighbours for a fit: with exactly as many as unknowns, terms of order three and four
/// would follow every error.
int needed_neighbours(int degree)
{
  const int unknowns = HeightFit::unknowns(degree);
  return degree <= 1 ? 1 : degree == 2 ? unknowns : unknowns * 5 / 4;
}

void Fitter::fit(int i, Workspace& work, FittedCurvature& result, LaplacianRows& rows) const
{
  int degree = 0;
  if (!normal_.row(i).isZero(0)) // no triangle, only degenerate ones, or two that cancel
  {
    gather(i, work);
    describe(i, work);
    const Vector3 normal = normal_.row(i);
    for (degree = 4; degree >= 1; --degree)
      if (work.patch.count() >= needed_neighbours(degree) &&
        work.fit.compute(work.patch, normal, degree))
        break;
  }
  if (degree > 0)
  {
    result.curvature.normal.row(i) = work.fit.normal();
    result.curvature.mean[i] = work.fit.mean();
    result.curvature.gauss[i] = work.fit.gauss();
    result.residual[i] = work.fit.residual() / edge_length(i);
    result.degree[i] = degree;
    const auto row = work.fit.laplacian(work.patch);
    rows.neighbour.insert(rows.neighbour.end(), work.neighbour.begin(), work.neighbour.end());
    rows.weight.insert(rows.weight.end(), row.begin(), row.end());
  }
  rows.start.push_back(static_cast<int>(rows.neighbour.size()));
}

FittedCurvature zeros(int n)
{
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(n);
  return { { Points::Zero(n, 3), zero, zero, zero }, zero, Eigen::VectorXi::Zero(n), {} };
}

}

FittedCurvature fitted_curvature(
  const TriangleMesh& mesh, const Connectivity& connectivity, const Progress& progress)
{
  const int n = static_cast<int>(mesh.points.rows());
  FittedCurvature result = zeros(n);
  result.border = border_vertices(connectivity);
  const Fitter fitter(mesh, connectivity, result.border);
  const int blocks = (n + block_size - 1) / block_size;
  std::vector<LaplacianRows> rows(blocks);
  const auto for_each_block = [&](const Progress& part, const auto& visit)
  {
    parallel_for_in_parts(blocks, blocks_at_once, part,
      [&](int block)
      { visit(rows[block], block * block_size, std::min((block + 1) * block_size, n)); });
  };
  constexpr double fits_share = 0.95;
  for_each_block(part_of(progress, 0, fits_share),
    [&](LaplacianRows& block, int first, int last)
    {
      thread_local const auto kept = std::make_unique<Workspace>();
      Workspace& work = *kept;
      for (int i = first; i < last; ++i)
        fitter.fit(i, work, result, block);
    });
  Curvature& curvature = result.curvature;
  for_each_block(part_of(progress, fits_share, 1),
    [&](const LaplacianRows& block, int first, int last)
    {
      for (int i = first; i < last; ++i)
        curvature.laplacian_mean[i] = block.times(i - first, curvature.mean, curvature.mean[i]);
    });
  return result;
}

FittedCurvature fitted_curvature(const TriangleMesh& mesh)
{
  return fitted_curvature(mesh, Connectivity(mesh.triangles, static_cast<int>(mesh.points.rows())));
}

}
