#include "solver/stokes/PanelBasis.h"

#include "solver/stokes/PanelPolynomials.h"

namespace vesicle
{

namespace
{

// Levels of halving towards extraordinary vertices: what the last panel's polynomials miss of a
// surface that isn't smooth there is then below the error of the surface itself.
constexpr int panel_grading = 2;

}

PanelBasis::PanelBasis(const Basis& basis)
  : degree_(basis.smooth() ? smooth_panel_degree : 1), terms_(polynomial_terms(degree_))
{
  const std::vector<TrianglePoint> nodes = interpolation_nodes(degree_);
  const Eigen::MatrixXd to_coefficients = interpolation_matrix(nodes, degree_);
  const BasisTable table = basis.tabulate(basis.rule(nodes, basis.smooth() ? panel_grading : 0));
  for_each_element(table,
    [&](int begin, int end, std::span<const int> felt)
    {
      const auto width = static_cast<Eigen::Index>(felt.size());
      for (int row = begin; row < end; row += terms_)
      {
        using Values =
          Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>; // terms by nodes
        const Eigen::MatrixXd C = to_coefficients *
          Eigen::Map<const Values>(table.value.data() + table.start[row], terms_, width);
        place_.push_back(coefficients_.size());
        coefficients_.insert(coefficients_.end(), C.data(), C.data() + C.size());
        element_.push_back(elements());
      }
      node_.insert(node_.end(), felt.begin(), felt.end());
      start_.push_back(static_cast<int>(node_.size()));
      first_.push_back(static_cast<int>(element_.size()));
    });
}

Eigen::VectorXd PanelBasis::values(int panel, double u, double v) const
{
  const Monomials monomials(degree_, u, v);
  return coefficients(panel).transpose() *
    Eigen::Map<const Eigen::VectorXd>(monomials.value, terms_);
}

}
