#pragma once
// The exact start shapes, as smooth images of the unit sphere.

#include "solver/mesh/shapes/Shapes.h"

#include <functional>

namespace vesicle
{

/// A closed smooth surface as a one-to-one image of the unit sphere: the point above a direction
/// (unit vector).
using SphereImage = std::function<Vector3(const Vector3& direction)>;

/// What maps a surface onto itself.
enum class Symmetry
{
  none,
  half_turns, ///< about x, y and z
  around_x,   ///< any turn about x, and the half turns
  around_y,
  around_z,
};

/// Surfaces of one kind, from rounder to more deflated: their reduced volume falls as the parameter
/// `deflation` rises. Sizes are arbitrary.
struct ShapeFamily
{
  std::function<SphereImage(double deflation)> surface;
  double standard = 0; ///< the deflation if no reduced volume is asked for
  double roundest = 0; ///< the range of the deflation
  double flattest = 0;
  bool needs_reduced_volume = false;
  Symmetry symmetry = Symmetry::around_z;
};

/// The family that the request is about. Throws InputError for semi-axes that aren't positive and
/// for a perturbed radius that isn't.
ShapeFamily shape_family(const ShapeRequest& request);

}
