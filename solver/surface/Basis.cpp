#include "solver/surface/Basis.h"

#include "solver/mesh/VertexNormals.h"

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

SparseMatrix LinearBasis::collocation() const
{
  SparseMatrix P(nodes_, nodes_);
  P.setIdentity();
  return P;
}

Points LinearBasis::vertex_normals(const Points& control) const
{
  return vesicle::vertex_normals(control, triangles_);
}

namespace
{

// A triangle of the parametric domain by its corners.
struct Cell
{
  std::array<Eigen::Vector2d, 3> corner;
  std::array<bool, 3> rough;
};

void add_rule(std::vector<ParametricPoint>& points, int element, const Cell& cell,
  std::span<const TrianglePoint> rule, double scale, int graded)
{
  const auto& [a, b, c] = cell.corner;
  const auto& [rough_a, rough_b, rough_c] = cell.rough;
  if (graded == 0 || !(rough_a || rough_b || rough_c))
  {
    for (const TrianglePoint& p : rule)
    {
      const Eigen::Vector2d x = a + p.u * (b - a) + p.v * (c - a);
      points.push_back({ element, x[0], x[1], scale * p.weight });
    }
    return;
  }
  const Eigen::Vector2d ab = (a + b) / 2, bc = (b + c) / 2, ca = (c + a) / 2;
  for (const Cell& child : { Cell{ { a, ab, ca }, { rough_a, false, false } },
         Cell{ { ab, b, bc }, { false, rough_b, false } },
         Cell{ { ca, bc, c }, { false, false, rough_c } }, Cell{ { bc, ca, ab }, {} } })
    add_rule(points, element, child, rule, scale / 4, graded - 1);
}

}

std::vector<ParametricPoint> Basis::rule(std::span<const TrianglePoint> rule, int graded) const
{
  return this->rule(rule, graded, 0, static_cast<int>(elements().rows()));
}

std::vector<ParametricPoint> Basis::rule(
  std::span<const TrianglePoint> rule, int graded, int first, int last) const
{
  std::vector<ParametricPoint> points;
  for (int e = first; e < last; ++e)
    add_rule(points, e,
      { { Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 1) }, rough_corners(e) },
      rule, 1, graded);
  return points;
}

BasisTable tabulate_rule(const Basis& basis, std::span<const TrianglePoint> rule, int graded)
{
  return basis.tabulate(basis.rule(rule, graded));
}

}
