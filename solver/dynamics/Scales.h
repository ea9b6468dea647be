#pragma once
// The units in which the solver computes.

namespace vesicle
{

/// Internally lengths are in r0, energies in EB, viscosity in μ. Multiply a dimensionless number by
/// the scale to have it in the scene's units.
struct Scales
{
  double length = 1;    ///< r0 = (3V/4π)^{1/3} of the start mesh
  double energy = 1;    ///< EB, or 1 in the scene's units without bending
  double viscosity = 1; ///< μ

  double time() const { return viscosity * length * length * length / energy; }
  double velocity() const { return length / time(); }
  double tension() const { return energy / (length * length); }
  double force_density() const { return energy / (length * length * length); }
  double curvature() const { return 1 / length; }
  double power() const { return energy / time(); }
};

}
