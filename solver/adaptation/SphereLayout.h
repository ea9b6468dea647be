#pragma once
// Triangulations of the sphere laid on a surface.

#include "solver/adaptation/PlacedMesh.h"
#include "solver/adaptation/SphereEmbedding.h"
#include "solver/mesh/shapes/SphereMesh.h"

namespace vesicle
{

/// Around an axis of a surface that is spread over the sphere.
class SphereLayout
{
public:
  /// `triangles`: how many a mesh is to have around each of its vertices, or any multiple. Throws
  /// NumericalError where the surface can't be spread over a sphere.
  SphereLayout(const TriangleMesh& surface, const Eigen::VectorXd& triangles);

  /// Each vertex at its azimuth and so far down that the triangles above it are as many; those of one
  /// height stay at one height.
  PlacedMesh lay(const SphereMesh& sphere) const;
  /// From now on around another axis, of three.
  void next_axis();

private:
  void share_out();
  double height_at(double share) const;

  Eigen::VectorXd triangles_;
  SphereEmbedding embedding_;
  std::vector<double> height_, share_; ///< falling heights, and the share of the triangles above
};

}
