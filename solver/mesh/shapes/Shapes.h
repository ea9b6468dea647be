#pragma once
// Start shapes: triangulations of a sphere, ellipsoids, the discocyte and perturbed spheres, of
// good quality, with the reduced volume that was asked for on the discrete mesh.

#include "solver/mesh/shapes/SphericalHarmonics.h"
#include "solver/mesh/TriangleMesh.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace vesicle
{

/// One mode of r(θ, φ) = 1 + Σ amplitude Y_lm, Y_lm of SphericalHarmonics.h.
struct ShapeMode
{
  int l = 2;
  int m = 0;
  double amplitude = 0;
};

struct ShapeRequest
{
  enum class Kind
  {
    sphere,
    prolate,   ///< ellipsoid of revolution, long along z
    oblate,    ///< ellipsoid of revolution, short along z
    ellipsoid, ///< semi_axes along x, y, z
    discocyte, ///< biconcave disc (Evans & Fung 1972), axis z
    perturbed  ///< sphere with `modes`
  };
  Kind kind = Kind::sphere;
  int triangles = 1280;                 ///< the nearest that there is, uniform_mesh()
  std::optional<double> edge_length;    ///< instead of triangles: mean edge, in units of the radius
  std::optional<double> reduced_volume; ///< of the discrete mesh, to 1e-6
  /// Of an ellipsoid; with reduced_volume raised to a common power until it holds.
  std::array<double, 3> semi_axes{ 1, 1, 1 };
  std::vector<ShapeMode> modes; ///< of a perturbed sphere
};

/// The mesh, with its discrete volume equal to that of the unit sphere (r0 = 1) and its volume
/// centroid at the origin. Throws InputError for what can't be (v outside the family's range, too
/// few triangles, negative axes, a perturbed radius that isn't positive …).
TriangleMesh make_shape(const ShapeRequest& request);

ShapeRequest::Kind shape_kind(const std::string& name); ///< throws InputError listing what is known
std::string shape_name(ShapeRequest::Kind kind);

/// A sphere of radius 1 with triangles of nearly equal size: the icosahedron's faces cut in n²
/// (class I, n ≥ 1) and projected: 20 n² triangles, 10 n² + 2 vertices.
TriangleMesh geodesic_sphere(int n);
/// The n for which 20 n² is nearest to `triangles`.
int geodesic_frequency(int triangles);

}
