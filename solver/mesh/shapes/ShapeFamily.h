#pragma once
// The exact start shapes, as smooth images of the unit sphere.

#include "solver/mesh/shapes/ShapeRequest.h"
#include "solver/mesh/shapes/SphericalParametrisation.h"

#include <functional>

namespace vesicle
{

/// Surfaces of one kind, from rounder to more deflated: their reduced volume falls as the parameter
/// `deflation` rises. Sizes are arbitrary.
struct ShapeFamily
{
  std::function<SphericalParametrisation(double deflation)> surface;
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
