#pragma once
// Elastic sheets, the walls of capsules and the skeleton of red cells: they resist shear and
// dilation of their material away from a reference shape. D. Barthès-Biesel, A. Diaz, E. Dhenin, J.
// Fluid Mech. 460 (2002) 211.

#include "solver/membrane/ElasticLaw.h"
#include "solver/membrane/MembraneTerm.h"

namespace vesicle
{

struct ElasticModuli
{
  ElasticLaw law = ElasticLaw::neo_hookean;
  double shear = 1;    ///< G, in EB/r0²
  double dilation = 1; ///< C of Skalak's law
};

/// E = ∮ W dA over the reference shape, I1 = λ1² + λ2² − 2 and I2 = λ1² λ2² − 1 of the principal
/// stretches. With the metrics A of the reference and a of the shape, I1 = A^{αβ} a_αβ − 2,
/// I2 = det a/det A − 1; the gradient is exact for E as it is integrated. Smooth surfaces only,
/// whose nodes move with the material.
class ElasticSheet final : public MembraneTerm
{
public:
  /// `reference`: vertices of the shape without stress, on `space`, which must outlive the sheet.
  ElasticSheet(const ElasticModuli& moduli, const SurfaceSpace& space, const Points& reference);

  std::string name() const override { return "Elastic"; }
  double rate() const override { return moduli_.shear; }
  double energy(const Surface& surface) const override;
  Variation variation(const Surface& surface) const override;

private:
  /// What the sheet has at a row of the space's table.
  struct State
  {
    double energy;     ///< W
    double uu, uv, vv; ///< 2 ∂W/∂a_αβ
  };
  State state(const SurfacePoints& surface, int row) const;

  ElasticModuli moduli_;
  const BasisTable* table_;
  Eigen::VectorXd weight_;              ///< of each row: area of the reference
  Eigen::MatrixX3d inverse_metric_;     ///< of each row: A^{uu}, A^{uv}, A^{vv}
  Eigen::VectorXd inverse_determinant_; ///< of each row: 1/det A
};

}
