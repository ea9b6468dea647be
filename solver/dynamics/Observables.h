#pragma once
// What the field reports of a vesicle's shape and motion.

#include "solver/mesh/TriangleMesh.h"

#include <array>
#include <optional>

namespace vesicle
{

/// The ellipsoid with the same second moments as the enclosed volume.
struct InertiaEllipsoid
{
  std::array<double, 3> semi_axes;       ///< descending
  std::array<Vector3, 3> directions;     ///< unit, in the same order
  std::optional<double> inclination_deg; ///< long axis, projected on x–z, to +x, in (−90, 90]
  std::optional<double> tilt_deg;        ///< long axis to z, 0 to 90
};
InertiaEllipsoid inertia_ellipsoid(const TriangleMesh& mesh);

/// Angular frequency of the surface flow along the contour in the plane y = y_center:
/// 2π/∮ ds/|u_t|, u_t the velocity relative to `frame` along the contour; 0 where the flow doesn't
/// go around.
double tank_treading_frequency(
  const TriangleMesh& mesh, const Points& velocity, const Vector3& center, const Vector3& frame);

}
