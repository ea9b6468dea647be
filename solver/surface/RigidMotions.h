#pragma once
// The six rigid motions of a surface's vertices.

#include "solver/mesh/TriangleMesh.h"

namespace vesicle
{

class RigidMotions
{
public:
  /// `weights`: of the vertices, above 0, for instance their areas.
  RigidMotions(const Points& vertices, const Eigen::VectorXd& weights);

  /// The rigid motion nearest to a velocity (3N), mean square by the weights.
  Eigen::VectorXd nearest(const Eigen::VectorXd& velocity) const;

private:
  Eigen::Matrix<double, Eigen::Dynamic, 6> motion_;   ///< orthonormal by the weights
  Eigen::Matrix<double, Eigen::Dynamic, 6> weighted_; ///< their products with the weights
};

}
