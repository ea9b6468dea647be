#pragma once
// Orthonormal real spherical harmonics: Y_lm = √2 P_l^|m| cos mφ (m > 0), P_l^0 (m = 0), √2 P_l^|m|
// sin |m|φ (m < 0) with P_l^m normalised so that ∮Y² = 1 and without the Condon–Shortley sign: Y_11
// = √(3/4π) x.

#include <Eigen/Core>

namespace vesicle
{

/// At a direction (unit vector). Throws InputError unless |m| ≤ l.
double real_spherical_harmonic(int l, int m, const Eigen::Vector3d& direction);

/// How many there are up to a degree, and the place of each in that order: by l, then by m.
constexpr int harmonic_count(int degree)
{
  return (degree + 1) * (degree + 1);
}
constexpr int harmonic_index(int l, int m)
{
  return l * l + l + m;
}

/// Σ_q weight_q Y_lm(direction_q) for all l ≤ degree, by harmonic_index; directions are unit
/// vectors, one a row.
Eigen::VectorXd harmonic_moments(
  int degree, const Eigen::MatrixX3d& directions, const Eigen::VectorXd& weights);
/// Σ_lm amplitude_lm Y_lm for all l ≤ degree at each direction.
Eigen::VectorXd harmonic_sums(
  int degree, const Eigen::VectorXd& amplitudes, const Eigen::MatrixX3d& directions);

}
