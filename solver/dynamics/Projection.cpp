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

ProjectionResult project_area_and_volume(Points& points, const SurfaceSpace& space,
  double target_area, double target_volume, bool volume_only)
{
  ProjectionResult result;
  for (int sweep = 0; sweep < max_sweeps; ++sweep)
  {
    const AreaAndVolume c = area_and_volume(space, points);
    const Eigen::Vector2d error(volume_only ? 0 : target_area - c.area, target_volume - c.volume);
    if (sweep == 0)
      result = { std::abs(error[0]) / target_area, std::abs(error[1]) / target_volume };
    if (std::abs(error[0]) <= tolerance * target_area &&
      std::abs(error[1]) <= tolerance * target_volume)
      break;

    Eigen::VectorXd shift;
    if (volume_only)
      shift = error[1] / c.volume_gradient.dot(c.volume_direction) * c.volume_direction;
    else
    {
      Eigen::Matrix2d J;
      J << c.area_gradient.dot(c.area_direction), c.area_gradient.dot(c.volume_direction),
        c.volume_gradient.dot(c.area_direction), c.volume_gradient.dot(c.volume_direction);
      const Eigen::Vector2d x = J.partialPivLu().solve(error);
      shift = x[0] * c.area_direction + x[1] * c.volume_direction;
    }
    points += rows_of_three(shift);
  }
  return result;
}

}
