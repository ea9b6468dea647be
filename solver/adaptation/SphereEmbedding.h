#pragma once
// A closed surface of genus 0 spread over the unit sphere.

#include "solver/surface/LimitSurface.h"

namespace vesicle
{

/// Directions of a mesh's vertices whose triangles cover the sphere once, nearly conformally.
class SphereEmbedding
{
public:
  /// By mean curvature flow whose stiffness stays that of the start (M. Kazhdan, J. Solomon, M. Ben-Chen,
  /// Comput. Graph. Forum 31 (2012) 1745), whatever the shape; then turned and moved by a Möbius
  /// transformation until the vertices, each with its weight, are balanced about the centre (A. Baden,
  /// K. Crane, M. Kazhdan, Comput. Graph. Forum 37 (2018) 211) and spread most along z, or least.
  /// Throws NumericalError where triangles fold over.
  SphereEmbedding(const TriangleMesh& mesh, const Eigen::VectorXd& weights);

  const Points& directions() const { return directions_; }
  /// x becomes y, y z and z x.
  void permute_axes();
  /// The place on the mesh above a direction, found by walking from a triangle.
  SurfacePlace place(const Vector3& direction, int start) const;

private:
  void find_directions(const TriangleMesh& mesh);
  void balance(const Eigen::VectorXd& weights);
  void turn(const Eigen::VectorXd& weights);
  void require_no_fold() const;
  Vector3 weights(int element, const Vector3& direction) const;

  Triangles triangles_;
  std::vector<std::array<int, 3>> across_;
  Points directions_;
};

}
