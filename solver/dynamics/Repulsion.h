#pragma once
// A short-range repulsion between vesicles: what keeps membranes apart where the fluid alone wouldn't,
// and no model of a real one.

#include "solver/dynamics/Proximity.h"

#include <vector>

namespace vesicle
{

/// E = Σ over each vesicle and every other one of ∮ w(d) dS, w = ε (δ/d − 1)² where the distance d
/// to the other is below the range δ, 0 elsewhere, by the vertices and their areas: it grows without
/// a bound towards contact, and its force starts from zero at the range. Taking each pair from both
/// sides makes the force between them equal and opposite.
struct Repulsion
{
  double strength = 0; ///< ε > 0, an energy an area
  double range = 0;    ///< δ > 0

  /// The vertices that feel it are within the range: `Proximity(sides, range)`. Throws NumericalError
  /// where vesicles cross.
  double energy(const Proximity& proximity) const;
  /// ∂E/∂c, c the control points of each vesicle: the energy's exact derivative.
  std::vector<Eigen::VectorXd> gradients(const Proximity& proximity) const;
};

}
