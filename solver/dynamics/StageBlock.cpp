#include "solver/dynamics/StageBlock.h"

namespace vesicle
{

namespace
{

SparseMatrix identity(Eigen::Index n)
{
  SparseMatrix I(n, n);
  I.setIdentity();
  return I;
}

/// K of γ and the slack: the slack's column D n and the gauge's row.
SparseMatrix pinned_gauge(const VesicleShape& shape)
{
  const Surface& surface = *shape.surface;
  const int n = static_cast<int>(surface.vertex_area.size());
  const Eigen::VectorXd slack = shape.constraint->rate * flat(surface.normals);
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < n; ++i)
  {
    entries.emplace_back(i, n, slack[i]);
    entries.emplace_back(n, i, surface.vertex_area[i]);
  }
  SparseMatrix K(n + 1, n + 1);
  K.setFromTriplets(entries.begin(), entries.end());
  return K;
}

}

StageBlock stiff_block(const VesicleShape& shape, std::size_t vesicle, const Mobility& mobility,
  double tau, const Eigen::VectorXd& reference)
{
  const Surface& surface = *shape.surface;
  const Eigen::Index n = surface.vertices.rows();
  const SparseMatrix& response = *shape.linearisation;
  StageBlock block{ vesicle, n, &mobility.matrix, mobility.normal, n, {}, {}, {}, {} };
  block.rows.direct = -tau * response;
  block.rows.weight.resize(n, 3);
  for (int c = 0; c < 3; ++c)
    block.rows.weight.col(c) = tau * (response * Vector3(Vector3::Unit(c)).replicate(n, 1));
  block.rows.functional = surface.centroid_velocity;
  block.own = identity(n);
  if (reference.size() > 0)
    block.prescribed = block.rows.direct * reference;
  return block;
}

StageBlock tension_block(const VesicleShape& shape, std::size_t vesicle, const Mobility& mobility)
{
  const Eigen::Index n = shape.surface->vertices.rows();
  const ConstraintRows& constraint = *shape.constraint;
  StageBlock block{ vesicle, n, &mobility.matrix, mobility.tension, n, {}, {}, {}, {} };
  block.rows.direct = constraint.rate;
  if (constraint.gauge_pinned)
  {
    block.size = n + 1;
    block.rows.direct.conservativeResize(n + 1, constraint.rate.cols());
    block.own = pinned_gauge(shape);
  }
  return block;
}

StageBlock volume_block(const VesicleShape& shape, std::size_t vesicle)
{
  const Surface& surface = *shape.surface;
  StageBlock block{ vesicle, 1, nullptr, 0, 0, flat(surface.normals), {}, {}, {} };
  block.rows.weight = Eigen::MatrixXd::Ones(1, 1);
  block.rows.functional = surface.volume_gradient.transpose();
  return block;
}

}
