#include "solver/mesh/remesh/FittedNormals.h"

#include "solver/mesh/Connectivity.h"
#include "solver/mesh/LeastSquares.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <vector>

namespace vesicle
{

namespace
{
constexpr int fewest_neighbours = 7; // two more than the quadratic's five coefficients
/// A neighbour whose normal differs by more than 60° isn't on the same graph over the tangent
/// plane.
constexpr double same_side = 0.5;
/// A fit that turns the average normal by more than 30° (cosine) answers noise or a sharp edge.
constexpr double trusted_turn = 0.866;

/// Triangle normals weighted by sin α/(|e1| |e2|): exact on a sphere (N. Max, J. Graphics Tools 4
/// (1999), no. 2, 1–6).
Points average_normals(const TriangleMesh& mesh)
{
  Points sum = Points::Zero(mesh.points.rows(), 3);
  for (const auto triangle : mesh.triangles.rowwise())
    for (int k = 0; k < 3; ++k)
    {
      const Vector3 at = mesh.points.row(triangle[k]);
      const Vector3 left = mesh.points.row(triangle[(k + 1) % 3]).transpose() - at;
      const Vector3 right = mesh.points.row(triangle[(k + 2) % 3]).transpose() - at;
      sum.row(triangle[k]) += left.cross(right) / (left.squaredNorm() * right.squaredNorm());
    }
  return sum.rowwise().normalized();
}

class NormalFit
{
public:
  explicit NormalFit(const TriangleMesh& mesh)
    : mesh_(mesh), connectivity_(mesh.triangles, static_cast<int>(mesh.points.rows())),
      averages_(average_normals(mesh))
  {
  }
  Vector3 normal(int i) const;

private:
  std::vector<int> two_ring(int i) const;

  const TriangleMesh& mesh_;
  Connectivity connectivity_;
  Points averages_;
};

/// The vertices within two edges of i that face as i does.
std::vector<int> NormalFit::two_ring(int i) const
{
  const AdjacencyList& around = connectivity_.vertex_neighbours;
  std::vector<int> ring;
  for (const int* j = around.begin(i); j != around.end(i); ++j)
  {
    ring.push_back(*j);
    ring.insert(ring.end(), around.begin(*j), around.end(*j));
  }
  std::ranges::sort(ring);
  ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
  std::erase_if(
    ring, [&](int j) { return j == i || averages_.row(i).dot(averages_.row(j)) < same_side; });
  return ring;
}

/// The principal axes of points in the plane, by their second moments, each divided by the extent
/// along it: points times this spread by one in all directions.
Eigen::Matrix2d unit_spread(const Eigen::Matrix2d& moments)
{
  // What SelfAdjointEigenSolver::compute does with a matrix of two rows, which is tridiagonal as it
  // is; it would compile the way there for seconds.
  const double largest = std::max({ moments(0, 0), std::abs(moments(1, 0)), moments(1, 1) });
  const double scale = largest > 0 ? largest : 1;
  const Eigen::Vector2d diagonal = moments.diagonal() / scale;
  const Eigen::Vector<double, 1> below(moments(1, 0) / scale);
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
  solver.computeFromTridiagonal(diagonal, below);
  const Eigen::Vector2d squares = solver.eigenvalues() * scale;
  return solver.eigenvectors() *
    squares.cwiseMax(1e-12 * squares[1]).cwiseSqrt().cwiseInverse().asDiagonal();
}

/// Least squares for w = c0 s + c1 t + c2 s² + c3 s t + c4 t² in the coordinates s, t along the
/// ring's principal axes, scaled by its extents, so that long thin rings are fitted as well as
/// round ones; w is the height above the average normal's plane. Near points count more: weight
/// 1/d.
Vector3 NormalFit::normal(int i) const
{
  Vector3 up = averages_.row(i);
  const std::vector<int> ring = two_ring(i);
  const int count = static_cast<int>(ring.size());
  if (count < fewest_neighbours)
    return up;
  Eigen::Matrix<double, 3, 2> plane;
  plane.col(0) = up.unitOrthogonal();
  plane.col(1) = up.cross(plane.col(0));
  const Points offsets = mesh_.points(ring, Eigen::all).rowwise() - mesh_.points.row(i);
  const Eigen::Matrix<double, Eigen::Dynamic, 2> flat = offsets * plane;
  const Eigen::Matrix2d scale = unit_spread(flat.transpose() * flat / count);
  const Eigen::Matrix<double, Eigen::Dynamic, 2> st = flat * scale;
  Eigen::Matrix<double, Eigen::Dynamic, 5> terms(count, 5);
  terms << st, st.col(0).array().square().matrix(), st.col(0).cwiseProduct(st.col(1)),
    st.col(1).array().square().matrix();
  const Eigen::ArrayXd weight = st.rowwise().norm().array().max(1e-6).inverse();
  const Eigen::VectorXd heights = offsets * up;
  const auto coefficients =
    least_squares(weight.matrix().asDiagonal() * terms, weight * heights.array());
  if (!coefficients)
    return up;
  const Vector3 fitted = (up - plane * scale * coefficients->head<2>()).normalized();
  return fitted.dot(up) >= trusted_turn ? fitted : up;
}
}

Points fitted_normals(const TriangleMesh& mesh)
{
  const NormalFit fit(mesh);
  Points normals(mesh.points.rows(), 3);
  for (int i = 0; i < normals.rows(); ++i)
    normals.row(i) = fit.normal(i);
  return normals;
}

}
