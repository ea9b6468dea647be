#include "solver/geometry/Basis.h"

namespace vesicle
{

LinearBasis::LinearBasis(Triangles triangles, int nodes)
  : triangles_(std::move(triangles)), nodes_(nodes)
{
}

BasisTable LinearBasis::tabulate(std::span<const ParametricPoint> points) const
{
  static constexpr double du[3] = { -1, 1, 0 }, dv[3] = { -1, 0, 1 };
  BasisTable table;
  table.nodes = nodes_;
  for (const ParametricPoint& p : points)
  {
    const double value[3] = { 1 - p.u - p.v, p.u, p.v };
    table.element.push_back(p.element);
    table.weight.push_back(p.weight);
    for (int corner = 0; corner < 3; ++corner)
    {
      table.node.push_back(triangles_(p.element, corner));
      table.value.push_back(value[corner]);
      table.du.push_back(du[corner]);
      table.dv.push_back(dv[corner]);
    }
    table.start.push_back(static_cast<int>(table.node.size()));
  }
  return table;
}

BasisTable tabulate_rule(const Basis& basis, std::span<const TrianglePoint> rule)
{
  std::vector<ParametricPoint> points;
  for (int e = 0; e < basis.elements().rows(); ++e)
    for (const TrianglePoint& p : rule)
      points.push_back({ e, p.u, p.v, p.weight });
  return basis.tabulate(points);
}

}
