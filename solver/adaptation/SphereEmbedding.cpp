#include "solver/adaptation/SphereEmbedding.h"

#include "solver/Errors.h"
#include "solver/mesh/EdgeUses.h"
#include "solver/linear/SparseCholesky.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <cmath>
#include <numbers>
#include <optional>

namespace vesicle
{

namespace
{

using Matrix3 = Eigen::Matrix3d;
using Triplets = std::vector<Eigen::Triplet<double>>;

double triangle_area(const Points& points, const Triangles& triangles, Eigen::Index t)
{
  const Vector3 a = points.row(triangles(t, 0)), b = points.row(triangles(t, 1)),
                c = points.row(triangles(t, 2));
  return (b - a).cross(c - a).norm() / 2;
}

// ∮ ∇N_j·∇N_k dS of flat triangles. Negative cotangents, of obtuse angles, let triangles fold: they
// count as small ones.
SymmetricMatrix stiffness(const TriangleMesh& mesh)
{
  constexpr double least_cotangent = 0.05;
  Triplets entries;
  for (const auto t : mesh.triangles.rowwise())
    for (int k = 0; k < 3; ++k)
    {
      const int a = t[(k + 1) % 3], b = t[(k + 2) % 3];
      const Vector3 p = (mesh.points.row(a) - mesh.points.row(t[k])).transpose(),
                    q = (mesh.points.row(b) - mesh.points.row(t[k])).transpose();
      const double w = std::max(least_cotangent, p.dot(q) / p.cross(q).norm()) / 2;
      entries.emplace_back(a, a, w);
      entries.emplace_back(b, b, w);
      entries.emplace_back(a, b, -w);
      entries.emplace_back(b, a, -w);
    }
  SymmetricMatrix L(mesh.points.rows(), mesh.points.rows());
  L.setFromTriplets(entries.begin(), entries.end());
  return L;
}

SymmetricMatrix mass(const Points& points, const Triangles& triangles)
{
  Triplets entries;
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
  {
    const double area = triangle_area(points, triangles, t);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        entries.emplace_back(triangles(t, i), triangles(t, j), area / (i == j ? 6 : 12));
  }
  SymmetricMatrix M(points.rows(), points.rows());
  M.setFromTriplets(entries.begin(), entries.end());
  return M;
}

// About their centroid, with the area of the unit sphere.
void normalise(Points& points, const Triangles& triangles)
{
  double sum = 0;
  Eigen::RowVector3d center = Eigen::RowVector3d::Zero();
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
  {
    const double area = triangle_area(points, triangles, t);
    sum += area;
    for (int k = 0; k < 3; ++k)
      center += area / 3 * points.row(triangles(t, k));
  }
  points.rowwise() -= center / sum;
  points *= std::sqrt(4 * std::numbers::pi / sum);
}

}

SphereEmbedding::SphereEmbedding(const TriangleMesh& mesh, const Eigen::VectorXd& weights)
  : triangles_(mesh.triangles), across_(triangles_across(mesh.triangles))
{
  find_directions(mesh);
  balance(weights);
  turn(weights);
  require_no_fold();
}

void SphereEmbedding::find_directions(const TriangleMesh& mesh)
{
  constexpr int most_steps = 60;
  constexpr double step = 0.5, round_enough = 1e-3;
  directions_ = mesh.points;
  normalise(directions_, triangles_);
  const SymmetricMatrix L = stiffness(mesh);
  SparseCholesky factors;
  for (int k = 0; k < most_steps; ++k)
  {
    const SymmetricMatrix M = mass(directions_, triangles_);
    factors.compute(M + step * L);
    if (!factors.regular())
      throw NumericalError("the mesh can't be spread over a sphere");
    directions_ = factors.solve(M * directions_).eval();
    normalise(directions_, triangles_);
    const Eigen::VectorXd radii = directions_.rowwise().norm();
    if (radii.maxCoeff() - radii.minCoeff() < round_enough)
      break;
  }
  directions_.rowwise().normalize();
}

void SphereEmbedding::balance(const Eigen::VectorXd& weights)
{
  constexpr int most_steps = 50;
  constexpr double balanced = 1e-10, longest = 0.7;
  const Eigen::VectorXd share = weights / weights.sum();
  for (int k = 0; k < most_steps; ++k)
  {
    const Vector3 mean = directions_.transpose() * share;
    if (mean.norm() < balanced)
      break;
    const Matrix3 jacobian =
      2 * (Matrix3::Identity() - directions_.transpose() * share.asDiagonal() * directions_);
    Vector3 c = -jacobian.inverse() * mean;
    if (c.norm() > longest)
      c *= longest / c.norm();
    for (auto d : directions_.rowwise())
    {
      const Vector3 moved = d.transpose() + c;
      d = ((1 - c.squaredNorm()) / moved.squaredNorm() * moved + c).transpose().normalized();
    }
  }
}

void SphereEmbedding::turn(const Eigen::VectorXd& weights)
{
  const Matrix3 second =
    directions_.transpose() * (weights / weights.sum()).asDiagonal() * directions_;
  const Eigen::SelfAdjointEigenSolver<Matrix3> solver(second);
  const Eigen::Vector3d& values = solver.eigenvalues();
  const int along = values[2] - values[1] > values[1] - values[0] ? 2 : 0;
  Matrix3 axes;
  axes.col(2) = solver.eigenvectors().col(along);
  axes.col(0) = solver.eigenvectors().col(2 - along);
  axes.col(1) = axes.col(2).cross(axes.col(0));
  directions_ = (directions_ * axes).eval();
}

void SphereEmbedding::require_no_fold() const
{
  for (const auto t : triangles_.rowwise())
  {
    const Vector3 a = directions_.row(t[0]), b = directions_.row(t[1]), c = directions_.row(t[2]);
    if (!(a.dot(b.cross(c)) > 0))
      throw NumericalError("the mesh folds over where it is spread over a sphere");
  }
}

void SphereEmbedding::permute_axes()
{
  directions_ = (directions_ * Eigen::PermutationMatrix<3>(Eigen::Vector3i(2, 0, 1))).eval();
}

// Of a direction on a triangle of directions; negative ones outside.
Vector3 SphereEmbedding::weights(int element, const Vector3& direction) const
{
  Matrix3 corners;
  for (int k = 0; k < 3; ++k)
    corners.col(k) = directions_.row(triangles_(element, k)).transpose();
  return corners.inverse() * direction;
}

SurfacePlace SphereEmbedding::place(const Vector3& direction, int start) const
{
  const auto count = static_cast<int>(triangles_.rows());
  int element = start;
  for (int walked = 0; walked < count; ++walked)
  {
    const Vector3 w = weights(element, direction);
    int c = 0;
    if (w.minCoeff(&c) >= 0)
      return { element, w / w.sum() };
    element = across_[element][c];
  }
  // Walks may go in circles, and rounding may leave gaps between small triangles.
  constexpr double widest_gap = 1e-3; // of a triangle
  double best = -widest_gap;
  std::optional<SurfacePlace> nearest;
  for (element = 0; element < count; ++element)
  {
    const Vector3 w = weights(element, direction);
    if (const Vector3 share = w / w.sum(); w.sum() > 0 && share.minCoeff() > best)
    {
      best = share.minCoeff();
      nearest = { element, share.cwiseMax(0) / share.cwiseMax(0).sum() };
    }
  }
  if (nearest)
    return *nearest;
  throw NumericalError("a direction isn't covered by the mesh that is spread over the sphere");
}

}
