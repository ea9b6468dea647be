#include "solver/dynamics/LumpedForces.h"

#include <algorithm>

namespace vesicle
{

Eigen::VectorXd Mobility::velocity(const NodalForce& force) const
{
  Eigen::VectorXd u = Eigen::VectorXd::Zero(matrix.rows());
  if (force.normal.size() > 0)
    u += multiply(matrix, force.normal, normal);
  if (force.vector.size() > 0)
    u += matrix.col(vector);
  return u;
}

LumpedForces::LumpedForces(const Surface& surface, const Incompressibility* incompressibility)
  : surface_(surface), normal_(vertex_curvature(surface).normal),
    tension_(incompressibility ? incompressibility->force(surface) : SparseMatrix())
{
}

Points LumpedForces::at_vertices(const NodalForce& force) const
{
  return rows_of_three(nodal(force));
}

Points LumpedForces::tension_at_vertices(const Eigen::VectorXd& gamma) const
{
  return rows_of_three(tension_ * gamma);
}

double LumpedForces::power(const NodalForce& force, const Eigen::VectorXd& velocity) const
{
  return power(nodal(force), velocity);
}

double LumpedForces::tension_power(
  const Eigen::VectorXd& gamma, const Eigen::VectorXd& velocity) const
{
  return power(Eigen::VectorXd(tension_ * gamma), velocity);
}

Mobility LumpedForces::mobility(
  const StokesOperator& layer, int source, const Mobility::Columns& columns) const
{
  const Eigen::Index n = surface_.space->nodes();
  Mobility mobility;
  Eigen::Index count = 0;
  const auto place = [&](bool present, Eigen::Index size, Eigen::Index& first)
  {
    if (present)
      first = count;
    count += present ? size : 0;
  };
  place(columns.normal, n, mobility.normal);
  place(columns.tension, n, mobility.tension);
  place(columns.vector.size() > 0, 1, mobility.vector);

  // The three rows of a node have the same columns; zeros count as entries.
  SparseMatrix F(3 * n, count);
  F.reserve(Eigen::VectorXi::Constant(3 * n, 2 + (columns.tension ? widest_row() : 0)));
  for (Eigen::Index row = 0; row < 3 * n; ++row)
  {
    if (columns.normal)
      F.insert(row, mobility.normal + row / 3) = normal_(row / 3, row % 3);
    if (columns.tension)
      for (SparseMatrix::InnerIterator it(tension_, row); it; ++it)
        F.insert(row, mobility.tension + it.col()) = it.value();
    if (mobility.vector >= 0)
      F.insert(row, mobility.vector) = columns.vector[row];
  }
  F.makeCompressed();
  mobility.matrix = layer.columns(source, NodalDensities{ F });
  return mobility;
}

int LumpedForces::widest_row() const
{
  int widest = 0;
  for (Eigen::Index row = 0; row < tension_.rows(); ++row)
    widest = std::max(widest, tension_.outerIndexPtr()[row + 1] - tension_.outerIndexPtr()[row]);
  return widest;
}

Eigen::VectorXd LumpedForces::nodal(const NodalForce& force) const
{
  Eigen::VectorXd density = Eigen::VectorXd::Zero(3 * surface_.space->nodes());
  if (force.normal.size() > 0)
    density += scaled_rows(normal_, force.normal);
  if (force.vector.size() > 0)
    density += force.vector;
  return density;
}

double LumpedForces::power(const Eigen::VectorXd& density, const Eigen::VectorXd& velocity) const
{
  return scaled_rows(rows_of_three(density), surface_.vertex_area).dot(velocity);
}

}
