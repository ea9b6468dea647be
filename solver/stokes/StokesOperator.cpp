#include "solver/stokes/StokesOperator.h"

#include "solver/ParallelFor.h"
#include "solver/stokes/StokesletKernel.h"

#include <algorithm>
#include <array>

namespace vesicle
{

/// Source points of a surface's three rules, as a kernel reads them.
template<class Sources>
struct RuleSources
{
  Sources regular, near, singular;
};

namespace
{

constexpr int lanes = stokeslet_lanes;
constexpr int stride = stokeslet_components * lanes; // numbers a node in the accumulators

using LaneMask = std::array<double, lanes>;

/// Targets whose sums are made at once: neighbours on one surface.
struct Group
{
  const int* target;
  int count;
  std::array<double, 3 * lanes> position; ///< the last target repeated where there are fewer

  Group(const LayerSurface& surface, int number)
    : target(surface.rules->order().data() + number * lanes),
      count(std::min(lanes, surface.rules->vertices() - number * lanes))
  {
    for (int lane = 0; lane < lanes; ++lane)
      for (int c = 0; c < 3; ++c)
        position[c * lanes + lane] = surface.vertices(target[std::min(lane, count - 1)], c);
  }
};

int group_count(const LayerSurface& surface)
{
  return (surface.rules->vertices() + lanes - 1) / lanes;
}

LaneMask all_lanes()
{
  LaneMask mask;
  mask.fill(1);
  return mask;
}

/// 1 for the lanes whose target has the element in its list.
LaneMask lanes_of(const Group& group, const AdjacencyList& list, int element)
{
  LaneMask mask{};
  for (int lane = 0; lane < group.count; ++lane)
    mask[lane] =
      std::binary_search(list.begin(group.target[lane]), list.end(group.target[lane]), element);
  return mask;
}

/// Elements that touch a target or are next to it: those have rows of their own for it.
std::vector<int> special_elements(const Group& group, const LayerRules& rules)
{
  std::vector<int> special;
  for (int lane = 0; lane < group.count; ++lane)
    for (const AdjacencyList* list : { &rules.touching(), &rules.close() })
      special.insert(special.end(), list->begin(group.target[lane]), list->end(group.target[lane]));
  std::sort(special.begin(), special.end());
  special.erase(std::unique(special.begin(), special.end()), special.end());
  return special;
}

/// Of the elements next to a target the near rule's rows, of those that touch it its Duffy rows;
/// add(sources, begin, end, mask).
template<class Sources, class Add>
void add_near_and_singular(const Group& group, const LayerRules& rules,
  const std::vector<int>& special, const RuleSources<Sources>& sources, Add add)
{
  const std::vector<int>& near = rules.near().start;
  for (int e : special)
    if (const LaneMask close = lanes_of(group, rules.close(), e); close != LaneMask{})
      add(sources.near, near[e], near[e + 1], close);
  for (int lane = 0; lane < group.count; ++lane)
  {
    LaneMask only{};
    only[lane] = 1;
    const int* start = rules.singular().start.data() + group.target[lane];
    add(sources.singular, start[0], start[1], only);
  }
}

/// Lanes whose target is next to an element or touches it.
LaneMask lanes_at(const Group& group, const LayerRules& rules, int element)
{
  LaneMask at = lanes_of(group, rules.touching(), element);
  const LaneMask close = lanes_of(group, rules.close(), element);
  for (int lane = 0; lane < lanes; ++lane)
    at[lane] += close[lane];
  return at;
}

/// All rows of a surface for targets of its own.
template<class Sources, class Add>
void add_own_rows(
  const Group& group, const LayerRules& rules, const RuleSources<Sources>& sources, Add add)
{
  const std::vector<int>& regular = rules.regular().start;
  const std::vector<int> special = special_elements(group, rules);
  int row = 0;
  for (int e : special)
  {
    add(sources.regular, row, regular[e], all_lanes());
    row = regular[e + 1];
    LaneMask others = lanes_at(group, rules, e);
    for (double& lane : others)
      lane = 1 - lane;
    if (others != LaneMask{})
      add(sources.regular, regular[e], row, others);
  }
  add(sources.regular, row, regular.back(), all_lanes());
  add_near_and_singular(group, rules, special, sources, add);
}

/// The difference between a surface's rows for targets of its own and all of its regular ones.
template<class Sources, class Add>
void add_corrections(
  const Group& group, const LayerRules& rules, const RuleSources<Sources>& sources, Add add)
{
  const std::vector<int>& regular = rules.regular().start;
  const std::vector<int> special = special_elements(group, rules);
  for (int e : special)
  {
    LaneMask minus = lanes_at(group, rules, e);
    for (double& lane : minus)
      lane = -lane;
    add(sources.regular, regular[e], regular[e + 1], minus);
  }
  add_near_and_singular(group, rules, special, sources, add);
}

/// A rule's points at a shape, as kernels read them that scatter to nodes.
StokesletSources node_sources(const BasisTable& table, const LayerPoints& at)
{
  return { at.surface.position.col(0).data(), at.surface.position.col(1).data(),
    at.surface.position.col(2).data(), at.weight.data(), table.element.data(), table.start.data(),
    table.node.data(), table.value.data() };
}

}

LayerPoints::LayerPoints(const BasisTable& table, const Points& control)
  : surface(evaluate(table, control)), weight(kernel_factor * surface.area_weight)
{
}

StokesOperator::StokesOperator(std::vector<LayerSurface> surfaces, FarSum far)
  : surfaces_(std::move(surfaces)), first_{ 0 }, add_far_(std::move(far))
{
  for (const LayerSurface& s : surfaces_)
  {
    first_.push_back(first_.back() + static_cast<int>(s.vertices.rows()));
    points_.push_back({ LayerPoints(s.rules->regular().table, s.control),
      LayerPoints(s.rules->near().table, s.control),
      LayerPoints(s.rules->singular().table, s.control) });
  }
}

// For every group of targets on any surface: sums over the source's rows, 6 numbers a node and lane,
// in room(number of the group), then write(first vertex of the surface, group, number, sums).
template<class Room, class Write>
void StokesOperator::for_each_group(int source, Room room, Write write) const
{
  const LayerRules& rules = *surfaces_[source].rules;
  const auto& [regular, near, singular] = points_[source];
  const RuleSources<StokesletSources> sources{ node_sources(rules.regular().table, regular),
    node_sources(rules.near().table, near), node_sources(rules.singular().table, singular) };
  int first_group = 0;
  for (int s = 0; s < static_cast<int>(surfaces_.size()); ++s)
  {
    parallel_for(group_count(surfaces_[s]),
      [&](int number)
      {
        const Group group(surfaces_[s], number);
        double* sum = room(first_group + number);
        std::fill_n(sum, static_cast<long>(rules.vertices()) * stride, 0.);
        const auto add = [&](const StokesletSources& rows, int begin, int end, const LaneMask& mask)
        { add_stokeslets(rows, begin, end, group.position.data(), mask.data(), sum); };
        if (s == source)
          add_own_rows(group, rules, sources, add);
        else
          add(sources.regular, 0, rules.regular().start.back(), all_lanes());
        write(first_[s], group, first_group + number, sum);
      });
    first_group += group_count(surfaces_[s]);
  }
}

void StokesOperator::fill(int source, LayerMatrix& matrix) const
{
  int groups = 0;
  for (const LayerSurface& surface : surfaces_)
    groups += group_count(surface);
  matrix.resize(groups, surfaces_[source].rules->vertices(), vertices());
  for_each_group(
    source, [&](int number) { return matrix.group(number); },
    [&](int first, const Group& group, int number, const double*)
    {
      int* targets = matrix.targets(number);
      for (int lane = 0; lane < lanes; ++lane)
        targets[lane] = lane < group.count ? first + group.target[lane] : -1;
    });
}

DenseMatrix StokesOperator::columns(int source, const NodalDensities& densities) const
{
  const SparseMatrix& F = densities.F;
  const LayerRules& rules = *surfaces_[source].rules;
  const int n = rules.vertices();
  const long m = F.cols();
  DenseMatrix matrix(3L * vertices(), m);
  for_each_group(
    source,
    [&](int)
    {
      thread_local std::vector<double> sum;
      sum.resize(static_cast<std::size_t>(n) * stride);
      return sum.data();
    },
    [&](int first, const Group& group, int, const double* sum)
    {
      thread_local std::vector<double> column; // of each density: x, y, z of all lanes
      column.assign(static_cast<std::size_t>(m) * 3 * lanes, 0);
      for (int k = 0; k < n; ++k)
      {
        const double* s = sum + static_cast<long>(k) * stride;
        const int begin = F.outerIndexPtr()[3 * k], width = F.outerIndexPtr()[3 * k + 1] - begin;
        const double* f = F.valuePtr() + begin;
        for (int j = 0; j < width; ++j)
        {
          // The symmetric block xx, xy, xz, yy, yz, zz times the node's vector.
          const double x = f[j], y = f[j + width], z = f[j + 2 * width];
          double* to = column.data() + static_cast<long>(F.innerIndexPtr()[begin + j]) * 3 * lanes;
          for (int lane = 0; lane < lanes; ++lane)
          {
            to[lane] += s[lane] * x + s[lanes + lane] * y + s[2 * lanes + lane] * z;
            to[lanes + lane] +=
              s[lanes + lane] * x + s[3 * lanes + lane] * y + s[4 * lanes + lane] * z;
            to[2 * lanes + lane] +=
              s[2 * lanes + lane] * x + s[4 * lanes + lane] * y + s[5 * lanes + lane] * z;
          }
        }
      }
      for (int lane = 0; lane < group.count; ++lane)
        for (int c = 0; c < 3; ++c)
        {
          double* row = matrix.row(3 * (first + group.target[lane]) + c).data();
          for (long j = 0; j < m; ++j)
            row[j] = column[(3 * j + c) * lanes + lane];
        }
    });
  return matrix;
}

DenseMatrix StokesOperator::matrix(int source) const
{
  const int n = surfaces_[source].rules->vertices();
  SparseMatrix identity(3L * n, 3L * n); // with the zeros of its blocks: see NodalDensities
  identity.reserve(Eigen::VectorXi::Constant(3 * n, 3));
  for (int row = 0; row < 3 * n; ++row)
    for (int c = 0; c < 3; ++c)
      identity.insert(row, row / 3 * 3 + c) = c == row % 3 ? 1 : 0;
  identity.makeCompressed();
  return columns(source, NodalDensities{ identity });
}

namespace
{

/// A rule's points with a force density on them.
struct LoadedPoints
{
  RowVectors force, normal;
  ForceSources sources;

  LoadedPoints(const BasisTable& table, const LayerPoints& at, const ForceDensity& density)
    : force(density(table, at.surface)),
      normal(at.surface.cross.rowwise().normalized()), sources{ node_sources(table, at),
        force.data(), normal.data(), table.rows() }
  {
  }
};

}

Eigen::VectorXd StokesOperator::apply(std::span<const ForceDensity> densities) const
{
  Points targets(vertices(), 3);
  for (std::size_t s = 0; s < surfaces_.size(); ++s)
    targets.middleRows(first_[s], surfaces_[s].vertices.rows()) = surfaces_[s].vertices;
  Points velocity = Points::Zero(vertices(), 3);
  for (std::size_t s = 0; s < surfaces_.size(); ++s)
  {
    const LayerRules& rules = *surfaces_[s].rules;
    const auto& [regular, near, singular] = points_[s];
    const LoadedPoints far(rules.regular().table, regular, densities[s]),
      close(rules.near().table, near, densities[s]),
      own(rules.singular().table, singular, densities[s]);
    add_far_(far.sources, targets, velocity);
    const RuleSources<ForceSources> sources{ far.sources, close.sources, own.sources };
    parallel_for(group_count(surfaces_[s]),
      [&](int number)
      {
        const Group group(surfaces_[s], number);
        std::array<double, 4 * lanes> sum{};
        add_corrections(group, rules, sources,
          [&](const ForceSources& rows, int begin, int end, const LaneMask& mask)
          { add_velocities(rows, begin, end, group.position.data(), mask.data(), sum.data()); });
        for (int lane = 0; lane < group.count; ++lane)
          for (int c = 0; c < 3; ++c)
            velocity(first_[s] + group.target[lane], c) += sum[c * lanes + lane];
      });
  }
  return velocity.reshaped<Eigen::RowMajor>();
}

Eigen::VectorXd multiply(const DenseMatrix& A, const Eigen::VectorXd& x, Eigen::Index first)
{
  Eigen::VectorXd y(A.rows());
  const double *a = A.data() + first, *in = x.data();
  double* out = y.data();
  const long columns = A.cols(), count = x.size();
  parallel_for(
    A.rows(), [=](long i) { out[i] = dot(a + i * columns, in, count); }, 64L);
  return y;
}

}
