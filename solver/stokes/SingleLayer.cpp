#include "solver/stokes/SingleLayer.h"

#include "solver/stokes/StokesletKernel.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <numbers>
#include <numeric>

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
    tbb::parallel_for(tbb::blocked_range<int>(0, rows, 256),
      [&](const auto& block)
      {
        for (int q = block.begin(); q < block.end(); ++q)
        {
          const double J = surface.cross.row(q).norm();
          normal.row(q) = surface.cross.row(q) / J;
          dual_u.row(q) = surface.tangent_v.row(q).cross(normal.row(q)) / J;
          dual_v.row(q) = normal.row(q).cross(surface.tangent_u.row(q)) / J;
        }
      });
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

namespace
{

// Rows of the rule on all elements, and the first row of each element.
BasisTable tabulate_elements(
  const Basis& basis, int points, int graded, std::vector<int>& element_start)
{
  const std::vector<ParametricPoint> rule = basis.rule(triangle_rule(points), graded);
  element_start.assign(basis.elements().rows() + 1, 0);
  for (const ParametricPoint& p : rule)
    ++element_start[p.element + 1];
  std::partial_sum(element_start.begin(), element_start.end(), element_start.begin());
  return basis.tabulate(rule);
}

void sort_unique(std::vector<int>& items)
{
  std::sort(items.begin(), items.end());
  items.erase(std::unique(items.begin(), items.end()), items.end());
}

// Elements that don't touch the vertex but share a corner with one that does, ascending.
AdjacencyList second_ring(const Connectivity& mesh)
{
  AdjacencyList result{ { 0 }, {} };
  const AdjacencyList &neighbours = mesh.vertex_neighbours, &elements = mesh.vertex_triangles;
  for (int i = 0; i + 1 < static_cast<int>(neighbours.start.size()); ++i)
  {
    std::vector<int> around;
    for (const int* j = neighbours.begin(i); j != neighbours.end(i); ++j)
      around.insert(around.end(), elements.begin(*j), elements.end(*j));
    sort_unique(around);
    std::set_difference(around.begin(), around.end(), elements.begin(i), elements.end(i),
      std::back_inserter(result.item));
    result.start.push_back(static_cast<int>(result.item.size()));
  }
  return result;
}

// The vertices in groups of `lanes` that are close together on the mesh where possible: grown from
// the first vertex left over. Then few elements are near any target of a group.
std::vector<int> group_neighbours(const AdjacencyList& neighbours)
{
  const int n = static_cast<int>(neighbours.start.size()) - 1;
  std::vector<int> order;
  std::vector<bool> taken(n, false);
  const auto take = [&](int i)
  {
    taken[i] = true;
    order.push_back(i);
  };
  for (int seed = 0; seed < n; ++seed)
  {
    if (taken[seed])
      continue;
    std::size_t next = order.size();
    take(seed);
    for (; next < order.size() && order.size() % lanes != 0; ++next)
      for (const int* j = neighbours.begin(order[next]); j != neighbours.end(order[next]); ++j)
        if (!taken[*j] && order.size() % lanes != 0)
          take(*j);
  }
  return order;
}

}

LayerQuadrature smooth_layer_quadrature(int regular)
{
  if (regular < 6)
    return { .regular = regular, .near = 6, .graded = 1, .radial = 3, .angular = 4 };
  return {
    .regular = regular, .near = regular < 12 ? 12 : 0, .graded = 2, .radial = 4, .angular = 6
  };
}

SingleLayer::SingleLayer(const Basis& basis, const LayerQuadrature& quadrature)
{
  const Connectivity connectivity(basis.elements(), basis.nodes());
  vertex_elements_ = connectivity.vertex_triangles;
  order_ = group_neighbours(connectivity.vertex_neighbours);
  regular_ = tabulate_elements(basis, quadrature.regular, quadrature.graded, regular_start_);
  near_elements_.start.assign(basis.nodes() + 1, 0);
  if (quadrature.near > 0)
  {
    near_elements_ = second_ring(connectivity);
    near_ = tabulate_elements(basis, quadrature.near, quadrature.graded, near_start_);
  }

  // Tabulated element by element, which the basis does fastest, then grouped by vertex.
  std::vector<ParametricPoint> points;
  for (int i = 0; i < basis.nodes(); ++i)
  {
    singular_start_.push_back(static_cast<int>(points.size()));
    for (const int* e = vertex_elements_.begin(i); e != vertex_elements_.end(i); ++e)
      for (int corner = 0; corner < 3; ++corner)
        if (basis.elements()(*e, corner) == i)
          for (const TrianglePoint& p :
            duffy_rule(corner, quadrature.radial, quadrature.angular, basis.radial_exponent(i)))
            points.push_back({ *e, p.u, p.v, p.weight });
  }
  singular_start_.push_back(static_cast<int>(points.size()));
  singular_ = basis.tabulate(points);
}

// For every group of targets: all rows of elements that don't touch a target, those next to it by
// the near rule, then the target's own Duffy rows, added up by `kernel`; then write(targets, their
// number, sums).
template<class Sources, class Kernel, class Write>
void SingleLayer::for_each_block(const Points& vertices, const Sources& regular,
  const Sources& near, const Sources& singular, Kernel kernel, Write write) const
{
  const int n = static_cast<int>(vertices.rows()), blocks = (n + lanes - 1) / lanes;
  tbb::parallel_for(0, blocks,
    [&](int block)
    {
      const int count = std::min(lanes, n - block * lanes);
      const int* target = order_.data() + block * lanes;
      std::array<double, 3 * lanes> position;
      for (int lane = 0; lane < lanes; ++lane)
        for (int c = 0; c < 3; ++c)
          position[c * lanes + lane] = vertices(target[std::min(lane, count - 1)], c);

      // Elements that touch a target or are next to it have rows of their own for it.
      std::vector<int> special;
      for (int lane = 0; lane < count; ++lane)
        for (const AdjacencyList* list : { &vertex_elements_, &near_elements_ })
          special.insert(special.end(), list->begin(target[lane]), list->end(target[lane]));
      sort_unique(special);
      // 1 for the lanes whose target has the element in the list.
      const auto lanes_of = [&](const AdjacencyList& list, int element)
      {
        std::array<double, lanes> mask{};
        for (int lane = 0; lane < count; ++lane)
          mask[lane] =
            std::binary_search(list.begin(target[lane]), list.end(target[lane]), element) ? 1 : 0;
        return mask;
      };

      thread_local Accumulator sum;
      sum.assign(static_cast<std::size_t>(n) * stride, 0);
      const auto add =
        [&](const Sources& sources, int begin, int end, const std::array<double, lanes>& mask)
      { kernel(sources, begin, end, position.data(), mask.data(), sum.data()); };
      std::array<double, lanes> all;
      all.fill(1);
      int row = 0;
      for (int e : special)
      {
        add(regular, row, regular_start_[e], all);
        const std::array<double, lanes> touching = lanes_of(vertex_elements_, e),
                                        close = lanes_of(near_elements_, e);
        std::array<double, lanes> others;
        for (int lane = 0; lane < lanes; ++lane)
          others[lane] = 1 - touching[lane] - close[lane];
        row = regular_start_[e + 1];
        if (others != std::array<double, lanes>{})
          add(regular, regular_start_[e], row, others);
        if (close != std::array<double, lanes>{})
          add(near, near_start_[e], near_start_[e + 1], close);
      }
      add(regular, row, regular_start_.back(), all);
      for (int lane = 0; lane < count; ++lane)
      {
        std::array<double, lanes> only{};
        only[lane] = 1;
        add(singular, singular_start_[target[lane]], singular_start_[target[lane] + 1], only);
      }
      write(target, count, sum.data());
    });
}

void SingleLayer::assemble(const Points& vertices, const Points& control, DenseMatrix& matrix) const
{
  const int n = static_cast<int>(vertices.rows());
  matrix.resize(3 * n, 3 * n);
  const RowData regular(regular_, control), near(near_, control), singular(singular_, control);
  for_each_block(vertices, regular.sources(regular_), near.sources(near_),
    singular.sources(singular_), add_stokeslets,
    [&](const int* target, int count, const double* sum)
    {
      // Component of each entry of the symmetric 3 by 3 block.
      static constexpr int component[3][3] = { { 0, 1, 2 }, { 1, 3, 4 }, { 2, 4, 5 } };
      for (int lane = 0; lane < count; ++lane)
        for (int a = 0; a < 3; ++a)
          for (int b = 0; b < 3; ++b)
            for (int k = 0; k < n; ++k)
              matrix(3 * target[lane] + a, 3 * k + b) =
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
  const RowData regular(regular_, points), near(near_, points), singular(singular_, points);
  for_each_block(points, regular.sources(regular_), near.sources(near_),
    singular.sources(singular_), add_stokeslets,
    [&](const int* target, int count, const double* sum)
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
          const int row = 3 * target[lane] + c;
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
  RowData regular(regular_, control), near(near_, control), singular(singular_, control);
  for_each_block(vertices, regular.surface_sources(regular_, control),
    near.surface_sources(near_, control), singular.surface_sources(singular_, control),
    add_surface_densities,
    [&](const int* target, int count, const double* sum)
    {
      std::vector<double> row(n);
      for (int lane = 0; lane < count; ++lane)
        for (int c = 0; c < 3; ++c)
        {
          const int i = 3 * target[lane] + c;
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
