#pragma once
// Area-difference elasticity: the two leaflets of a bilayer exchange no lipids, so that the
// difference of their areas, thickness · 2 ∮ H dS, has a value that it prefers. Miao, Seifert,
// Wortis, Döbereiner, Phys. Rev. E 49 (1994) 5389.

#include "solver/membrane/MembraneTerm.h"

namespace vesicle
{

/// E = 8π² α (m − m0)² (EB = 1) with m = M/√(4πA), M = ∮ H dS; a sphere has m = 1. As δM = ∮ K ψ dS
/// and δA = ∮ 2H ψ dS under ψ n, the force density is −16π² α (m − m0) [K/√(4πA) − m H/A] n; on
/// smooth surfaces the gradient is that of M and A as they are integrated.
class AreaDifference final : public MembraneTerm
{
public:
  /// α, the ratio of nonlocal to local bending stiffness, > 0; m0 is what m prefers.
  AreaDifference(double alpha, double m0) : alpha_(alpha), m0_(m0) {}
  std::string name() const override { return "Area_Difference"; }
  double rate() const override { return alpha_; }
  double energy(const Surface& surface) const override;
  TermForce force(const Surface& surface) const override;
  Variation variation(const Surface& surface) const override;
  void add_curvature_energy(const CurvedPoints& surface, CurvatureEnergy& sum) const override;

private:
  double alpha_, m0_;
};

/// ∮ H dS by the quadrature points of a smooth surface, by the vertices' areas on flat triangles.
double integrated_mean_curvature(const Surface& surface);

}
