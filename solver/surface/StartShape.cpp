#include "solver/surface/StartShape.h"

#include "solver/mesh/MeshIntegrals.h"
#include "solver/mesh/shapes/Shapes.h"
#include "solver/surface/SurfaceMeasures.h"

#include <cmath>
#include <numbers>

namespace vesicle
{

namespace
{
constexpr double reduced_volume_tolerance = 1e-7;
constexpr int max_corrections = 12;
// z of a unit vector that is −z but for rounding.
constexpr double half_turn = -1 + 1e-12;
}

// make_shape gives the reduced volume to the flat triangles; the request is shifted until it holds
// on Loop's surface (the difference hardly depends on the request, so a few corrections do).
static TriangleMesh make_loop_shape(ShapeRequest request)
{
  const auto wanted = request.reduced_volume;
  const bool adjustable = wanted && request.kind != ShapeRequest::Kind::sphere;
  TriangleMesh mesh = make_shape(request);
  SurfaceMeasures measures = surface_measures(SurfaceBasis::loop, mesh);
  for (int sweep = 0; adjustable && sweep < max_corrections; ++sweep)
  {
    const double error = *wanted - reduced_volume(measures.area, measures.volume);
    if (std::abs(error) < reduced_volume_tolerance)
      break;
    *request.reduced_volume += error;
    mesh = make_shape(request);
    measures = surface_measures(SurfaceBasis::loop, mesh);
  }
  mesh.points *= std::cbrt(4 * std::numbers::pi / (3 * measures.volume));
  return mesh;
}

TriangleMesh make_start_shape(const ShapeRequest& request, SurfaceBasis basis)
{
  return basis == SurfaceBasis::linear ? make_shape(request) : make_loop_shape(request);
}

Eigen::Matrix3d turn_z_to(const Vector3& axis)
{
  const Vector3 to = axis.normalized();
  const double s = std::sqrt((1 + to.z()) * 2), inverse = 1 / s;
  // What Quaterniond::FromTwoVectors does, which would compile a singular value decomposition to find
  // an axis of the half turn to −z.
  const Eigen::Quaterniond turn = to.z() < half_turn
    ? Eigen::Quaterniond(0, -1, 0, 0)
    : Eigen::Quaterniond(0.5 * s, -to.y() * inverse, to.x() * inverse, 0);
  return turn.toRotationMatrix();
}

void place(TriangleMesh& shape, double radius, const Eigen::Matrix3d& turn, const Vector3& center)
{
  shape.points = (radius * shape.points * turn.transpose()).eval();
  shape.points.rowwise() += center.transpose();
}

}
