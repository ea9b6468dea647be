#include "solver/dynamics/ForceBasis.h"

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

namespace
{

class PointwiseForces final : public ForceBasis
{
public:
  explicit PointwiseForces(const Surface& surface) : surface_(surface) {}

  Points at_vertices(const NodalForce& force) const override
  {
    return rows_of_three(
      scaled_rows(surface_.normals, surface_.collocation().at_vertices(force.normal)));
  }

  Points tension_at_vertices(const Eigen::VectorXd& gamma) const override
  {
    // The density's nodal values by lumping: for output only, the dynamics use it pointwise.
    const Eigen::VectorXd nodal = -(surface_.area_rate.transpose() * gamma);
    return rows_of_three(scaled_rows(rows_of_three(nodal), surface_.vertex_area.cwiseInverse()));
  }

  double power(const NodalForce& force, const Eigen::VectorXd& velocity) const override
  {
    const BasisTable& table = surface_.space->table();
    const Eigen::VectorXd density = interpolate(table, force.normal);
    return normal_load(table, surface_.points, density).dot(surface_.to_control(velocity));
  }

  // ∮ f·v dS = −∮ γ ∇_s·v dS
  double tension_power(const Eigen::VectorXd& gamma, const Eigen::VectorXd& velocity) const override
  {
    return -gamma.dot(surface_.area_rate * surface_.to_control(velocity));
  }

  Mobility mobility(
    const StokesOperator& layer, int source, const Mobility::Columns& columns) const override
  {
    using Kind = SurfaceDensities::Kind;
    Mobility mobility;
    SurfaceDensities densities;
    const auto add = [&](Kind kind, Eigen::Index& first)
    {
      first = static_cast<Eigen::Index>(densities.kinds.size()) * surface_.space->nodes();
      densities.kinds.push_back(kind);
    };
    if (columns.normal)
      add(Kind::normal, mobility.normal);
    if (columns.tension)
      add(Kind::tension, mobility.tension);
    mobility.matrix = layer.columns(source, densities);
    return mobility;
  }

private:
  const Surface& surface_;
};

class LumpedForces final : public ForceBasis
{
public:
  LumpedForces(const Surface& surface, SparseMatrix tension)
    : surface_(surface), normal_(vertex_curvature(surface).normal), tension_(std::move(tension))
  {
  }

  Points at_vertices(const NodalForce& force) const override { return rows_of_three(nodal(force)); }

  Points tension_at_vertices(const Eigen::VectorXd& gamma) const override
  {
    return rows_of_three(tension_ * gamma);
  }

  double power(const NodalForce& force, const Eigen::VectorXd& velocity) const override
  {
    return power(nodal(force), velocity);
  }

  double tension_power(const Eigen::VectorXd& gamma, const Eigen::VectorXd& velocity) const override
  {
    return power(Eigen::VectorXd(tension_ * gamma), velocity);
  }

  Mobility mobility(
    const StokesOperator& layer, int source, const Mobility::Columns& columns) const override
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

private:
  int widest_row() const
  {
    int widest = 0;
    for (Eigen::Index row = 0; row < tension_.rows(); ++row)
      widest = std::max(widest, tension_.outerIndexPtr()[row + 1] - tension_.outerIndexPtr()[row]);
    return widest;
  }

  Eigen::VectorXd nodal(const NodalForce& force) const
  {
    Eigen::VectorXd density = Eigen::VectorXd::Zero(3 * surface_.space->nodes());
    if (force.normal.size() > 0)
      density += scaled_rows(normal_, force.normal);
    if (force.vector.size() > 0)
      density += force.vector;
    return density;
  }

  // Densities are nodal forces over the nodes' areas.
  double power(const Eigen::VectorXd& density, const Eigen::VectorXd& velocity) const
  {
    return scaled_rows(rows_of_three(density), surface_.vertex_area).dot(velocity);
  }

  const Surface& surface_;
  Points normal_;
  SparseMatrix tension_; ///< 3N by N, or empty
};

}

std::unique_ptr<const ForceBasis> make_force_basis(
  const Surface& surface, const Incompressibility* incompressibility)
{
  if (surface.space->smooth())
    return std::make_unique<PointwiseForces>(surface);
  return std::make_unique<LumpedForces>(
    surface, incompressibility ? incompressibility->force(surface) : SparseMatrix());
}

}
