#include "solver/surface/FittedCurvature.h"

#include "solver/ParallelFor.h"
#include "solver/mesh/Connectivity.h"
#include "solver/mesh/LeastSquares.h"
#include "solver/mesh/VertexNormals.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace vesicle
{

namespace
{

using Row3 = Eigen::RowVector3d;

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
// Terms that the neighbours don't tell apart (of columns of unit length): a lower degree then.
constexpr double rank_threshold = 1e-6;

/// What a vertex is fitted to: other vertices near it along the surface.
struct Neighbourhood
{
  std::vector<int> vertex;
  Points offset;          ///< from the vertex
  Eigen::VectorXd weight; ///< square roots of the weights: factors of the rows
  double size = 0;        ///< σ, the root mean square distance of the nearest ones
  double edge = 0;        ///< mean length of the edges at the vertex
};

/// z(x, y) over the plane of the frame's first two rows, by its derivatives at the vertex.
struct HeightFit
{
  Eigen::Matrix3d frame;                              ///< rows: x, y, z
  Eigen::Vector<double, 5> slope;                     ///< z_x, z_y, z_xx, z_xy, z_yy
  Eigen::Matrix<double, 5, Eigen::Dynamic> operation; ///< neighbours' values → these derivatives
  double residual = 0;
};

struct VertexFit
{
  int degree = 0;
  Vector3 normal = Vector3::Zero();
  double mean = 0, gauss = 0, residual = 0;
  std::vector<int> neighbour;
  Eigen::VectorXd laplacian; ///< Δ_s f = Σ laplacian_k (f(neighbour_k) − f(vertex))
};

std::vector<char> border_vertices(const Connectivity& connectivity, int points)
{
  std::vector<char> border(points, 0);
  for (std::size_t e = 0; e < connectivity.edges.size(); ++e)
  {
    if (connectivity.edge_triangles[e] != 2)
    {
      border[connectivity.edges[e][0]] = border[connectivity.edges[e][1]] = 1;
    }
  }
  return border;
}

class Fitter
{
public:
  explicit Fitter(const TriangleMesh& m)
    : mesh_(m), connectivity_(m.triangles, static_cast<int>(m.points.rows())),
      normal_(vertex_normals(m.points, m.triangles)),
      border_(border_vertices(connectivity_, static_cast<int>(m.points.rows())))
  {
  }

  const std::vector<char>& border() const { return border_; }
  VertexFit fit(int i) const;

private:
  std::vector<int> next_ring(
    int i, const std::vector<int>& ring, const std::vector<int>& seen, double least_cosine) const;
  std::vector<int> rings(int i) const;
  Neighbourhood neighbourhood(int i) const;

  const TriangleMesh& mesh_;
  Connectivity connectivity_;
  Points normal_;
  std::vector<char> border_;
};

/// Neighbours of `ring` that aren't in `seen` (both ascending) and face as vertex i does.
std::vector<int> Fitter::next_ring(
  int i, const std::vector<int>& ring, const std::vector<int>& seen, double least_cosine) const
{
  std::vector<int> reached, fresh;
  for (int k : ring)
  {
    std::copy_if(connectivity_.vertex_neighbours.begin(k), connectivity_.vertex_neighbours.end(k),
      std::back_inserter(reached),
      [&](int j)
      { return !normal_.row(j).isZero(0) && normal_.row(j).dot(normal_.row(i)) >= least_cosine; });
  }
  std::sort(reached.begin(), reached.end());
  reached.erase(std::unique(reached.begin(), reached.end()), reached.end());
  std::set_difference(
    reached.begin(), reached.end(), seen.begin(), seen.end(), std::back_inserter(fresh));
  return fresh;
}

std::vector<int> Fitter::rings(int i) const
{
  std::vector<int> seen{ i }, ring{ i };
  for (int count = 0; count < most_rings && !ring.empty() &&
       (count < fewest_rings || static_cast<int>(seen.size()) <= wanted_neighbours);
       ++count)
  {
    ring = next_ring(i, ring, seen, count == 0 ? -1 : least_normal_cosine);
    std::vector<int> merged;
    std::merge(seen.begin(), seen.end(), ring.begin(), ring.end(), std::back_inserter(merged));
    seen = std::move(merged);
  }
  seen.erase(std::find(seen.begin(), seen.end(), i));
  return seen;
}

/// Root mean square of the smallest distances.
double local_size(const Points& offset)
{
  Eigen::VectorXd squares = offset.rowwise().squaredNorm();
  std::sort(squares.begin(), squares.end());
  const auto count = std::min<Eigen::Index>(size_neighbours, squares.size());
  return count > 0 ? std::sqrt(squares.head(count).mean()) : 0;
}

Neighbourhood Fitter::neighbourhood(int i) const
{
  Neighbourhood patch;
  patch.vertex = rings(i);
  patch.offset = mesh_.points(patch.vertex, Eigen::all).rowwise() - mesh_.points.row(i);
  patch.size = local_size(patch.offset);
  const double decay = border_[i] ? border_decay : inner_decay;
  patch.weight = patch.offset.rowwise().squaredNorm();
  patch.weight = (-0.5 * decay / (patch.size * patch.size) * patch.weight.array()).exp();
  const auto& neighbours = connectivity_.vertex_neighbours;
  for (const int* j = neighbours.begin(i); j != neighbours.end(i); ++j)
  {
    patch.edge += (mesh_.points.row(*j) - mesh_.points.row(i)).norm() / neighbours.size(i);
  }
  return patch;
}

/// Degree 1 stands for the second-order terms alone: the tangent plane is the area-weighted
/// normal's.
int lowest_order(int degree)
{
  return degree == 1 ? 2 : 1;
}

int highest_order(int degree)
{
  return std::max(degree, 2);
}

int unknowns(int degree)
{
  return degree == 1 ? 3 : (degree + 1) * (degree + 2) / 2 - 1;
}

/// x, y, x², xy, y², x³ … of each row's point.
Eigen::MatrixXd monomials(const Points& local, int degree)
{
  Eigen::MatrixXd values(local.rows(), unknowns(degree));
  int column = 0;
  for (int order = lowest_order(degree); order <= highest_order(degree); ++order)
  {
    for (int j = 0; j <= order; ++j)
    {
      values.col(column++) = local.col(0).array().pow(order - j) * local.col(1).array().pow(j);
    }
  }
  return values;
}

/// From the coefficients of the monomials in x/σ, y/σ to f_x, f_y, f_xx, f_xy, f_yy.
Eigen::Matrix<double, 5, Eigen::Dynamic> derivatives(int degree, double size)
{
  Eigen::Matrix<double, 5, Eigen::Dynamic> d =
    Eigen::Matrix<double, 5, Eigen::Dynamic>::Zero(5, unknowns(degree));
  const int second = degree == 1 ? 0 : 2;
  if (degree > 1)
  {
    d(0, 0) = d(1, 1) = 1 / size;
  }
  d(2, second) = d(4, second + 2) = 2 / (size * size);
  d(3, second + 1) = 1 / (size * size);
  return d;
}

/// Second-order terms can't follow a sphere far. z ρ²/d² has the same second derivatives at the
/// vertex (in its tangent frame) and makes them exact on a sphere, where 2z/d² is the curvature at
/// any distance d.
Eigen::VectorXd heights(const Points& local, int degree)
{
  Eigen::VectorXd z = local.col(2);
  for (Eigen::Index k = 0; degree <= 2 && k < z.size(); ++k)
  {
    const double d2 = local.row(k).squaredNorm();
    z[k] *= d2 > 0 ? local.row(k).head<2>().squaredNorm() / d2 : 0;
  }
  return z;
}

Eigen::Matrix3d frame_of(const Vector3& normal)
{
  Eigen::Matrix3d frame;
  const Vector3 x = normal.unitOrthogonal();
  frame << x.transpose(), normal.cross(x).transpose(), normal.transpose();
  return frame;
}

/// False where the neighbours don't determine all the terms.
bool fit_height(const Neighbourhood& patch, const Vector3& normal, int degree, HeightFit& fit)
{
  fit.frame = frame_of(normal);
  const Points local = patch.offset * fit.frame.transpose() / patch.size;
  Eigen::MatrixXd A = patch.weight.asDiagonal() * monomials(local, degree);
  const Eigen::VectorXd scale = A.colwise().norm().cwiseMax(1e-300);
  A = A * scale.cwiseInverse().asDiagonal(); // needles: x and y of very different lengths
  const auto [inverse, rank] = least_norm(A, patch.weight.asDiagonal(), rank_threshold);
  if (degree > 1 && rank < A.cols())
  {
    return false;
  }
  const Eigen::VectorXd z = patch.size * heights(local, degree);
  fit.operation = derivatives(degree, patch.size) * scale.cwiseInverse().asDiagonal() * inverse;
  fit.slope = fit.operation * z;
  fit.residual = (patch.weight.asDiagonal() * z - A * (inverse * z)).norm() / patch.weight.norm();
  return fit.slope.allFinite() && fit.operation.allFinite();
}

/// Monge patch: H = −½ g^{ab} z_ab/√g, K = det z_ab/g², and
/// Δ_s f = (1/√g) ∂_a(√g g^{ab} ∂_b f) = g^{ab} (f_ab − z_ab ∇z·∇f/g), exact for the polynomials.
VertexFit surface_at(const HeightFit& height)
{
  const auto& [frame, slope, operation, residual] = height;
  const double zx = slope[0], zy = slope[1], zxx = slope[2], zxy = slope[3], zyy = slope[4];
  const double g = 1 + zx * zx + zy * zy; // determinant of the metric
  const double gxx = (1 + zy * zy) / g, gxy = -zx * zy / g, gyy = (1 + zx * zx) / g; // its inverse
  const double turn = gxx * zxx + 2 * gxy * zxy + gyy * zyy;
  VertexFit fit;
  fit.normal = frame.transpose() * Vector3(-zx, -zy, 1).normalized();
  fit.mean = -0.5 * turn / std::sqrt(g);
  fit.gauss = (zxx * zyy - zxy * zxy) / (g * g);
  Eigen::RowVector<double, 5> weights;
  weights << -turn * zx / g, -turn * zy / g, gxx, 2 * gxy, gyy;
  fit.laplacian = (weights * operation).transpose();
  return fit;
}

/// Fewest neighbours for a fit: with exactly as many as unknowns, terms of order three and four
/// would follow every error.
int needed_neighbours(int degree)
{
  return degree <= 1 ? 1 : degree == 2 ? unknowns(2) : unknowns(degree) * 5 / 4;
}

VertexFit Fitter::fit(int i) const
{
  if (normal_.row(i).isZero(0))
  {
    return {}; // no triangle, only degenerate ones, or two that cancel
  }
  Neighbourhood patch = neighbourhood(i);
  HeightFit height;
  for (int degree = 4; degree >= 1; --degree)
  {
    if (static_cast<int>(patch.vertex.size()) >= needed_neighbours(degree) &&
      fit_height(patch, normal_.row(i).transpose(), degree, height))
    {
      VertexFit fit = surface_at(height);
      fit.degree = degree;
      fit.residual = height.residual / patch.edge;
      fit.neighbour = std::move(patch.vertex);
      return fit;
    }
  }
  return {};
}

FittedCurvature zeros(int n)
{
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(n);
  return { { Points::Zero(n, 3), zero, zero, zero }, zero, Eigen::VectorXi::Zero(n), {} };
}

/// The second fit's Laplacian at the vertex, of the nodal values f.
double laplacian(const VertexFit& fit, const Eigen::VectorXd& f, double at_vertex)
{
  double sum = 0;
  for (std::size_t k = 0; k < fit.neighbour.size(); ++k)
  {
    sum += fit.laplacian[static_cast<Eigen::Index>(k)] * (f[fit.neighbour[k]] - at_vertex);
  }
  return sum;
}

}

FittedCurvature fitted_curvature(const TriangleMesh& mesh)
{
  const int n = static_cast<int>(mesh.points.rows());
  const Fitter fitter(mesh);
  FittedCurvature result = zeros(n);
  result.border = fitter.border();
  Curvature& curvature = result.curvature;
  std::vector<VertexFit> fits(n);
  parallel_for(n,
    [&](int i)
    {
      const VertexFit& fit = fits[i] = fitter.fit(i);
      curvature.normal.row(i) = fit.normal.transpose();
      curvature.mean[i] = fit.mean;
      curvature.gauss[i] = fit.gauss;
      result.residual[i] = fit.residual;
      result.degree[i] = fit.degree;
    });
  parallel_for(n,
    [&](int i)
    { curvature.laplacian_mean[i] = laplacian(fits[i], curvature.mean, curvature.mean[i]); });
  return result;
}

}
