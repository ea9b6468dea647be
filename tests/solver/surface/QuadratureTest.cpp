#include "solver/Errors.h"
#include "solver/surface/Quadrature.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vesicle
{
namespace
{

double factorial(int n)
{
  return n < 2 ? 1 : n * factorial(n - 1);
}

// ∫ u^a v^b over the reference triangle is a! b!/(a + b + 2)!.
double exact_monomial(int a, int b)
{
  return factorial(a) * factorial(b) / factorial(a + b + 2);
}

class TriangleRule : public testing::TestWithParam<std::pair<int, int>>
{
};

TEST_P(TriangleRule, IntegratesPolynomialsUpToItsDegree)
{
  const auto [points, degree] = GetParam();
  const auto rule = triangle_rule(points);
  ASSERT_EQ(rule.size(), static_cast<std::size_t>(points));
  for (int a = 0; a <= degree; ++a)
    for (int b = 0; a + b <= degree; ++b)
    {
      double sum = 0;
      for (const TrianglePoint& p : rule)
        sum += p.weight * std::pow(p.u, a) * std::pow(p.v, b);
      EXPECT_NEAR(sum, exact_monomial(a, b), 1e-14) << "u^" << a << " v^" << b;
    }
}

INSTANTIATE_TEST_SUITE_P(Rules, TriangleRule,
  testing::Values(std::pair(1, 1), std::pair(3, 2), std::pair(6, 4), std::pair(12, 6)));

TEST(TriangleRules, NameTheRulesThatExist)
{
  EXPECT_THROW(triangle_rule(5), InputError);
}

TEST(GaussLegendre, IsExactToDegreeTwiceThePointsMinusOne)
{
  for (int n = 1; n <= 8; ++n)
  {
    const GaussRule rule = gauss_legendre(n);
    for (int degree = 0; degree < 2 * n; ++degree)
    {
      double sum = 0;
      for (int i = 0; i < n; ++i)
        sum += rule.weight[i] * std::pow(rule.node[i], degree);
      EXPECT_NEAR(sum, 1. / (degree + 1), 1e-14) << n << " points, degree " << degree;
    }
  }
}

// ∫ λ/r over a flat triangle with r from a corner: with b the opposite edge's points, the radial
// part is exact and the angular integrand is analytic, so few angular points suffice.
TEST(DuffyRule, IntegratesOneOverRAroundEachCorner)
{
  const double corner_u[] = { 0, 1, 0 }, corner_v[] = { 0, 0, 1 };
  for (int corner = 0; corner < 3; ++corner)
  {
    const auto integral = [&](int radial, int angular)
    {
      double sum = 0;
      for (const TrianglePoint& p : duffy_rule(corner, radial, angular))
      {
        // An equilateral triangle with edge 1: metric |du, dv|² = du² + du dv + dv², area √3/2 du
        // dv.
        const double du = p.u - corner_u[corner], dv = p.v - corner_v[corner];
        sum += p.weight * std::sqrt(3.) / 2 / std::sqrt(du * du + du * dv + dv * dv);
      }
      return sum;
    };
    // ∫ dA/r over the triangle from its corner: height · ∫ dθ/cos θ from −30° to 30°.
    const double exact = std::sqrt(3.) / 2 * std::log(3.);
    EXPECT_NEAR(integral(1, 4), exact, 1e-4 * exact);
    EXPECT_NEAR(integral(1, 12), exact, 1e-12 * exact);
    EXPECT_NEAR(integral(3, 12), exact, 1e-12 * exact);
  }
}

}
}
