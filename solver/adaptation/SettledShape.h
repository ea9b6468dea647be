#pragma once
// What laying a mesh anew does to a shape, taken back as far as that can be had.

#include "solver/adaptation/AdaptedMesh.h"
#include "solver/membrane/MembraneTerm.h"

namespace vesicle
{

/// The shape that a mesh was laid on, in units of r0 and EB.
struct OriginalShape
{
  const Surface& surface;
  const MembraneTerms& terms;
  double area, volume; ///< that are to be kept
};

struct SettledShape
{
  Points points;            ///< of the vertices
  double energy_change = 0; ///< of the membrane's own energy: 0 where it could be restored
  double moved =
    0; ///< the largest normal way of a vertex for area, volume and energy, in edge lengths
};

/// New vertices on an old surface give another surface between them, rougher than one that has relaxed,
/// which the bending force feels far more than the energy does. A step δ of the control points,
///   (M/(λ h⁴) + 2 RᵀR) δ = g* − g   with ∂A·δ = ∂V·δ = 0,
/// takes most of it out: g* is what the old shape's force density makes on the new mesh, so that what
/// is the shape's own stays. Then area, volume and energy get back their values by normal displacements
/// S G y, G the three gradients, S = (M + ℓ⁴ ∮ΔN ΔN)⁻¹: ℓ of two edges where the energy has to rise, as
/// it would be put into ripples otherwise. Where that moves a vertex by more than 1e-2 of an edge, as it
/// does near equilibria, whose three gradients depend on each other, only area and volume do. `space`: of
/// a smooth surface. Throws NumericalError.
SettledShape settle_shape(const SurfaceSpace& space, const MembraneTerms& terms,
  const AdaptedMesh& mesh, const OriginalShape& original);

}
