#pragma once
// Quadrature on the reference triangle {u, v ≥ 0, u + v ≤ 1} and on [0, 1].

#include <span>
#include <vector>

namespace vesicle
{

/// A point of the parametric domain of one element. Corner 0 is (0, 0), corner 1 (1, 0), corner 2
/// (0, 1).
struct ParametricPoint
{
  int element;
  double u, v;
  double weight; ///< parametric weight; the weights of a rule on one element sum to 1/2
};

struct TrianglePoint
{
  double u, v, weight;
};

/// Symmetric rules with 1, 3, 6 or 12 inner points, exact to degree 1, 2, 4, 6 (Dunavant, Int. J.
/// Numer. Meth. Engng 21 (1985) 1129). Weights sum to 1/2. Throws InputError for other counts.
std::span<const TrianglePoint> triangle_rule(int points);

/// Duffy rule for integrands that are singular as 1/r at `corner`: ρ is the distance from the
/// corner (0 to 1), t runs along the opposite edge; λ = (1 − ρ, ρ(1 − t), ρ t). The Jacobian ρ,
/// part of the weight, cancels the singularity; on a flat element the radial integral of 1/r times
/// a linear density is then exact with one radial point.
/// Where distances in space grow as ρ^exponent, as they do around an extraordinary vertex, the
/// radial points are spread accordingly: ρ = s^{1/exponent} with Gauss points s.
std::vector<TrianglePoint> duffy_rule(
  int corner, int radial_points, int angular_points, double exponent = 1);

/// Gauss–Legendre nodes and weights on [0, 1].
struct GaussRule
{
  std::vector<double> node, weight;
};
GaussRule gauss_legendre(int points);

}
