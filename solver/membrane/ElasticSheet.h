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
/// whose nodes move with the material. Stiff: its waves as short as the mesh's edges are faster than
/// anything that a run is about. The second variation is taken as that of an isotropic sheet with
/// the moduli that each place has, without the tensions, of which any sign may be.
class ElasticSheet final : public MembraneTerm
{
public:
  /// `reference`: vertices of the shape without stress, on `space`, which must outlive the sheet.
  ElasticSheet(const ElasticModuli& moduli, const SurfaceSpace& space, const Points& reference);

  std::string name() const override { return "Elastic"; }
  bool stiff() const override { return true; }
  double rate() const override { return moduli_.shear; }
  double energy(const Surface& surface) const override;
  Variation variation(const Surface& surface) const override;

private:
  /// What the sheet has at a row of the space's table.
  struct State
  {
    double energy;          ///< W
    double uu, uv, vv;      ///< 2 ∂W/∂a_αβ
    double shear, dilation; ///< moduli, an area of the reference
  };
  State state(const SurfacePoints& surface, int row) const;
  std::vector<EntryVectors> rates(const SurfacePoints& surface) const;

  ElasticModuli moduli_;
  const BasisTable* table_;
  Eigen::VectorXd weight_;              ///< of each row: area of the reference
  Eigen::MatrixX3d inverse_metric_;     ///< of each row: A^{uu}, A^{uv}, A^{vv}
  Eigen::VectorXd inverse_determinant_; ///< of each row: 1/det A
};

}
