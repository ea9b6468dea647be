#pragma once
// How well the bending energy of Loop's surface is known, which tells whether a mesh holds it.

#include "solver/mesh/TriangleMesh.h"

namespace vesicle
{

/// 2 ∮ H² dS of Loop's surface through a mesh's points (EB = 1): 8π on a sphere.
struct LoopEnergy
{
  double coarse; ///< by 3 points an element
  double fine;   ///< by 12, elements at extraordinary vertices halved three times towards them

  /// Far below 1% on a smooth mesh that resolves the shape. Kinks in the spacing of its points make
  /// the surface rough.
  double disagreement() const;
};

/// Of a closed manifold mesh. Throws InputError for others.
LoopEnergy loop_energy(const TriangleMesh& mesh);

}
