#pragma once
// Buoyancy: force density f_g = Bo z n, Bo = Δρ g r0⁴/EB; a vesicle rises along +z for Bo > 0,
// paper (42), (46).

#include "solver/membrane/MembraneTerm.h"

namespace vesicle
{

/// Counts z from the volume's centroid: a constant added to z is a pressure, which does nothing,
/// but with the rounding and quadrature of a vesicle that has risen far it would. The energy is −Bo
/// V z_c.
class Buoyancy : public MembraneTerm
{
public:
  explicit Buoyancy(double bond_number) : bond_(bond_number) {}
  std::string name() const override { return "Gravity"; }
  bool external() const override { return true; }
  double rate() const override; ///< a sphere's speed, in r0 a time unit
  double energy(const Surface& surface) const override;

protected:
  double bond_;
};

/// On smooth surfaces the load ∮ N_k z n dS.
class SmoothBuoyancy final : public Buoyancy
{
public:
  using Buoyancy::Buoyancy;
  Variation variation(const Surface& surface) const override;
};

/// On flat triangles nodal forces ∮ N_k z n dS over the nodes' areas: they sum the load exactly and
/// keep net force and torque.
class GalerkinBuoyancy final : public Buoyancy
{
public:
  using Buoyancy::Buoyancy;
  TermForce force(const Surface& surface) const override;
};

/// The one that goes with the space's curvature: smooth, Galerkin, or the paper's.
std::unique_ptr<const MembraneTerm> make_buoyancy(const SurfaceSpace& space, double bond_number);

}
