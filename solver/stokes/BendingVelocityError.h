#pragma once
// How much the error of a curvature matters.

#include "solver/surface/ExactCurvature.h"

namespace vesicle
{

/// ‖G(f_h n_h − f n)‖/‖G f n‖, the error of a curvature's bending force as it moves the fluid: f
/// exact, G the single layer of the flat triangles.
double bending_velocity_error(
  const TriangleMesh& mesh, const LevelSet& surface, const Curvature& curvature);

}
