#pragma once
// How well the bending energy of Loop's surface is known, which tells whether a mesh holds it.

#include "solver/mesh/TriangleMesh.h"
#include "solver/surface/Collocation.h"
#include "solver/surface/LoopBasis.h"

namespace vesicle
{

/// 2 ∮ H² dS of Loop's surface through a mesh's points (EB = 1): 8π on a sphere.
struct LoopEnergy
{
  double coarse; ///< by the few points asked for, 3 an element as a rule
  double fine;   ///< by 12, elements at extraordinary vertices halved three times towards them
  Vector3 worst; ///< the middle of the triangle on which the two differ most

  /// Far below 1% on a smooth mesh that resolves the shape. Kinks in the spacing of its points make
  /// the surface rough.
  double disagreement() const;
};

/// Of the shapes that a mesh's triangles take.
class LoopEnergyRules
{
public:
  /// `few`: points an element of the coarse rule. Throws InputError for triangles that can't carry Loop's
  /// surface.
  LoopEnergyRules(const Triangles& triangles, int points, int few = 3);
  LoopEnergy energy(const Points& points) const;

private:
  LoopBasis basis_;
  Collocation collocation_;
  BasisTable coarse_, fine_;
};

/// Of a closed manifold mesh. Throws InputError for others.
LoopEnergy loop_energy(const TriangleMesh& mesh);

/// How badly Loop's surface through a mesh holds a bending energy and a reduced volume, relative, and how
/// far its energies by the two rules differ; all added up.
double loop_error(const TriangleMesh& mesh, double bending_energy, double reduced_volume);

}
