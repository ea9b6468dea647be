#pragma once
// The exact start shapes, as smooth images of the unit sphere.

#include "solver/mesh/Shapes.h"

#include <functional>

namespace vesicle
{

/// A closed smooth surface as a one-to-one image of the unit sphere: the point above a direction
/// (unit vector).
using SphereImage = std::function<Vector3(const Vector3& direction)>;

/// Surfaces of one kind, from rounder to more deflated: their reduced volume falls as the parameter
/// `deflation` rises. Sizes are arbitrary.
struct ShapeFamily
{
  std::function<SphereImage(double deflation)> surface;
  double standard = 0; ///< the deflation if no reduced volume is asked for
  double roundest = 0; ///< the range of the deflation
  double flattest = 0;
  bool needs_reduced_volume = false;
  /// Half turns about x, y and z map the surface onto itself.
  bool half_turn_symmetric = true;
};

/// The family that the request is about. Throws InputError for semi-axes that aren't positive and
/// for a perturbed radius that isn't.
ShapeFamily shape_family(const ShapeRequest& request);

}
