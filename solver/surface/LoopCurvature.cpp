#include "solver/surface/LoopCurvature.h"

#include "solver/surface/LoopBasis.h"
#include "solver/surface/WeakForms.h"

#include <Eigen/IterativeLinearSolvers>

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

namespace vesicle
{

namespace
{

// Elements that a thread evaluates at once, and how many such blocks are kept until they are added
// up.
constexpr int block_size = 64, blocks_at_once = 64;

/// A⁻¹ b of a symmetric, well-conditioned matrix, by conjugate gradients: 30 to 100 iterations for
/// the matrices here, whatever their size.
Eigen::MatrixXd solve(const SparseMatrix& A, const Eigen::MatrixXd& b)
{
  constexpr double tolerance = 1e-14; // of the residual
  Eigen::MatrixXd x(b.rows(), b.cols());
  parallel_for(static_cast<int>(b.cols()),
    [&](int j)
    {
      // One for each column: it counts its iterations as it solves.
      Eigen::ConjugateGradient<SparseMatrix, Eigen::Lower | Eigen::Upper> gradients(A);
      gradients.setTolerance(tolerance);
      x.col(j) = gradients.solve(b.col(j));
    });
  return x;
}

/// P⁻¹ x, with P = diag(scale) S.
Points control_points(const LoopBasis& basis, const SparseMatrix& P, const Points& vertices)
{
  const Eigen::VectorXd unscale = basis.collocation_scale().cwiseInverse();
  return solve(unscale.asDiagonal() * P, unscale.asDiagonal() * vertices);
}

/// The surface at the quadrature points of some elements.
struct Piece
{
  Piece(const LoopBasis& basis, const Points& control, int first, int last)
    : table(basis.tabulate(
        basis.rule(triangle_rule(LoopBasis::rule_points), LoopBasis::rule_grading, first, last))),
      points(evaluate(table, control)), curvature(point_curvature(table, points, control))
  {
  }

  BasisTable table;
  SurfacePoints points;
  PointCurvature curvature;
};

/// Integrals over the surface, added up piece by piece.
class Projection
{
public:
  explicit Projection(const LoopBasis& basis)
    : pattern_(basis.tabulate(basis.rule(triangle_rule(1), 0))), mass_(pattern_),
      moments_(Eigen::MatrixXd::Zero(basis.nodes(), 3))
  {
  }

  /// The piece begins with element `first`.
  void add(const Piece& piece, int first)
  {
    add_moments(piece.table, piece.points, piece.curvature.mean, moments_.col(0));
    add_moments(piece.table, piece.points, piece.curvature.gauss, moments_.col(1));
    add_bending_moments(piece.table, piece.points, piece.curvature, 0, moments_.col(2));
    for_each_element(piece.table,
      [&](int begin, int end, std::span<const int>)
      {
        mass_.begin(pattern_.elements()[first++]);
        for (int q = begin; q < end; ++q)
        {
          const double* value = piece.table.value.data() + piece.table.start[q];
          mass_.add_outer_product(piece.points.area_weight[q], value, value);
        }
        mass_.end();
      });
  }

  /// H, K and the bending force of the control points.
  Eigen::MatrixXd result() const { return solve(mass_.matrix(), moments_); }

private:
  ElementPattern pattern_;
  ElementSum<1, 1> mass_;
  Eigen::MatrixXd moments_;
};

}

Curvature loop_curvature(const TriangleMesh& mesh, const ProgressCallback& progress)
{
  const LoopBasis basis(mesh.triangles, static_cast<int>(mesh.points.rows()));
  const SparseMatrix P = basis.collocation();
  const Points control = control_points(basis, P, mesh.points);
  const auto tell = [&](double share)
  {
    if (progress)
      progress(share);
  };
  tell(0.1);
  Projection projection(basis);
  tell(0.2);
  const int elements = static_cast<int>(mesh.triangles.rows());
  for (int first = 0; first < elements; first += block_size * blocks_at_once)
  {
    const int last = std::min(first + block_size * blocks_at_once, elements);
    const int blocks = (last - first + block_size - 1) / block_size;
    std::vector<std::optional<Piece>> pieces(blocks);
    const auto first_of = [&](int block) { return std::min(first + block * block_size, last); };
    parallel_for(blocks,
      [&](int block)
      { pieces[block].emplace(basis, control, first_of(block), first_of(block + 1)); });
    for (int block = 0; block < blocks; ++block)
      projection.add(*pieces[block], first_of(block));
    tell(0.2 + 0.6 * last / elements);
  }
  const Eigen::MatrixXd at_vertices = P * projection.result();
  Curvature c;
  c.normal = basis.vertex_normals(control);
  c.mean = at_vertices.col(0);
  c.gauss = at_vertices.col(1);
  c.laplacian_mean = laplacian_of_mean(at_vertices.col(2), c.mean, c.gauss);
  return c;
}

}
