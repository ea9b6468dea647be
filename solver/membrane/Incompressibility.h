#pragma once
// Local incompressibility, ∇_s·u = 0, and the tension γ that enforces it: force density
// f_γ = ∇_s γ − 2 γ H n, paper (7), (28)–(35).

#include "solver/surface/Surface.h"

#include <memory>

namespace vesicle
{

/// Rows of the constraint, D ċ + F γ = 0 for the control points' velocities ċ = P⁻¹ u.
struct ConstraintRows
{
  SparseMatrix rate;   ///< D, N by 3N
  SparseMatrix filter; ///< F, N by N, or empty
  /// Close to a sphere a uniform tension does no work and the total area follows from the volume:
  /// then the gauge of the tension is fixed to a zero mean.
  bool gauge_pinned = false;
};

/// How the constraint and its tension are discretised.
class Incompressibility
{
public:
  virtual ~Incompressibility() = default;
  virtual ConstraintRows rows(const Surface& surface) const = 0;
  /// T, 3N by N: the force density is Σ N_k (T γ)_k; empty where it is ∇_s γ − 2 γ H n at every
  /// point of the surface.
  virtual SparseMatrix force(const Surface& surface) const = 0;
};

/// On smooth surfaces: rows ∮ N_k ∇_s·u dS, filtered; the force at every point.
class SmoothIncompressibility final : public Incompressibility
{
public:
  /// `surface_viscosity`: the membrane's, in μ r0.
  explicit SmoothIncompressibility(double surface_viscosity) : viscosity_(surface_viscosity) {}
  ConstraintRows rows(const Surface& surface) const override;
  SparseMatrix force(const Surface&) const override { return {}; }

private:
  double viscosity_;
};

/// On flat triangles: rows B, the rates of the vertices' areas, and their adjoint −Bᵀγ as nodal
/// forces, which makes the constraint's power exactly zero.
class AdjointIncompressibility final : public Incompressibility
{
public:
  ConstraintRows rows(const Surface& surface) const override;
  SparseMatrix force(const Surface& surface) const override;
};

/// The one that goes with the space's curvature: smooth, adjoint, or the paper's.
/// `surface_viscosity`: the membrane's, in μ r0; of smooth surfaces.
std::unique_ptr<const Incompressibility> make_incompressibility(
  const SurfaceSpace& space, double surface_viscosity = 0);

}
