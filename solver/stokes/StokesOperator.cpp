#include "solver/stokes/StokesOperator.h"

#include "solver/ParallelFor.h"
#include "solver/stokes/kernels/StokesletKernel.h"

#include <algorithm>
#include <array>
#include <numeric>

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

using Lanes = LayerRules::Group; // whose targets have a lane each

/// Where the targets of a group are; the last is repeated where there are fewer than lanes.
std::array<double, 3 * lanes> positions(const Lanes& group, const Points& vertices)
{
  std::array<double, 3 * lanes> position;
  const int count = static_cast<int>(group.target.size());
  for (int lane = 0; lane < lanes; ++lane)
    for (int c = 0; c < 3; ++c)
      position[c * lanes + lane] = vertices(group.target[std::min(lane, count - 1)], c);
  return position;
}

/// `set` in the lanes of the bits, `clear` in the others.
constexpr LaneMask mask_of(unsigned bits, double set, double clear = 0)
{
  LaneMask mask{};
  for (int lane = 0; lane < lanes; ++lane)
    mask[lane] = bits >> lane & 1U ? set : clear;
  return mask;
}

constexpr LaneMask all_lanes = mask_of(0, 0, 1);
constexpr unsigned all_bits = (1U << lanes) - 1;

/// Of the elements next to a target the near rule's rows, of those that touch it its Duffy rows;
/// add(sources, begin, end, mask).
template<class Sources, class Add>
void add_near_and_singular(
  const Lanes& group, const LayerRules& rules, const RuleSources<Sources>& sources, Add add)
{
  const std::vector<int>& near = rules.near().start;
  for (const auto& [element, touching, close] : group.special)
    if (close != 0)
      add(sources.near, near[element], near[element + 1], mask_of(close, 1));
  for (std::size_t lane = 0; lane < group.target.size(); ++lane)
  {
    const int* start = rules.singular().start.data() + group.target[lane];
    add(sources.singular, start[0], start[1], mask_of(1U << lane, 1));
  }
}

/// All rows of a surface for targets of its own.
template<class Sources, class Add>
void add_own_rows(
  const Lanes& group, const LayerRules& rules, const RuleSources<Sources>& sources, Add add)
{
  const std::vector<int>& regular = rules.regular().start;
  int row = 0;
  for (const auto& [element, touching, close] : group.special)
  {
    add(sources.regular, row, regular[element], all_lanes);
    row = regular[element + 1];
    if (const unsigned at = touching | close; at != all_bits)
      add(sources.regular, regular[element], row, mask_of(at, 0, 1));
  }
  add(sources.regular, row, regular.back(), all_lanes);
  add_near_and_singular(group, rules, sources, add);
}

/// The difference between a surface's rows for targets of its own and all of its regular ones.
template<class Sources, class Add>
void add_corrections(
  const Lanes& group, const LayerRules& rules, const RuleSources<Sources>& sources, Add add)
{
  const std::vector<int>& regular = rules.regular().start;
  for (const auto& [element, touching, close] : group.special)
    add(sources.regular, regular[element], regular[element + 1], mask_of(touching | close, -1));
  add_near_and_singular(group, rules, sources, add);
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

StokesOperator::StokesOperator(std::vector<LayerSurface> surfaces)
  : surfaces_(std::move(surfaces)), first_{ 0 }
{
  for (const LayerSurface& s : surfaces_)
  {
    first_.push_back(first_.back() + static_cast<int>(s.vertices.rows()));
    regular_.emplace_back(s.rules->regular().table, s.control);
  }
  targets_.resize(vertices(), 3);
  for (std::size_t s = 0; s < surfaces_.size(); ++s)
    targets_.middleRows(first_[s], surfaces_[s].vertices.rows()) = surfaces_[s].vertices;
  if (surfaces_.size() > 1)
    near_ = near_vertices(surfaces_);
}

StokesOperator::FinePoints StokesOperator::fine_points(int source) const
{
  const auto& [rules, vertices, control] = surfaces_[source];
  return { LayerPoints(rules->near().table, control),
    LayerPoints(rules->singular().table, control) };
}

RuleSources<StokesletSources> StokesOperator::node_sources(int source, const FinePoints& fine) const
{
  const LayerRules& rules = *surfaces_[source].rules;
  return { vesicle::node_sources(rules.regular().table, regular_[source]),
    vesicle::node_sources(rules.near().table, fine.near),
    vesicle::node_sources(rules.singular().table, fine.singular) };
}

// For every group of targets on any surface: sums over the source's rows, 6 numbers a node and lane,
// then write(first vertex of the surface, group, sums).
template<class Write>
void StokesOperator::for_each_group(int source, Write write) const
{
  const LayerRules& rules = *surfaces_[source].rules;
  const FinePoints fine = fine_points(source);
  const RuleSources<StokesletSources> sources = node_sources(source, fine);
  std::vector<int> place(rules.vertices()); // of each node, its own
  std::iota(place.begin(), place.end(), 0);
  std::optional<NearSurfaceCorrections> near;
  if (surfaces_.size() > 1)
    near.emplace(near_surface_corrections(source, PointKind::force, fine.near));
  for (int s = 0; s < static_cast<int>(surfaces_.size()); ++s)
    parallel_for(static_cast<int>(surfaces_[s].rules->groups().size()),
      [&](int number)
      {
        const Lanes& group = surfaces_[s].rules->groups()[number];
        const auto position = positions(group, surfaces_[s].vertices);
        thread_local std::vector<double> sum;
        sum.assign(static_cast<std::size_t>(rules.vertices()) * stride, 0);
        const auto add = [&](const StokesletSources& rows, int begin, int end, const LaneMask& mask)
        {
          add_stokeslets(rows, begin, end, position.data(), mask.data(), place.data(), sum.data());
        };
        if (s == source)
          add_own_rows(group, rules, sources, add);
        else
        {
          add(sources.regular, 0, rules.regular().start.back(), all_lanes);
          for (std::size_t lane = 0; lane < group.target.size(); ++lane)
            near->for_each_node(first_[s] + group.target[lane],
              [&](int node, const double* block)
              {
                for (int c = 0; c < stokeslet_components; ++c)
                  sum[static_cast<std::size_t>(node) * stride + c * lanes + lane] += block[c];
              });
        }
        write(first_[s], group, sum.data());
      });
}

DenseMatrix StokesOperator::columns(int source, const NodalDensities& densities) const
{
  const SparseMatrix& F = densities.F;
  const LayerRules& rules = *surfaces_[source].rules;
  const int n = rules.vertices();
  const long m = F.cols();
  DenseMatrix matrix(3L * vertices(), m);
  for_each_group(source,
    [&](int first, const Lanes& group, const double* sum)
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
      for (std::size_t lane = 0; lane < group.target.size(); ++lane)
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

PointPlaces StokesOperator::places() const
{
  PointPlaces places{ {}, targets(), { 0 }, first_ };
  for (const LayerPoints& regular : regular_)
    places.first_source.push_back(
      places.first_source.back() + static_cast<int>(regular.weight.size()));
  places.sources.resize(places.first_source.back(), 3);
  for (std::size_t s = 0; s < regular_.size(); ++s)
    places.sources.middleRows(places.first_source[s], regular_[s].weight.size()) =
      regular_[s].surface.position;
  return places;
}

Eigen::VectorXd StokesOperator::apply(std::span<const ForceDensity> densities) const
{
  Points velocity = Points::Zero(vertices(), 3);
  for (std::size_t s = 0; s < surfaces_.size(); ++s)
  {
    const LayerRules& rules = *surfaces_[s].rules;
    const LayerPoints& regular = regular_[s];
    const FinePoints fine = fine_points(static_cast<int>(s));
    const LoadedPoints far(rules.regular().table, regular, densities[s]),
      close(rules.near().table, fine.near, densities[s]),
      own(rules.singular().table, fine.singular, densities[s]);
    DirectSum(regular.surface.position, targets())
      .add((far.force.array().colwise() * regular.weight.array()).matrix(), 0, velocity);
    const RuleSources<ForceSources> sources{ far.sources, close.sources, own.sources };
    parallel_for(static_cast<int>(rules.groups().size()),
      [&](int number)
      {
        const Lanes& group = rules.groups()[number];
        const auto position = positions(group, surfaces_[s].vertices);
        std::array<double, 4 * lanes> sum{};
        add_corrections(group, rules, sources,
          [&](const ForceSources& rows, int begin, int end, const LaneMask& mask)
          { add_velocities(rows, begin, end, position.data(), mask.data(), sum.data()); });
        for (std::size_t lane = 0; lane < group.target.size(); ++lane)
          for (int c = 0; c < 3; ++c)
            velocity(first_[s] + group.target[lane], c) += sum[c * lanes + lane];
      });
  }
  return velocity.reshaped<Eigen::RowMajor>();
}

// add(rows, begin, end, targets, mask, places, sums): a kernel's.
template<class Sources, class Add>
LayerCorrections StokesOperator::corrections(
  int source, const RuleSources<Sources>& sources, Add add) const
{
  const LayerRules& rules = *surfaces_[source].rules;
  LayerCorrections result(rules);
  parallel_for(static_cast<int>(rules.groups().size()),
    [&](int number)
    {
      const Lanes& group = rules.groups()[number];
      const auto position = positions(group, surfaces_[source].vertices);
      thread_local std::vector<int> place; // of each node in the group's list
      place.resize(rules.vertices());
      for (std::size_t k = 0; k < group.nodes.size(); ++k)
        place[group.nodes[k]] = static_cast<int>(k);
      double* sum = result.group(number);
      add_corrections(group, rules, sources,
        [&](const Sources& rows, int begin, int end, const LaneMask& mask)
        { add(rows, begin, end, position.data(), mask.data(), place.data(), sum); });
    });
  return result;
}

SurfaceCorrections StokesOperator::corrections(int source, PointKind kind) const
{
  const FinePoints fine = fine_points(source);
  SurfaceCorrections result{ kind == PointKind::force
      ? corrections(source, node_sources(source, fine), add_stokeslets)
      : double_layer_corrections(source, fine),
    {} };
  if (surfaces_.size() > 1)
    result.near.emplace(near_surface_corrections(source, kind, fine.near));
  return result;
}

NearSurfaceCorrections StokesOperator::near_surface_corrections(
  int source, PointKind kind, const LayerPoints& near) const
{
  return { { *surfaces_[source].rules, regular_[source], near }, targets(), near_[source], kind };
}

LayerCorrections StokesOperator::double_layer_corrections(int source, const FinePoints& fine) const
{
  const RowVectors of_regular = regular_[source].surface.cross.rowwise().normalized(),
                   of_near = fine.near.surface.cross.rowwise().normalized(),
                   of_singular = fine.singular.surface.cross.rowwise().normalized();
  const auto with_normals = [](const StokesletSources& rows, const RowVectors& normals) {
    return StressletSources{ rows, normals.data(), static_cast<int>(normals.rows()) };
  };
  const RuleSources<StokesletSources> rows = node_sources(source, fine);
  return corrections(source,
    RuleSources<StressletSources>{ with_normals(rows.regular, of_regular),
      with_normals(rows.near, of_near), with_normals(rows.singular, of_singular) },
    add_stresslets);
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
