#include "solver/surface/RigidMotion.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

namespace vesicle
{

RigidMotion::RigidMotion(const Surface& surface)
  : surface_(surface), rotation_(3, surface.vertices.size())
{
  constexpr double least_share = 1e-3;
  Eigen::Matrix3d square = Eigen::Matrix3d::Zero();
  double size = 0;
  for (Eigen::Index i = 0; i < surface.vertices.rows(); ++i)
  {
    const Vector3 r = surface.vertices.row(i).transpose() - surface.center,
                  n = surface.normals.row(i).transpose(), turned = r.cross(n);
    const double m = surface.vertex_area[i];
    square += m * turned * turned.transpose();
    size += m * r.squaredNorm();
    rotation_.middleCols<3>(3 * i) = m * turned * n.transpose();
  }
  square += least_share * size * Eigen::Matrix3d::Identity();
  rotation_ = square.llt().solve(rotation_).eval();
}

Vector6 RigidMotion::motion(const Eigen::VectorXd& at_vertices) const
{
  Vector6 motion;
  motion << surface_.mean_velocity(at_vertices),
    rotation_ * surface_.relative_to_centroid(at_vertices);
  return motion;
}

Eigen::VectorXd RigidMotion::motion_adjoint(const Vector6& dual) const
{
  const Eigen::VectorXd turning = rotation_.transpose() * dual.tail<3>();
  const Vector3 pushing = dual.head<3>() - rows_of_three(turning).colwise().sum().transpose();
  return turning + surface_.centroid_velocity.transpose() * pushing;
}

Points RigidMotion::velocity(const Vector6& motion, const Points& points) const
{
  const Eigen::RowVector3d U = motion.head<3>().transpose(), turn = motion.tail<3>().transpose(),
                           center = surface_.center.transpose();
  Points velocity(points.rows(), 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    velocity.row(i) = U + turn.cross(points.row(i) - center);
  return velocity;
}

Vector6 RigidMotion::velocity_adjoint(const Points& forces, const Points& points) const
{
  Vector6 sum = Vector6::Zero();
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    const Vector3 force = forces.row(i).transpose(),
                  r = points.row(i).transpose() - surface_.center;
    sum.head<3>() += force;
    sum.tail<3>() += r.cross(force);
  }
  return sum;
}

}
