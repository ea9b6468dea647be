#pragma once
// Start shapes: triangulations of a sphere, ellipsoids, the discocyte and perturbed spheres, of
// good quality, with the reduced volume that was asked for on the surface that the mesh stands for.

#include "solver/mesh/TriangleMesh.h"
#include "solver/mesh/shapes/ShapeRequest.h"
#include "solver/mesh/shapes/SphereMesh.h"

#include <functional>

namespace vesicle
{

/// Of a closed surface.
struct BodyMeasures
{
  double area, volume;
  Vector3 centroid; ///< of the volume
};

/// How shapes are meshed, and what the surface of a mesh measures.
class ShapeMesher
{
public:
  virtual ~ShapeMesher() = default;
  virtual SphereMesh mesh(
    const SphericalParametrisation& surface, int triangles, Symmetry symmetry) const = 0;
  /// Mends the spacing after the surface has changed a little.
  virtual void settle(SphereMesh& mesh, const SphericalParametrisation& surface) const = 0;
  /// Measures meshes with those triangles, whatever their points.
  virtual std::function<BodyMeasures(const Points&)> measure(
    const Triangles& triangles, int points) const = 0;
  /// By how much a mesh may be less round than was asked for where it can't be rounder.
  virtual double roundness_tolerance() const = 0;
};

/// The mesh, with the volume of the unit sphere (r0 = 1) and its volume's centroid at the origin.
/// Throws InputError for what can't be (v outside the family's range, too few triangles, negative
/// axes, a perturbed radius that isn't positive …).
TriangleMesh make_shape(const ShapeRequest& request, const ShapeMesher& mesher);
/// An even mesh, measured by its flat triangles.
TriangleMesh make_shape(const ShapeRequest& request);

/// The shape that is asked for, before it is meshed: of any size.
struct ExactShape
{
  SphericalParametrisation surface;
  Symmetry symmetry;
};
ExactShape exact_shape(const ShapeRequest& request);

}
