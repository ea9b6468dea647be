#include "solver/stokes/StokesletMatrix.h"

#include "solver/stokes/StokesletKernel.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <numbers>

namespace vesicle
{

namespace
{

constexpr int lanes = stokeslet_lanes;
// The Duffy rule around a node: flat elements need one radial point (exact) and, on the angle, four
// (three change the translation error on a sphere by under 1%, more than four by nothing).
constexpr int radial_points = 1, angular_points = 4;
constexpr double kernel_factor = 1 / (8 * std::numbers::pi);

using Accumulator = std::vector<double>;

Eigen::Matrix3d stokeslet(const Vector3& d)
{
  const double inverse = 1 / d.norm();
  return inverse * (Eigen::Matrix3d::Identity() + inverse * inverse * d * d.transpose());
}

}

StokesletMatrix::StokesletMatrix(const Basis& basis, int quadrature)
  : regular_(tabulate_rule(basis, triangle_rule(quadrature))),
    node_elements_(Connectivity(basis.elements(), basis.nodes()).vertex_triangles)
{
  for (int e = 0; e <= basis.elements().rows(); ++e)
    first_row_.push_back(e * quadrature);

  std::array<std::vector<TrianglePoint>, 3> rule;
  for (int corner = 0; corner < 3; ++corner)
    rule[corner] = duffy_rule(corner, radial_points, angular_points);
  std::vector<ParametricPoint> points;
  for (int i = 0; i < basis.nodes(); ++i)
  {
    singular_start_.push_back(static_cast<int>(points.size()));
    for (const int* e = node_elements_.begin(i); e != node_elements_.end(i); ++e)
      for (int corner = 0; corner < 3; ++corner)
        if (basis.elements()(*e, corner) == i)
          for (const TrianglePoint& p : rule[corner])
            points.push_back({ *e, p.u, p.v, p.weight });
  }
  singular_start_.push_back(static_cast<int>(points.size()));
  singular_ = basis.tabulate(points);
}

void StokesletMatrix::assemble(
  const Points& points, const SurfacePoints& surface, DenseMatrix& matrix) const
{
  const int n = static_cast<int>(points.rows());
  matrix.resize(3 * n, 3 * n);
  const SurfacePoints singular = evaluate(singular_, points);
  const Eigen::VectorXd weight = kernel_factor * surface.area_weight;
  const StokesletSources sources{ surface.position.col(0).data(), surface.position.col(1).data(),
    surface.position.col(2).data(), weight.data(), regular_.start.data(), regular_.node.data(),
    regular_.value.data() };
  const int blocks = (n + lanes - 1) / lanes;
  tbb::parallel_for(0, blocks,
    [&](int block) { assemble_block(points, sources, singular, block * lanes, matrix); });
}

void StokesletMatrix::assemble_block(const Points& points, const StokesletSources& sources,
  const SurfacePoints& singular, int first, DenseMatrix& matrix) const
{
  const int n = static_cast<int>(points.rows()), count = std::min(lanes, n - first);
  std::array<double, 3 * lanes> targets;
  for (int lane = 0; lane < lanes; ++lane)
    for (int c = 0; c < 3; ++c)
      targets[c * lanes + lane] = points(first + std::min(lane, count - 1), c);

  // Elements that touch one of the targets leave that target to its Duffy rows.
  std::vector<int> touching;
  for (int lane = 0; lane < count; ++lane)
    touching.insert(
      touching.end(), node_elements_.begin(first + lane), node_elements_.end(first + lane));
  std::sort(touching.begin(), touching.end());
  touching.erase(std::unique(touching.begin(), touching.end()), touching.end());

  thread_local Accumulator sum;
  sum.assign(static_cast<std::size_t>(n) * 6 * lanes, 0);
  std::array<double, lanes> all;
  all.fill(1);
  int row = 0;
  for (int e : touching)
  {
    add_stokeslets(sources, row, first_row_[e], targets.data(), all.data(), sum.data());
    std::array<double, lanes> mask = all;
    for (int lane = 0; lane < count; ++lane)
      if (std::binary_search(
            node_elements_.begin(first + lane), node_elements_.end(first + lane), e))
        mask[lane] = 0;
    row = first_row_[e + 1];
    add_stokeslets(sources, first_row_[e], row, targets.data(), mask.data(), sum.data());
  }
  add_stokeslets(sources, row, first_row_.back(), targets.data(), all.data(), sum.data());

  for (int lane = 0; lane < count; ++lane)
  {
    const int i = first + lane;
    for (int k = 0; k < n; ++k)
    {
      const double* s = sum.data() + static_cast<std::size_t>(k) * 6 * lanes + lane;
      double* top = matrix.data() + (3L * i) * (3L * n) + 3 * k;
      double *middle = top + 3L * n, *bottom = middle + 3L * n;
      top[0] = s[0];
      top[1] = middle[0] = s[lanes];
      top[2] = bottom[0] = s[2 * lanes];
      middle[1] = s[3 * lanes];
      middle[2] = bottom[1] = s[4 * lanes];
      bottom[2] = s[5 * lanes];
    }
    for (int q = singular_start_[i]; q < singular_start_[i + 1]; ++q)
    {
      const Eigen::Matrix3d g = kernel_factor * singular.area_weight[q] *
        stokeslet((singular.position.row(q) - points.row(i)).transpose());
      for (int k = singular_.start[q]; k < singular_.start[q + 1]; ++k)
        matrix.block<3, 3>(3 * i, 3 * singular_.node[k]) += singular_.value[k] * g;
    }
  }
}

void multiply(const DenseMatrix& A, const Eigen::VectorXd& x, Eigen::VectorXd& y)
{
  y.resize(A.rows());
  const double *a = A.data(), *in = x.data();
  double* out = y.data();
  const long columns = A.cols();
  tbb::parallel_for(tbb::blocked_range<long>(0, A.rows(), 64),
    [=](const auto& rows)
    {
      for (long i = rows.begin(); i < rows.end(); ++i)
        out[i] = dot(a + i * columns, in, columns);
    });
}

}
