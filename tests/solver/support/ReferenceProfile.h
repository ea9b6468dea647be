#pragma once
// The equilibria of data/reference as smooth surfaces.

#include "solver/mesh/shapes/SphericalParametrisation.h"

#include <string>

namespace vesicle::test
{

/// The surface of revolution of data/reference/profiles/<name>.csv: cubic splines through its 200
/// points, their arc length in proportion to the polar angle. Its bending energy is 1.4e-5 to 2.8e-5
/// below the equilibrium's.
SphericalParametrisation reference_profile(const std::string& name);

/// Bending energy in units of 8π of a row of data/reference/equilibria.csv.
double reference_energy(const std::string& branch, double reduced_volume);

}
