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
  for (int sweep = 0;; ++sweep)
  {
    const AreaAndVolume now(space, points);
    const Eigen::Vector2d error(
      volume_only ? 0 : target_area - now.area(), target_volume - now.volume());
    const double area = std::abs(error[0]) / target_area,
                 volume = std::abs(error[1]) / target_volume;
    if (sweep == 0)
      result = { area, volume };
    result.left = area + volume;
    if ((area <= tolerance && volume <= tolerance) || sweep == max_sweeps)
      return result;

    const AreaAndVolume::Changes c = now.changes();
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
}

}
