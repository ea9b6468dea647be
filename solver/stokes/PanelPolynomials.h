#pragma once
// Polynomials of the coordinates of a panel, a triangle u, v ≥ 0, u + v ≤ 1, and how they are
// interpolated.

#include "solver/surface/Quadrature.h"

#include <Eigen/Core>

#include <vector>

namespace vesicle
{

/// On smooth surfaces; on flat triangles 1.
inline constexpr int smooth_panel_degree = 4;
inline constexpr int polynomial_terms(int degree)
{
  return (degree + 1) * (degree + 2) / 2;
}

/// Monomials u^i v^j of total degree 0, 1, …, in each by ascending j, and their derivatives.
struct Monomials
{
  static constexpr int most = polynomial_terms(smooth_panel_degree);
  double value[most], du[most], dv[most];

  Monomials(int degree, double u, double v)
  {
    double power_u[smooth_panel_degree + 1] = { 1 }, power_v[smooth_panel_degree + 1] = { 1 };
    for (int i = 1; i <= degree; ++i)
    {
      power_u[i] = power_u[i - 1] * u;
      power_v[i] = power_v[i - 1] * v;
    }
    int term = 0;
    for (int d = 0; d <= degree; ++d)
      for (int j = 0; j <= d; ++j, ++term)
      {
        const int i = d - j;
        value[term] = power_u[i] * power_v[j];
        du[term] = i > 0 ? i * power_u[i - 1] * power_v[j] : 0;
        dv[term] = j > 0 ? j * power_u[i] * power_v[j - 1] : 0;
      }
  }
};

/// Nodes inside the triangle, away from the corners, where second derivatives may not exist. The
/// weights are 1: a rule of them tells the share of the element's domain that a panel has.
std::vector<TrianglePoint> interpolation_nodes(int degree);

/// Coefficients of the monomials = this · values at the nodes.
Eigen::MatrixXd interpolation_matrix(const std::vector<TrianglePoint>& nodes, int degree);

}
