#pragma once
// Bending: E = ½ ∮ (2H − c0)² dS (EB = 1), c0 the spontaneous curvature, a sphere has 8π at c0 = 0.
// Force density f_b = [2 Δ_s H + (2H − c0)(2H² − 2K + c0 H)] n, for c0 = 0 the paper's (6) with its
// misprint mended, 4 H (H² − K) for 2 H (H² − K).

#include "solver/membrane/MembraneTerm.h"

namespace vesicle
{

/// The bending of a surface, by its space's own curvature: on smooth surfaces the exact
/// variation of the energy (SmoothBending), on flat triangles by cotangents
/// (CotanBending, PaperBending), or by fitted curvatures (FittedBending). `c0` in units of 1/r0.
std::unique_ptr<const MembraneTerm> make_bending(const SurfaceSpace& space, double c0);

/// On smooth surfaces: the exact variation of the energy that is reported (BendingVariation.h).
class SmoothBending final : public MembraneTerm
{
public:
  explicit SmoothBending(double c0) : c0_(c0) {}
  std::string name() const override { return "Bending"; }
  bool stiff() const override { return true; }
  double rate() const override { return 1; }
  double energy(const Surface& surface) const override;
  Variation variation(const Surface& surface) const override;
  void add_curvature_energy(const CurvedPoints& surface, CurvatureEnergy& sum) const override;

private:
  double c0_;
};

/// On flat triangles: paper (14)–(24) with area-weighted normals, and its (25) for the normal part
/// of a displacement.
class CotanBending : public MembraneTerm
{
public:
  explicit CotanBending(double c0) : c0_(c0) {}
  std::string name() const override { return "Bending"; }
  bool stiff() const override { return true; }
  double rate() const override { return 1; }
  double energy(const Surface& surface) const override;
  TermForce force(const Surface& surface) const override;

protected:
  virtual NormalScheme normals() const { return NormalScheme::area_weighted; }
  /// `response` is the C of (25), N by 3N.
  virtual SparseMatrix linearised(const SparseMatrix& response, const Points& normal) const;

private:
  double c0_;
};

/// On either surface by fitted curvatures: for single shapes.
class FittedBending final : public MembraneTerm
{
public:
  explicit FittedBending(double c0) : c0_(c0) {}
  std::string name() const override { return "Bending"; }
  double rate() const override { return 1; }
  /// By the surface's own curvature.
  double energy(const Surface& surface) const override;
  TermForce force(const Surface& surface) const override;
  Variation variation(const Surface& surface) const override;

private:
  double c0_;
};

/// ½ ∮ (2H − c0)² dS on a smooth surface, and with the vertices' areas on flat triangles.
double bending_energy(const SurfacePoints& surface, const PointCurvature& curvature, double c0 = 0);
double bending_energy(const CotanGeometry& geometry, const Curvature& curvature, double c0 = 0);

/// f_b·n at the vertices from their curvatures: N.
Eigen::VectorXd bending_density(const Curvature& curvature, double c0 = 0);

/// Paper (25): C with f_b·n = C x + const, C = [2L + 4 diag(H² − K) − c0²] (−½) 𝒩ᵀ(L ⊗ I₃),
/// everything but x frozen at the current shape: N by 3N. C annihilates translations.
SparseMatrix bending_matrix(
  const CotanGeometry& geometry, const Curvature& curvature, double c0 = 0);

/// Each row's blocks projected on the nodes' normals: M 𝒩 𝒩ᵀ, the response to the normal part of a
/// displacement. Tangential displacements of nodes change the mesh, not the shape.
SparseMatrix normal_part(const SparseMatrix& response, const Points& normal);

}
