#pragma once
// What can be asked of a start shape.

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

  bool operator==(const ShapeMode&) const = default;
};

struct ShapeRequest
{
  enum class Kind
  {
    sphere,
    prolate,    ///< ellipsoid of revolution, long along z
    oblate,     ///< ellipsoid of revolution, short along z
    ellipsoid,  ///< semi_axes along x, y, z
    discocyte,  ///< biconcave disc (Evans & Fung 1972), axis z
    perturbed,  ///< sphere with `modes`
    stomatocyte ///< bowl with a narrow mouth, which opens along z
  };
  Kind kind = Kind::sphere;
  int triangles = 1280;                 ///< the nearest that there is, uniform_mesh()
  std::optional<double> edge_length;    ///< instead of triangles: mean edge, in units of the radius
  std::optional<double> reduced_volume; ///< of the discrete mesh, to 1e-6
  /// Of an ellipsoid; with reduced_volume raised to a common power until it holds.
  std::array<double, 3> semi_axes{ 1, 1, 1 };
  std::vector<ShapeMode> modes; ///< of a perturbed sphere

  bool operator==(const ShapeRequest&) const = default;
};

ShapeRequest::Kind shape_kind(const std::string& name); ///< throws InputError listing what is known
std::string shape_name(ShapeRequest::Kind kind);

}
