#include "solver/surface/RigidMotions.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

namespace vesicle
{

RigidMotions::RigidMotions(const Points& vertices, const Eigen::VectorXd& weights)
  : motion_(3 * vertices.rows(), 6), weighted_(3 * vertices.rows(), 6)
{
  const Eigen::RowVector3d center = weights.transpose() * vertices / weights.sum();
  for (Eigen::Index i = 0; i < vertices.rows(); ++i)
  {
    const Vector3 x = (vertices.row(i) - center).transpose();
    for (int c = 0; c < 3; ++c)
    {
      motion_.block<3, 1>(3 * i, c) = Vector3::Unit(c);
      motion_.block<3, 1>(3 * i, 3 + c) = Vector3::Unit(c).cross(x);
    }
  }
  const auto weigh = [&]
  {
    for (Eigen::Index i = 0; i < vertices.rows(); ++i)
      weighted_.middleRows<3>(3 * i) = weights[i] * motion_.middleRows<3>(3 * i);
  };
  weigh();
  const Eigen::Matrix<double, 6, 6> products = motion_.transpose() * weighted_;
  const Eigen::LLT<Eigen::Matrix<double, 6, 6>> factors(products);
  motion_ = factors.matrixU().solve<Eigen::OnTheRight>(motion_).eval();
  weigh();
}

Eigen::VectorXd RigidMotions::nearest(const Eigen::VectorXd& velocity) const
{
  return motion_ * (weighted_.transpose() * velocity).eval();
}

}
