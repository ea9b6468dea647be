#include "solver/membrane/BendingVariation.h"

#include "solver/surface/CurvatureRates.h"
#include "solver/surface/NodalSum.h"

#include <cmath>

namespace vesicle
{

Variation bending_variation(
  const BasisTable& table, const SurfacePoints& surface, const Points& control, double c0)
{
  const CurvatureRates rates = curvature_rates(table, surface, control);
  const auto root = [&](int q) { return std::sqrt(surface.area_weight[q] / 2); };
  const auto excess = [&](int q) { return rates.twice_mean[q] - c0; };
  const auto rate = [&](int q)
  {
    CurvatureRates::Gradient gradient = rates.of_twice_mean[q];
    gradient.leftCols<2>() += excess(q) / 2 * rates.of_area[q];
    return CurvatureRates::Gradient(root(q) * gradient);
  };
  const auto fields = curvature_fields(table);
  Variation result{ nodal_gradient(table, fields,
                      [&](int q)
                      { return CurvatureRates::Gradient(2 * root(q) * excess(q) * rate(q)); }),
    {} };
  result.rates.push_back(entry_gradients(table, fields, rate));
  return result;
}

}
