#include "solver/surface/Quadrature.h"

#include "solver/Errors.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

namespace vesicle
{

namespace
{

// Orbits of the symmetric group: (a, a, 1 − 2a) has three points, (a, b, 1 − a − b) six.
void add_orbit3(std::vector<TrianglePoint>& rule, double a, double weight)
{
  const double b = 1 - 2 * a;
  for (auto [u, v] : { std::array{ a, a }, std::array{ b, a }, std::array{ a, b } })
    rule.push_back({ u, v, weight / 2 });
}

void add_orbit6(std::vector<TrianglePoint>& rule, double a, double b, double weight)
{
  const double c = 1 - a - b;
  for (auto [u, v] : { std::array{ a, b }, std::array{ b, a }, std::array{ a, c },
         std::array{ c, a }, std::array{ b, c }, std::array{ c, b } })
    rule.push_back({ u, v, weight / 2 });
}

std::vector<TrianglePoint> make_triangle_rule(int points)
{
  std::vector<TrianglePoint> rule;
  switch (points)
  {
    case 1:
      rule.push_back({ 1. / 3, 1. / 3, 0.5 });
      break;
    case 3:
      add_orbit3(rule, 1. / 6, 1. / 3);
      break;
    case 6:
      add_orbit3(rule, 0.445948490915965, 0.223381589678011);
      add_orbit3(rule, 0.091576213509771, 0.109951743655322);
      break;
    case 12:
      add_orbit3(rule, 0.249286745170910, 0.116786275726379);
      add_orbit3(rule, 0.063089014491502, 0.050844906370207);
      add_orbit6(rule, 0.310352451033785, 0.053145049844816, 0.082851075618374);
      break;
    default:
      throw InputError(fmt::format(
        "triangle quadrature with {} points: there are rules with 1, 3, 6 and 12", points));
  }
  return rule;
}

}

std::span<const TrianglePoint> triangle_rule(int points)
{
  static const std::array rules{ make_triangle_rule(1), make_triangle_rule(3),
    make_triangle_rule(6), make_triangle_rule(12) };
  switch (points)
  {
    case 1:
      return rules[0];
    case 3:
      return rules[1];
    case 6:
      return rules[2];
    case 12:
      return rules[3];
    default:
      make_triangle_rule(points); // throws
      return {};
  }
}

GaussRule gauss_legendre(int points)
{
  GaussRule rule;
  for (int i = 0; i < points; ++i)
  {
    // Newton on P_n from the Chebyshev guess; the derivative comes with the recurrence.
    double x = std::cos(std::numbers::pi * (i + 0.75) / (points + 0.5)), derivative = 1;
    for (int sweep = 0; sweep < 100; ++sweep)
    {
      double p = 1, previous = 0;
      for (int k = 1; k <= points; ++k)
      {
        const double next = ((2 * k - 1) * x * p - (k - 1) * previous) / k;
        previous = p;
        p = next;
      }
      derivative = points * (x * p - previous) / (x * x - 1);
      const double correction = p / derivative;
      x -= correction;
      if (std::abs(correction) < 1e-15)
        break;
    }
    rule.node.push_back((1 - x) / 2);
    rule.weight.push_back(1 / ((1 - x * x) * derivative * derivative));
  }
  return rule;
}

std::vector<TrianglePoint> duffy_rule(
  int corner, int radial_points, int angular_points, double exponent)
{
  const GaussRule radial = gauss_legendre(radial_points), angular = gauss_legendre(angular_points);
  std::vector<TrianglePoint> rule;
  for (int a = 0; a < radial_points; ++a)
    for (int b = 0; b < angular_points; ++b)
    {
      const double s = radial.node[a], t = angular.node[b];
      const double rho = std::pow(s, 1 / exponent), drho = rho / (s * exponent);
      std::array<double, 3> lambda;
      lambda[corner] = 1 - rho;
      lambda[(corner + 1) % 3] = rho * (1 - t);
      lambda[(corner + 2) % 3] = rho * t;
      rule.push_back({ lambda[1], lambda[2], radial.weight[a] * angular.weight[b] * rho * drho });
    }
  return rule;
}

}
