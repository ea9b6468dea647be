#pragma once
// A bowl, which stomatocytes are near to: a spherical shell of constant thickness that leaves a round
// opening at the top, closed by half a torus.

#include "solver/mesh/TriangleMesh.h"

namespace vesicle
{

/// (r, z) of the meridian at the share s of its length, from the outer pole at the bottom to the
/// inner one. Middle radius 1, half thickness h.
Eigen::Vector2d bowl_meridian(double half_thickness, double share);

}
