#pragma once
// What the field reports of a vesicle's shape and motion.

#include "solver/surface/SurfaceIntegrals.h"

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
/// `center`: of the volume, here and below.
InertiaEllipsoid inertia_ellipsoid(const SurfacePoints& surface, const Vector3& center);

/// Particle stresslet, the symmetric traceless first moment of what the fluid exerts on the
/// membrane: S_ij = −½ ∮ (f_i x_j + f_j x_i) dS + ⅓ δ_ij ∮ f·x dS, x from the centre, f the
/// membrane's force density on the fluid. That is Batchelor's (J. Fluid Mech. 41 (1970) 545) for
/// equal viscosities, otherwise interface_stresslet is to be added: positive along the strain
/// it resists, (20/3) π μ a³ E for a rigid sphere. A dilute suspension's mean stress gains n S, and
/// in a shear u = rate z e_x its intrinsic viscosity is [η] = S_xz/(μ rate V). A pressure (f ∝ n)
/// and gravity's load have none. `force`: the density but for the tension's, at the surface's rows,
/// or empty. `tension`: γ at the rows, or empty; its force ∇_s γ − 2 γ H n enters by its virtual
/// work, ∮ f_i x_j dS = −∮ γ (δ_ij − n_i n_j) dS.
Eigen::Matrix3d stresslet(const SurfacePoints& surface, const Vector3& center,
  const RowVectors& force, const Eigen::VectorXd& tension);

/// ∮ (u_i n_j + u_j n_i) dS less its trace, u at the surface's rows: times (λ − 1) μ what the
/// stresslet of a membrane between two fluids has beside its forces'.
Eigen::Matrix3d interface_stresslet(const SurfacePoints& surface, const RowVectors& velocity);

/// Amplitudes a_lm = ∮ r Y_lm dΩ of the shape r(θ, φ) = Σ a_lm Y_lm seen from the centre, l ≤
/// degree, by harmonic_index (SphericalHarmonics.h), as surface integrals: dΩ = x·n dS/r³. Empty
/// where the shape isn't star-shaped about the centre (x·n ≤ 0 somewhere).
std::optional<Eigen::VectorXd> harmonic_amplitudes(
  const SurfacePoints& surface, const Vector3& center, int degree);

/// Angular frequency of the surface flow along the contour in the plane y = y_center:
/// 2π/∮ ds/|u_t|, u_t the velocity relative to `frame` along the contour; 0 where the flow doesn't
/// go around.
double tank_treading_frequency(
  const TriangleMesh& mesh, const Points& velocity, const Vector3& center, const Vector3& frame);

}
