#pragma once
// What a wall z = 0 at which the fluid sticks adds to the velocity at x that a force or a stresslet at
// y makes, both above it (J. Blake, Math. Proc. Camb. Phil. Soc. 70 (1971) 303, for the force).

// Both follow from one thought (Z. Gimbutas, L. Greengard, S. Veerapaneni, J. Fluid Mech. 776 (2015)
// R1). The mirrored flow taken from the flow v leaves 2 v_z e_z at the wall. z ∇φ − φ e_z is a Stokes
// flow where φ is harmonic, with the pressure 2 μ ∂φ/∂z, and takes that away if φ = 2 v_z at the wall.
// With the mirror point y*, X = y* − x, r = |X|, h = y_z = −y*_z, and mirrored strengths f, s, n,

// clang-format off
//
//   force      φ = −2 (f_z − h f·X/r²)/r
//              u = −(f + X f·X/r²)/r + z ∇φ − φ e_z
//   stresslet  φ = 2 h X·sX/r⁵ + (2/3) tr(s) z/r³
//              u = −X X·sX/r⁵ + z ∇φ − φ e_z
//
// clang-format on

// The single layer with the wall is symmetric, G(x, y) = G(y, x)ᵀ; the stresslet's image is that of the
// double layer's kernel, 3/4π of it: the stress of the force's image, a Stokes flow in x that
// vanishes at the wall. The loops over many points are in kernels/StokesletLoops.inl.h.

#include "solver/mesh/TriangleMesh.h"

#include <cmath>

namespace vesicle
{

/// B such that B f is the velocity at x, of the force 8πμ f; `y` and f mirrored.
inline Eigen::Matrix3d force_image(const Vector3& x, const Vector3& y)
{
  const Vector3 X = y - x, e = Vector3::UnitZ();
  const double over_r = 1 / X.norm(), square = over_r * over_r, h = -y.z(), z = x.z();
  return over_r *
    ((-1 - 2 * z * h * square) * Eigen::Matrix3d::Identity() +
      square * (6 * z * h * square - 1) * X * X.transpose() - 2 * z * square * X * e.transpose() +
      2 * e * e.transpose() - 2 * h * square * e * X.transpose());
}

/// B such that B u is the velocity at x of the stresslet (u n + n u)/2; `y`, `n` and u mirrored.
inline Eigen::Matrix3d stresslet_image(const Vector3& x, const Vector3& y, const Vector3& n)
{
  const Vector3 X = y - x;
  const double square = 1 / X.squaredNorm(), h = -y.z(), z = x.z(), along = X.dot(n);
  return square * square * std::sqrt(square) *
    (along * (10 * z * h * square - 1) * X * X.transpose() + 2 * z * z * X * n.transpose() -
      2 * z * h * (along * Eigen::Matrix3d::Identity() + n * X.transpose()) -
      2 * h * along * Vector3::UnitZ() * X.transpose());
}

}
