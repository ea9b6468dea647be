#include "solver/stokes/NearRule.h"

namespace vesicle
{

const GaussRule& near_gauss_rule(double length)
{
  constexpr int most = 48;
  static const auto rules = []
  {
    std::array<GaussRule, most + 1> all;
    for (int n = 1; n <= most; ++n)
      all[n] = gauss_legendre(n);
    return all;
  }();
  const int points = 5 + static_cast<int>(std::ceil(1.5 * length));
  return rules[std::min(points, most)];
}

}
