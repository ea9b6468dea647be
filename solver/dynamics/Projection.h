#pragma once
// What a finite time step and the motion of nodes along flat elements leave of area and volume
// errors is taken out after the step.

#include "solver/surface/Surface.h"

namespace vesicle
{

struct ProjectionResult
{
  double area_removed = 0;   ///< |A − A0|/A0 before
  double volume_removed = 0; ///< |V − V0|/V0 before
  double left = 0;           ///< their sum afterwards: 2e-13 at most, or it did not succeed
};

/// Moves the nodes along the two directions of AreaAndVolume::Changes such that area and volume have
/// their targets, both at once (Newton for the two numbers): shifting along n alone for the volume
/// would spoil the area. With `volume_only` (a sphere, where the two directions coincide, or no
/// incompressibility) α = 0.
ProjectionResult project_area_and_volume(
  Points& points, const SurfaceSpace& space, double area, double volume, bool volume_only);

}
