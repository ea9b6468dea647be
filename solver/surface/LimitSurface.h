#pragma once
// Loop's limit surface at any of its points, many times: what meshes are laid on anew.

#include "solver/surface/Basis.h"

#include <array>
#include <vector>

namespace vesicle
{

/// A point of a surface by barycentric coordinates on one of its triangles; they add up to 1.
struct SurfacePlace
{
  int element = 0;
  Vector3 weights{ 1. / 3, 1. / 3, 1. / 3 };
};

/// Over every element a quartic of the coordinates, or over each of the parts that it is halved into
/// towards extraordinary vertices. The last part is a quartic through fifteen of the surface's points:
/// with `depth` halvings it is 2^−depth of an edge wide.
class LimitSurface
{
public:
  /// Through the points of a closed manifold mesh. Throws InputError.
  explicit LimitSurface(const TriangleMesh& mesh);

  const TriangleMesh& mesh() const { return mesh_; }

  struct Point
  {
    Vector3 position, tangent_u, tangent_v; ///< along the second and the third coordinate
    Vector3 normal() const { return tangent_u.cross(tangent_v).normalized(); }
  };
  Point at(const SurfacePlace& place) const;

  /// The place whose coordinates may be outside of its triangle, on the triangle that it is on when the
  /// coordinates are carried over edges.
  SurfacePlace carried(SurfacePlace place) const;
  /// The place that the tangential part of a displacement leads to from another, to first order.
  SurfacePlace moved(const SurfacePlace& from, const Vector3& displacement) const;
  /// The nearest point to x, by Gauss–Newton steps from a place near it.
  SurfacePlace nearest(const Vector3& x, SurfacePlace from) const;

private:
  static constexpr int depth = 6;
  using Quartic = Eigen::Matrix<double, 15, 3>;
  /// An element or a part of one: a quartic, or four parts, those at its corners and the middle one.
  struct Part
  {
    int quartic = -1;
    std::array<int, 4> parts{};
  };
  struct Samples;

  int add_part(
    Samples& samples, const std::array<Vector3, 3>& corners, std::array<bool, 3> rough, int level);

  TriangleMesh mesh_;
  std::vector<std::array<int, 3>> across_; ///< the element over the edge opposite to each corner
  std::vector<Part> parts_;
  std::vector<int> roots_; ///< the part that each element is
  std::vector<Quartic> quartics_;
};

/// A scalar of the vertices at a place, linear between the corners.
double linear(
  const SurfacePlace& place, const Triangles& triangles, const Eigen::VectorXd& at_vertices);
/// A nodal field of the basis at places. At extraordinary vertices, where a basis can't be evaluated, it
/// is taken beside them.
Points at_places(const Basis& basis, const std::vector<SurfacePlace>& places, const Points& nodal);

}
