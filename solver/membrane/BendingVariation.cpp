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
  EntryVectors R(rates.of_area.rows(), 3);
  const Points gradient = nodal_sum<3>(table,
    [&](Points& sum, int q)
    {
      const double root = std::sqrt(surface.area_weight[q] / 2), excess = rates.twice_mean[q] - c0;
      for (int k = table.start[q]; k < table.start[q + 1]; ++k)
      {
        R.row(k) = root * (rates.of_twice_mean.row(k) + excess / 2 * rates.of_area.row(k));
        sum.row(table.node[k]) += 2 * root * excess * R.row(k);
      }
    });
  Variation result{ gradient.reshaped<Eigen::RowMajor>(), {} };
  result.rates.push_back(std::move(R));
  return result;
}

}
