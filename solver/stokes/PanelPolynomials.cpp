#include "solver/stokes/PanelPolynomials.h"

#include <Eigen/LU>

namespace vesicle
{

std::vector<TrianglePoint> interpolation_nodes(int degree)
{
  constexpr double inset = 0.4; // of the distance between two nodes
  std::vector<TrianglePoint> nodes;
  for (int i = 0; i <= degree; ++i)
    for (int j = 0; i + j <= degree; ++j)
      nodes.push_back(
        { (i + inset) / (degree + 3 * inset), (j + inset) / (degree + 3 * inset), 1 });
  return nodes;
}

Eigen::MatrixXd interpolation_matrix(const std::vector<TrianglePoint>& nodes, int degree)
{
  const auto n = static_cast<Eigen::Index>(nodes.size());
  Eigen::MatrixXd values(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    values.row(i) =
      Eigen::Map<const Eigen::RowVectorXd>(Monomials(degree, nodes[i].u, nodes[i].v).value, n);
  return values.inverse();
}

}
