#include "solver/dynamics/Observables.h"

#include "solver/mesh/shapes/SphericalHarmonics.h"

#include <Eigen/Eigenvalues>

#include <cmath>
#include <limits>
#include <numbers>

namespace vesicle
{

namespace
{

constexpr double degrees = 180 / std::numbers::pi;
// Two semi-axes closer than this, relatively, have no direction worth reporting.
constexpr double degenerate_axes = 1e-6;

// A long axis along z is reported as +90° whatever the rounding.
constexpr double vertical_slack = 1e-6;

using Row3 = Eigen::RowVector3d;

// n dS at the rows.
RowVectors area_vectors(const SurfacePoints& surface)
{
  return surface.cross.rowwise().normalized().array().colwise() * surface.area_weight.array();
}

RowVectors from_center(const SurfacePoints& surface, const Vector3& center)
{
  return surface.position.rowwise() - center.transpose();
}

}

InertiaEllipsoid inertia_ellipsoid(const SurfacePoints& surface, const Vector3& center)
{
  const RowVectors x = from_center(surface, center);
  const Eigen::VectorXd flux = x.cwiseProduct(area_vectors(surface)).rowwise().sum(); // x·n dS
  // ∫ f dV = ∮ f x·n dS/(3 + k) for f homogeneous of degree k.
  const double volume = flux.sum() / 3;
  const Eigen::Matrix3d moment = x.transpose() * flux.asDiagonal() * x / 5;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(moment);
  InertiaEllipsoid result;
  for (int i = 0; i < 3; ++i)
  {
    // An ellipsoid has ∫ x² dV = V a²/5.
    result.semi_axes[i] = std::sqrt(std::max(0., 5 * eigen.eigenvalues()[2 - i] / volume));
    result.directions[i] = eigen.eigenvectors().col(2 - i);
  }
  if (result.semi_axes[0] - result.semi_axes[1] > degenerate_axes * result.semi_axes[0])
  {
    const Vector3 axis = result.directions[0];
    result.tilt_deg = degrees * std::atan2(std::hypot(axis.x(), axis.y()), std::abs(axis.z()));
    if (std::hypot(axis.x(), axis.z()) > degenerate_axes)
    {
      double angle = degrees * std::atan2(axis.z(), axis.x());
      if (angle <= -90 + vertical_slack)
        angle += 180;
      else if (angle > 90)
        angle -= 180;
      result.inclination_deg = angle;
    }
  }
  return result;
}

namespace
{

Eigen::Matrix3d symmetric_traceless(const Eigen::Matrix3d& matrix)
{
  return (matrix + matrix.transpose()) / 2 - matrix.trace() / 3 * Eigen::Matrix3d::Identity();
}

}

Eigen::Matrix3d stresslet(const SurfacePoints& surface, const Vector3& center,
  const RowVectors& force, const Eigen::VectorXd& tension)
{
  Eigen::Matrix3d moment = Eigen::Matrix3d::Zero(); // −∮ f x dS but for an isotropic part
  if (force.rows() > 0)
    moment -= force.transpose() * surface.area_weight.asDiagonal() * from_center(surface, center);
  if (tension.size() > 0)
    moment -= area_vectors(surface).transpose() * tension.asDiagonal() *
      surface.cross.rowwise().normalized();
  return symmetric_traceless(moment);
}

Eigen::Matrix3d interface_stresslet(const SurfacePoints& surface, const RowVectors& velocity)
{
  const Eigen::Matrix3d moment =
    velocity.transpose() * surface.area_weight.asDiagonal() * surface.cross.rowwise().normalized();
  return 2 * symmetric_traceless(moment);
}

std::optional<Eigen::VectorXd> harmonic_amplitudes(
  const SurfacePoints& surface, const Vector3& center, int degree)
{
  const RowVectors x = from_center(surface, center);
  const Eigen::VectorXd flux = x.cwiseProduct(area_vectors(surface)).rowwise().sum();
  if (flux.minCoeff() <= 0)
    return std::nullopt;
  return harmonic_moments(
    degree, x.rowwise().normalized(), flux.cwiseQuotient(x.rowwise().squaredNorm()));
}

double tank_treading_frequency(
  const TriangleMesh& mesh, const Points& velocity, const Vector3& center, const Vector3& frame)
{
  double time = 0;
  bool forward = false, backward = false;
  for (const auto& t : mesh.triangles.rowwise())
  {
    // The triangle's cut with the plane: ends and their flow. Its direction n × e_y is the same
    // sense around the vesicle for all triangles, and stays exact where the cut is a mere point.
    Row3 point[2], flow = Row3::Zero();
    int ends = 0;
    for (int k = 0; k < 3; ++k)
    {
      const int i = t[k], j = t[(k + 1) % 3];
      const double di = mesh.points(i, 1) - center.y(), dj = mesh.points(j, 1) - center.y();
      if ((di < 0) == (dj < 0))
        continue;
      const double s = di / (di - dj);
      point[ends++] = (1 - s) * mesh.points.row(i) + s * mesh.points.row(j);
      flow += 0.5 * ((1 - s) * velocity.row(i) + s * velocity.row(j));
    }
    if (ends != 2)
      continue;
    const Row3 normal = (mesh.points.row(t[1]) - mesh.points.row(t[0]))
                          .cross(mesh.points.row(t[2]) - mesh.points.row(t[0]));
    const double speed = (flow - frame.transpose()).dot(normal.cross(Row3::UnitY()).normalized());
    (speed >= 0 ? forward : backward) = true;
    if (speed == 0 || (forward && backward))
      return 0;
    time += (point[1] - point[0]).norm() / std::abs(speed);
  }
  return time > 0 && std::isfinite(time) ? 2 * std::numbers::pi / time : 0;
}

}
