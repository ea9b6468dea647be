#include "solver/stokes/LayerRules.h"

#include "solver/stokes/kernels/StokesletKernel.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <numeric>

namespace vesicle
{

namespace
{

LayerRules::Rule element_rule(const Basis& basis, int points, int graded)
{
  const std::vector<ParametricPoint> rule = basis.rule(triangle_rule(points), graded);
  std::vector<int> start(basis.elements().rows() + 1, 0);
  for (const ParametricPoint& p : rule)
    ++start[p.element + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  return { basis.tabulate(rule), std::move(start) };
}

void sort_out_repeats(std::vector<int>& numbers)
{
  std::ranges::sort(numbers);
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
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
    sort_out_repeats(around);
    std::set_difference(around.begin(), around.end(), elements.begin(i), elements.end(i),
      std::back_inserter(result.item));
    result.start.push_back(static_cast<int>(result.item.size()));
  }
  return result;
}

// The vertices in groups that are close together on the mesh where possible: grown from
// the first vertex left over.
std::vector<std::vector<int>> group_neighbours(const AdjacencyList& neighbours)
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
    for (; next < order.size() && order.size() % stokeslet_lanes != 0; ++next)
      for (const int* j = neighbours.begin(order[next]); j != neighbours.end(order[next]); ++j)
        if (!taken[*j] && order.size() % stokeslet_lanes != 0)
          take(*j);
  }
  std::vector<std::vector<int>> groups;
  for (int i = 0; i < n; i += stokeslet_lanes)
    groups.emplace_back(order.begin() + i, order.begin() + std::min(i + stokeslet_lanes, n));
  return groups;
}

}

LayerQuadrature layer_quadrature(const Basis& basis, int regular)
{
  if (!basis.smooth())
    return { .regular = regular };
  if (regular < 6)
    return { .regular = regular, .near = 6, .graded = 1, .radial = 3, .angular = 4 };
  return {
    .regular = regular, .near = regular < 12 ? 12 : 0, .graded = 2, .radial = 4, .angular = 6
  };
}

LayerRules::LayerRules(const Basis& basis, const LayerQuadrature& quadrature)
  : regular_(element_rule(basis, quadrature.regular, quadrature.graded)),
    panels_(std::make_unique<const LazyPanelBasis>(basis))
{
  const Connectivity connectivity(basis.elements(), basis.nodes());
  touching_ = connectivity.vertex_triangles;
  close_.start.assign(basis.nodes() + 1, 0);
  near_.start.assign(basis.elements().rows() + 1, 0);
  if (quadrature.near > 0)
  {
    close_ = second_ring(connectivity);
    near_ = element_rule(basis, quadrature.near, quadrature.graded);
  }

  // Tabulated element by element, which the basis does fastest, then grouped by vertex.
  std::vector<ParametricPoint> points;
  for (int i = 0; i < basis.nodes(); ++i)
  {
    singular_.start.push_back(static_cast<int>(points.size()));
    for (const int* e = touching_.begin(i); e != touching_.end(i); ++e)
      for (int corner = 0; corner < 3; ++corner)
        if (basis.elements()(*e, corner) == i)
          for (const TrianglePoint& p :
            duffy_rule(corner, quadrature.radial, quadrature.angular, basis.radial_exponent(i)))
            points.push_back({ *e, p.u, p.v, p.weight });
  }
  singular_.start.push_back(static_cast<int>(points.size()));
  singular_.table = basis.tabulate(points);
  for (std::vector<int>& targets : group_neighbours(connectivity.vertex_neighbours))
    groups_.push_back(group_of(std::move(targets)));
}

LayerRules::Group LayerRules::group_of(std::vector<int> targets) const
{
  Group group{ std::move(targets), {}, {} };
  std::map<int, Group::Special> special;
  const auto mark = [&](const AdjacencyList& list, std::uint8_t Group::Special::*lanes)
  {
    for (std::size_t lane = 0; lane < group.target.size(); ++lane)
      for (const int* e = list.begin(group.target[lane]); e != list.end(group.target[lane]); ++e)
        special.try_emplace(*e, Group::Special{ *e, 0, 0 }).first->second.*lanes |= 1U << lane;
  };
  mark(touching_, &Group::Special::touching);
  mark(close_, &Group::Special::close);
  const BasisTable& table = regular_.table;
  for (const auto& [element, of_element] : special)
  {
    group.special.push_back(of_element);
    const int row = regular_.start[element];
    group.nodes.insert(group.nodes.end(), table.node.begin() + table.start[row],
      table.node.begin() + table.start[row + 1]);
  }
  sort_out_repeats(group.nodes);
  return group;
}

}
