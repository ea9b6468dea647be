#include "solver/stokes/SingleLayer.h"

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
constexpr int stride = stokeslet_components * lanes; // numbers a node in the accumulators
constexpr double kernel_factor = 1 / (8 * std::numbers::pi);

using Accumulator = std::vector<double>;

// What the kernels read of a table's rows at a shape.
struct RowData
{
  SurfacePoints surface;
  Eigen::VectorXd weight, twice_mean;
  RowVectors normal, dual_u, dual_v;

  RowData(const BasisTable& table, const Points& control)
    : surface(evaluate(table, control)), weight(kernel_factor * surface.area_weight)
  {
  }

  StokesletSources sources(const BasisTable& table) const
  {
    return { surface.position.col(0).data(), surface.position.col(1).data(),
      surface.position.col(2).data(), weight.data(), table.element.data(), table.start.data(),
      table.node.data(), table.value.data() };
  }

  SurfaceSources surface_sources(const BasisTable& table, const Points& control)
  {
    const int rows = table.rows();
    normal = dual_u = dual_v = RowVectors(rows, 3);
    for (int q = 0; q < rows; ++q)
    {
      const double J = surface.cross.row(q).norm();
      normal.row(q) = surface.cross.row(q) / J;
      dual_u.row(q) = surface.tangent_v.row(q).cross(normal.row(q)) / J;
      dual_v.row(q) = normal.row(q).cross(surface.tangent_u.row(q)) / J;
    }
    twice_mean = 2 * mean_curvature(table, surface, control);
    return { sources(table), table.du.data(), table.dv.data(), normal.data(), dual_u.data(),
      dual_v.data(), twice_mean.data(), rows };
  }
};

void transpose_lane(const double* sum, int lane, int n, int component, double* row)
{
  const double* s = sum + component * lanes + lane;
  for (int k = 0; k < n; ++k)
    row[k] = s[static_cast<long>(k) * stride];
}

}

SingleLayer::SingleLayer(const Basis& basis, const LayerQuadrature& quadrature)
  : vertex_elements_(Connectivity(basis.elements(), basis.nodes()).vertex_triangles)
{
  const std::vector<ParametricPoint> rule =
    basis.rule(triangle_rule(quadrature.regular), quadrature.graded);
  regular_ = basis.tabulate(rule);
  first_row_.assign(basis.elements().rows() + 1, 0);
  for (const ParametricPoint& p : rule)
    ++first_row_[p.element + 1];
  for (std::size_t e = 1; e < first_row_.size(); ++e)
    first_row_[e] += first_row_[e - 1];

  // Tabulated element by element, which the basis does fastest, then grouped by vertex.
  std::array<std::vector<TrianglePoint>, 3> duffy;
  for (int corner = 0; corner < 3; ++corner)
    duffy[corner] = duffy_rule(corner, quadrature.radial, quadrature.angular);
  std::vector<ParametricPoint> points;
  for (int i = 0; i < basis.nodes(); ++i)
  {
    singular_start_.push_back(static_cast<int>(points.size()));
    for (const int* e = vertex_elements_.begin(i); e != vertex_elements_.end(i); ++e)
      for (int corner = 0; corner < 3; ++corner)
        if (basis.elements()(*e, corner) == i)
          for (const TrianglePoint& p : duffy[corner])
            points.push_back({ *e, p.u, p.v, p.weight });
  }
  singular_start_.push_back(static_cast<int>(points.size()));
  singular_ = basis.tabulate(points);
}

// For every group of targets: all rows of elements that don't touch a target, then the target's own
// Duffy rows, added up by `kernel`; then write(first target, number of targets, sums).
template<class Sources, class Kernel, class Write>
void SingleLayer::for_each_block(const Points& vertices, const Sources& regular,
  const Sources& singular, Kernel kernel, Write write) const
{
  const int n = static_cast<int>(vertices.rows()), blocks = (n + lanes - 1) / lanes;
  tbb::parallel_for(0, blocks,
    [&](int block)
    {
      const int first = block * lanes, count = std::min(lanes, n - first);
      std::array<double, 3 * lanes> targets;
      for (int lane = 0; lane < lanes; ++lane)
        for (int c = 0; c < 3; ++c)
          targets[c * lanes + lane] = vertices(first + std::min(lane, count - 1), c);

      // Elements that touch one of the targets leave that target to its Duffy rows.
      std::vector<int> touching;
      for (int lane = 0; lane < count; ++lane)
        touching.insert(
          touching.end(), vertex_elements_.begin(first + lane), vertex_elements_.end(first + lane));
      std::sort(touching.begin(), touching.end());
      touching.erase(std::unique(touching.begin(), touching.end()), touching.end());

      thread_local Accumulator sum;
      sum.assign(static_cast<std::size_t>(n) * stride, 0);
      std::array<double, lanes> all;
      all.fill(1);
      int row = 0;
      for (int e : touching)
      {
        kernel(regular, row, first_row_[e], targets.data(), all.data(), sum.data());
        std::array<double, lanes> mask = all;
        for (int lane = 0; lane < count; ++lane)
          if (std::binary_search(
                vertex_elements_.begin(first + lane), vertex_elements_.end(first + lane), e))
            mask[lane] = 0;
        row = first_row_[e + 1];
        kernel(regular, first_row_[e], row, targets.data(), mask.data(), sum.data());
      }
      kernel(regular, row, first_row_.back(), targets.data(), all.data(), sum.data());
      for (int lane = 0; lane < count; ++lane)
      {
        std::array<double, lanes> only{};
        only[lane] = 1;
        kernel(singular, singular_start_[first + lane], singular_start_[first + lane + 1],
          targets.data(), only.data(), sum.data());
      }
      write(first, count, sum.data());
    });
}

void SingleLayer::assemble(const Points& vertices, const Points& control, DenseMatrix& matrix) const
{
  const int n = static_cast<int>(vertices.rows());
  matrix.resize(3 * n, 3 * n);
  const RowData regular(regular_, control), singular(singular_, control);
  for_each_block(vertices, regular.sources(regular_), singular.sources(singular_), add_stokeslets,
    [&](int first, int count, const double* sum)
    {
      // Component of each entry of the symmetric 3 by 3 block.
      static constexpr int component[3][3] = { { 0, 1, 2 }, { 1, 3, 4 }, { 2, 4, 5 } };
      for (int lane = 0; lane < count; ++lane)
        for (int a = 0; a < 3; ++a)
          for (int b = 0; b < 3; ++b)
            for (int k = 0; k < n; ++k)
              matrix(3 * (first + lane) + a, 3 * k + b) =
                sum[static_cast<long>(k) * stride + component[a][b] * lanes + lane];
    });
}

void SingleLayer::respond(const Points& points, const Points& normal, bool with_normal,
  const SparseMatrix& T, const Eigen::VectorXd& load, VelocityResponse& response) const
{
  const int n = static_cast<int>(points.rows());
  const bool with_tension = T.size() > 0, with_load = load.size() > 0;
  response.normal.resize(with_normal ? 3 * n : 0, with_normal ? n : 0);
  response.tension.resize(with_tension ? 3 * n : 0, with_tension ? n : 0);
  response.load.resize(with_load ? 3 * n : 0);
  const RowData regular(regular_, points), singular(singular_, points);
  for_each_block(points, regular.sources(regular_), singular.sources(singular_), add_stokeslets,
    [&](int first, int count, const double* sum)
    {
      thread_local Accumulator tension;
      tension.assign(with_tension ? static_cast<std::size_t>(n) * 3 * lanes : 0, 0);
      thread_local Accumulator along_normal;
      along_normal.resize(with_normal ? static_cast<std::size_t>(n) * 3 * lanes : 0);
      std::array<double, 3 * lanes> from_load{};
      for (int k = 0; k < n; ++k)
      {
        const double* s = sum + static_cast<long>(k) * stride;
        // to += S_ik d for all lanes i.
        const auto add = [s](double* to, double x, double y, double z)
        {
          for (int lane = 0; lane < lanes; ++lane)
          {
            to[lane] += s[lane] * x + s[lanes + lane] * y + s[2 * lanes + lane] * z;
            to[lanes + lane] +=
              s[lanes + lane] * x + s[3 * lanes + lane] * y + s[4 * lanes + lane] * z;
            to[2 * lanes + lane] +=
              s[2 * lanes + lane] * x + s[4 * lanes + lane] * y + s[5 * lanes + lane] * z;
          }
        };
        if (with_normal)
        {
          double* to = along_normal.data() + static_cast<long>(k) * 3 * lanes;
          std::fill_n(to, 3 * lanes, 0.);
          add(to, normal(k, 0), normal(k, 1), normal(k, 2));
        }
        if (with_load)
          add(from_load.data(), load[3 * k], load[3 * k + 1], load[3 * k + 2]);
        if (with_tension)
        {
          // The three rows of a node have the same columns.
          const int begin = T.outerIndexPtr()[3 * k], width = T.outerIndexPtr()[3 * k + 1] - begin;
          const double* t = T.valuePtr() + begin;
          for (int j = 0; j < width; ++j)
            add(tension.data() + static_cast<long>(T.innerIndexPtr()[begin + j]) * 3 * lanes, t[j],
              t[j + width], t[j + 2 * width]);
        }
      }
      for (int lane = 0; lane < count; ++lane)
        for (int c = 0; c < 3; ++c)
        {
          const int row = 3 * (first + lane) + c;
          if (with_load)
            response.load[row] = from_load[c * lanes + lane];
          for (int k = 0; with_normal && k < n; ++k)
            response.normal(row, k) = along_normal[(3L * k + c) * lanes + lane];
          for (int k = 0; with_tension && k < n; ++k)
            response.tension(row, k) = tension[(3L * k + c) * lanes + lane];
        }
    });
}

void SingleLayer::respond_on_surface(const Points& vertices, const Points& control,
  bool with_normal, bool with_tension, const Eigen::VectorXd& load,
  VelocityResponse& response) const
{
  const int n = static_cast<int>(vertices.rows());
  const bool with_load = load.size() > 0;
  response.normal.resize(with_normal ? 3 * n : 0, with_normal ? n : 0);
  response.tension.resize(with_tension ? 3 * n : 0, with_tension ? n : 0);
  response.load.resize(with_load ? 3 * n : 0);
  RowData regular(regular_, control), singular(singular_, control);
  for_each_block(vertices, regular.surface_sources(regular_, control),
    singular.surface_sources(singular_, control), add_surface_densities,
    [&](int first, int count, const double* sum)
    {
      std::vector<double> row(n);
      for (int lane = 0; lane < count; ++lane)
        for (int c = 0; c < 3; ++c)
        {
          const int i = 3 * (first + lane) + c;
          if (with_tension)
            transpose_lane(sum, lane, n, 3 + c, response.tension.row(i).data());
          if (!with_normal && !with_load)
            continue;
          transpose_lane(sum, lane, n, c, row.data());
          if (with_normal)
            std::copy(row.begin(), row.end(), response.normal.row(i).data());
          if (with_load)
            response.load[i] = dot(row.data(), load.data(), n);
        }
    });
}

Eigen::VectorXd VelocityResponse::velocity(
  const Eigen::VectorXd& phi, const Eigen::VectorXd& gamma) const
{
  Eigen::VectorXd u;
  if (phi.size() > 0)
    multiply(normal, phi, u);
  if (gamma.size() > 0)
    multiply(tension, gamma, u, phi.size() > 0);
  return u;
}

void multiply(const DenseMatrix& A, const Eigen::VectorXd& x, Eigen::VectorXd& y, bool add)
{
  if (!add)
    y = Eigen::VectorXd::Zero(A.rows());
  const double *a = A.data(), *in = x.data();
  double* out = y.data();
  const long columns = A.cols();
  tbb::parallel_for(tbb::blocked_range<long>(0, A.rows(), 64),
    [=](const auto& rows)
    {
      for (long i = rows.begin(); i < rows.end(); ++i)
        out[i] += dot(a + i * columns, in, columns);
    });
}

}
