#include "solver/mesh/shapes/ParametrisedSurface.h"

#include <Eigen/Geometry>

namespace vesicle
{

SurfaceElement surface_element(const SphericalParametrisation& surface, const Vector3& direction)
{
  const double step = 3e-4; // rounding and truncation of second differences balance
  SurfaceElement element;
  element.across.col(0) = direction.unitOrthogonal();
  element.across.col(1) = direction.cross(element.across.col(0));
  const auto at = [&](int i, int j)
  { return surface((direction + step * (element.across * Eigen::Vector2d(i, j))).normalized()); };
  element.point = at(0, 0);
  const Vector3 right = at(1, 0), left = at(-1, 0), up = at(0, 1), down = at(0, -1);
  element.tangents.col(0) = (right - left) / (2 * step);
  element.tangents.col(1) = (up - down) / (2 * step);
  const Vector3 cross = element.tangents.col(0).cross(element.tangents.col(1));
  element.stretch = cross.norm();
  element.normal = cross / element.stretch;
  const auto form = [&](const Vector3& second) { return -second.dot(element.normal); };
  const double uu = form(right - 2 * element.point + left) / (step * step),
               vv = form(up - 2 * element.point + down) / (step * step),
               uv = form(at(1, 1) - at(1, -1) - at(-1, 1) + at(-1, -1)) / (4 * step * step);
  const Eigen::Matrix2d metric = element.tangents.transpose() * element.tangents;
  const double determinant = element.stretch * element.stretch;
  element.mean =
    (metric(1, 1) * uu - 2 * metric(0, 1) * uv + metric(0, 0) * vv) / (2 * determinant);
  element.gauss = (uu * vv - uv * uv) / determinant;
  return element;
}

}
