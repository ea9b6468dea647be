#include "solver/membrane/AreaDifference.h"

#include "solver/surface/CurvatureRates.h"

#include <cmath>
#include <numbers>

namespace vesicle
{

using std::numbers::pi;

double integrated_mean_curvature(const Surface& surface)
{
  if (surface.space->smooth())
    return surface.points.area_weight.dot(surface.curvature->mean);
  return surface.cotan->vertex_area.dot(vertex_curvature(surface).mean);
}

double AreaDifference::energy(const Surface& surface) const
{
  const double m = integrated_mean_curvature(surface) / std::sqrt(4 * pi * surface.area);
  return 8 * pi * pi * alpha_ * std::pow(m - m0_, 2);
}

TermForce AreaDifference::force(const Surface& surface) const
{
  const double root = std::sqrt(4 * pi * surface.area);
  const double m = integrated_mean_curvature(surface) / root;
  const Curvature curvature = vertex_curvature(surface);
  const Eigen::VectorXd density = -16 * pi * pi * alpha_ * (m - m0_) *
    (curvature.gauss / root - m / surface.area * curvature.mean);
  return { { density, {} }, {} };
}

Variation AreaDifference::variation(const Surface& surface) const
{
  const double root = std::sqrt(4 * pi * surface.area);
  const double m = integrated_mean_curvature(surface) / root;
  const Eigen::VectorXd of_mean = integrated_mean_curvature_gradient(
                          surface.space->table(), surface.points, surface.control),
                        of_area = surface.area_rate.transpose() *
    Eigen::VectorXd::Ones(surface.area_rate.rows());
  return { 16 * pi * pi * alpha_ * (m - m0_) * (of_mean / root - m / (2 * surface.area) * of_area),
    {} };
}

void AreaDifference::add_curvature_energy(const CurvedPoints& surface, CurvatureEnergy& sum) const
{
  const double A = area(surface.points), root = std::sqrt(4 * pi * A),
               m = surface.points.area_weight.dot(surface.twice_mean) / 2 / root,
               slope = 16 * pi * pi * alpha_ * (m - m0_);
  sum.energy += 8 * pi * pi * alpha_ * std::pow(m - m0_, 2);
  sum.density.value.array() += slope * (surface.twice_mean.array() / (2 * root) - m / (2 * A));
  sum.density.slope.array() += slope / (2 * root);
  sum.mean_stiffness += 16 * pi * pi * alpha_ / (root * root);
}

}
