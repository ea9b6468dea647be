#include "solver/dynamics/Projection.h"

#include <Eigen/LU>

#include <cmath>

namespace vesicle
{

namespace
{

// Area and volume end within this of their targets, relative; quadratic convergence gets there in
// two or three sweeps.
constexpr double tolerance = 1e-13;
constexpr int max_sweeps = 6;

}

ProjectionResult project_area_and_volume(Points& points, const BasisTable& table,
  double target_area, double target_volume, bool volume_only)
{
  ProjectionResult result;
  for (int sweep = 0; sweep < max_sweeps; ++sweep)
  {
    const SurfacePoints s = evaluate(table, points);
    const Eigen::Vector2d error(
      volume_only ? 0 : target_area - area(s), target_volume - volume(table, s));
    if (sweep == 0)
      result = { std::abs(error[0]) / target_area, std::abs(error[1]) / target_volume };
    if (std::abs(error[0]) <= tolerance * target_area &&
      std::abs(error[1]) <= tolerance * target_volume)
      break;

    const Eigen::VectorXd mass = vertex_areas(table, s).replicate(1, 3).reshaped<Eigen::RowMajor>();
    const Eigen::VectorXd volume_gradient = vesicle::volume_gradient(table, s);
    const Eigen::VectorXd along_volume = volume_gradient.cwiseQuotient(mass);
    Eigen::VectorXd shift;
    if (volume_only)
      shift = error[1] / volume_gradient.dot(along_volume) * along_volume;
    else
    {
      const SparseMatrix B = area_rate_matrix(table, s);
      const Eigen::VectorXd area_gradient = B.transpose() * Eigen::VectorXd::Ones(points.rows());
      const Eigen::VectorXd along_area = area_gradient.cwiseQuotient(mass);
      Eigen::Matrix2d J;
      J << area_gradient.dot(along_area), area_gradient.dot(along_volume),
        volume_gradient.dot(along_area), volume_gradient.dot(along_volume);
      const Eigen::Vector2d x = J.partialPivLu().solve(error);
      shift = x[0] * along_area + x[1] * along_volume;
    }
    points += rows_of_three(shift);
  }
  return result;
}

}
