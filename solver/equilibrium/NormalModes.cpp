#include "solver/equilibrium/NormalModes.h"

#include "solver/Errors.h"
#include "solver/equilibrium/BorderedSystem.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace vesicle
{

namespace
{

// Eigenvalues come in pairs where the shape is axisymmetric, and in fours where it is nearly a sphere's
// next relative: a block has that many vectors. Twelve blocks have the six lowest to 1e-6.
constexpr int block = 4, blocks = 12;
// A rotation about the axis of an axisymmetric shape has no normal part but the mesh's error.
constexpr double least_normal_part = 0.05;

/// Numbers in [−1, 1] that look random and are always the same.
Eigen::MatrixXd scattered(Eigen::Index rows, Eigen::Index columns)
{
  Eigen::MatrixXd X(rows, columns);
  for (Eigen::Index k = 0; k < columns; ++k)
    for (Eigen::Index i = 0; i < rows; ++i)
      X(i, k) =
        std::sin(1 + 12.9898 * static_cast<double>(i) + 78.233 * static_cast<double>(k * k));
  return X;
}

/// ∮ ψ² dS by displacements along the vertices' normals: N by N. Its root has the table's entries.
SparseMatrix normal_mass(const EnergyPoint& point, const BasisTable& table)
{
  const SurfacePoints& s = point.surface.points;
  SparseMatrix root(table.rows(), table.nodes);
  root.resizeNonZeros(static_cast<Eigen::Index>(table.node.size()));
  std::ranges::copy(table.start, root.outerIndexPtr());
  std::ranges::copy(table.node, root.innerIndexPtr());
  for (int q = 0; q < table.rows(); ++q)
  {
    const Eigen::RowVector3d n = s.cross.row(q).normalized() * std::sqrt(s.area_weight[q]);
    for (int k = table.start[q]; k < table.start[q + 1]; ++k)
      root.valuePtr()[k] = table.value[k] * n.dot(point.frames.row(table.node[k]).head<3>());
  }
  return SparseMatrix(root.transpose()) * root;
}

/// Columns with Xᵀ M X = 1 that span the same, less what they have in common with V's, which are
/// such columns; twice, for the rounding that is left of it.
Eigen::MatrixXd orthonormal(Eigen::MatrixXd X, const Eigen::MatrixXd& V, const SparseMatrix& mass)
{
  for (int pass = 0; pass < 2; ++pass)
  {
    X -= V * (V.transpose() * (mass * X)).eval();
    const Eigen::MatrixXd gram = X.transpose() * (mass * X);
    X = Eigen::LLT<Eigen::MatrixXd>(gram).matrixL().solve(X.transpose()).transpose().eval();
  }
  return X;
}

}

Eigen::SparseMatrix<double> normal_part(const Eigen::SparseMatrix<double>& hessian)
{
  const Eigen::Index n = hessian.cols() / 3;
  std::vector<Eigen::Triplet<double>> entries;
  for (int k = 0; k < n; ++k)
    for (Eigen::SparseMatrix<double>::InnerIterator it(hessian, 3 * k); it; ++it)
      if (it.row() % 3 == 0)
        entries.emplace_back(static_cast<int>(it.row() / 3), k, it.value());
  Eigen::SparseMatrix<double> result(n, n);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

NormalBorder normal_border(const EnergyPoint& point)
{
  const Eigen::MatrixXd rigid = point.rigid_motion();
  std::vector<Eigen::VectorXd> columns;
  const auto normal = [](const Eigen::VectorXd& v) -> Eigen::VectorXd
  { return v(Eigen::seq(0, Eigen::last, 3)); };
  columns.push_back(normal(point.area_gradient));
  columns.push_back(normal(point.volume_gradient));
  for (int k = 0; k < rigid.cols(); ++k)
    if (Eigen::VectorXd column = normal(rigid.col(k));
        column.norm() > least_normal_part * rigid.col(k).norm())
      columns.push_back(column);
  const auto constraints = static_cast<Eigen::Index>(columns.size());
  if (point.mean_gradient.size() > 0)
    columns.push_back(normal(point.mean_gradient));
  NormalBorder border{ Eigen::MatrixXd(columns.front().size(), columns.size()),
    Eigen::VectorXd::Zero(static_cast<Eigen::Index>(columns.size())) };
  for (std::size_t k = 0; k < columns.size(); ++k)
    border.columns.col(static_cast<Eigen::Index>(k)) = columns[k];
  if (constraints < border.D.size())
    border.D[constraints] = 1 / point.membrane.mean_stiffness;
  return border;
}

NormalModes lowest_normal_modes(const EnergyPoint& point, const BasisTable& table,
  const Eigen::SparseMatrix<double>& hessian, int count)
{
  const Eigen::SparseMatrix<double> H = normal_part(hessian);
  const SparseMatrix mass = normal_mass(point, table);
  const SymmetricMatrix lower_mass =
    Eigen::SparseMatrix<double>(mass).triangularView<Eigen::Lower>();
  const Eigen::Index n = mass.rows();
  const NormalBorder border = normal_border(point);
  const auto times_hessian = [&](const Eigen::MatrixXd& X) -> Eigen::MatrixXd
  {
    Eigen::MatrixXd HX = H.selfadjointView<Eigen::Lower>() * X;
    for (Eigen::Index k = 0; k < border.D.size(); ++k)
      if (border.D[k] != 0)
        HX += border.columns.col(k) * (border.columns.col(k).transpose() * X) / border.D[k];
    return HX;
  };

  // Shifted so far that no eigenvalue is below 0: the lowest are then the nearest to the shift.
  BorderedSystem shifted;
  double shift = 5;
  do
  {
    shift *= 2;
    shifted.compute(H + shift * lower_mass, border.columns, border.D);
  } while (shifted.index() > 0 && shift < 1e6);

  // The Krylov space of the inverse.
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(border.columns.cols());
  const auto room = static_cast<int>(n - border.columns.cols()) / block;
  Eigen::MatrixXd V(n, 0), X = scattered(n, block);
  for (int step = 0; step < std::min(blocks, room); ++step)
  {
    const Eigen::MatrixXd MX = mass * X;
    for (Eigen::Index k = 0; k < block; ++k)
      X.col(k) = shifted.solve(MX.col(k), none).x;
    X = orthonormal(X, V, mass);
    V.conservativeResize(Eigen::NoChange, V.cols() + block);
    V.rightCols<block>() = X;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> small(V.transpose() * times_hessian(V));
  const Eigen::Index found = std::min<Eigen::Index>(count, V.cols());
  if (found == 0 || !small.eigenvalues().allFinite())
    throw NumericalError("the lowest eigenvalues of the second variation weren't found");
  return { small.eigenvalues().head(found), V * small.eigenvectors().leftCols(found) };
}

}
