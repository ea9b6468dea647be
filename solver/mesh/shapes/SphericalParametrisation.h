#pragma once
// Closed smooth surfaces given point by point over the unit sphere.

#include "solver/mesh/TriangleMesh.h"

#include <functional>

namespace vesicle
{

/// A closed smooth surface as a one-to-one image of the unit sphere: the point above a direction
/// (unit vector).
using SphericalParametrisation = std::function<Vector3(const Vector3& direction)>;

/// What maps a surface onto itself.
enum class Symmetry
{
  none,
  half_turns, ///< about x, y and z
  around_x,   ///< any turn about x, and the half turns
  around_y,
  around_z,
  turns_about_z, ///< any turn about z alone: top and bottom differ
};

/// Every point x of a mesh moved to surface(x): the flat triangles above those of a mesh of the
/// unit sphere.
TriangleMesh mapped(TriangleMesh mesh, const SphericalParametrisation& surface);

}
