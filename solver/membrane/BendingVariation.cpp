#include "solver/membrane/BendingVariation.h"

#include "solver/surface/CurvatureRates.h"

#include <cmath>

namespace vesicle
{

Variation bending_variation(
  const BasisTable& table, const SurfacePoints& surface, const Points& control, double c0)
{
  const CurvatureRates rates = curvature_rates(table, surface, control);
  const int rows = table.rows();
  Variation result;
  result.rates.resize(rows, 3L * table.nodes);
  result.rates.resizeNonZeros(3 * static_cast<Eigen::Index>(table.node.size()));
  int* outer = result.rates.outerIndexPtr();
  int* inner = result.rates.innerIndexPtr();
  double* value = result.rates.valuePtr();
  Eigen::VectorXd residual(rows);
  for (int q = 0; q < rows; ++q)
  {
    const double root = std::sqrt(surface.area_weight[q] / 2), excess = rates.twice_mean[q] - c0;
    residual[q] = root * excess;
    outer[q] = 3 * table.start[q];
    for (int k = table.start[q]; k < table.start[q + 1]; ++k)
      for (int d = 0; d < 3; ++d)
      {
        inner[3 * k + d] = 3 * table.node[k] + d;
        value[3 * k + d] = root * (rates.of_twice_mean(k, d) + excess / 2 * rates.of_area(k, d));
      }
  }
  outer[rows] = 3 * table.start[rows];
  result.gradient = 2 * (result.rates.transpose() * residual);
  return result;
}

}
