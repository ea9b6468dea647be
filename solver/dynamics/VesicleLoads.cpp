#include "solver/dynamics/VesicleLoads.h"

namespace vesicle
{

namespace
{

// Of a taut sphere, over the fluid's viscosity times its radius: large enough that what it lets
// through is negligible.
constexpr double taut_resistance = 1e4;

SparseMatrix one_below_the_other(const std::vector<SparseMatrix>& parts)
{
  if (parts.size() == 1)
    return parts.front();
  Eigen::Index rows = 0, first = 0, columns = parts.empty() ? 0 : parts.front().cols();
  std::vector<Eigen::Triplet<double>> entries;
  for (const SparseMatrix& part : parts)
    rows += part.rows();
  for (const SparseMatrix& part : parts)
  {
    for (int i = 0; i < part.rows(); ++i)
      for (SparseMatrix::InnerIterator it(part, i); it; ++it)
        entries.emplace_back(static_cast<int>(first) + i, static_cast<int>(it.col()), it.value());
    first += part.rows();
  }
  SparseMatrix all(rows, columns);
  all.setFromTriplets(entries.begin(), entries.end());
  return all;
}

}

VesicleLoads::VesicleLoads(const Vesicle& vesicle, const Surface& surface,
  std::shared_ptr<const ConstraintRows> constraint, double rate)
  : surface_(&surface),
    motion_(
      surface, constraint && constraint->gauge_pinned ? NodeMotionKind::normal : vesicle.motion),
    gradient_(Eigen::VectorXd::Zero(3 * surface.vertices.rows())),
    constraint_(std::move(constraint)), normal_(surface.to_control(flat(surface.normals))),
    mass_(mass_matrix(surface.space->table(), surface.points)),
    mass_factors_(SymmetricMatrix(mass_))
{
  std::vector<SparseMatrix> rates;
  for (const auto& term : vesicle.terms)
  {
    Variation variation = term->variation(surface);
    loads_.push_back(-motion_.adjoint(variation.gradient));
    if (!term->external())
      gradient_ += variation.gradient;
    if (variation.rates.rows() > 0)
      rates.push_back(std::move(variation.rates));
  }
  const BasisTable& table = surface.space->table();
  volume_gradient_ = vesicle::volume_gradient(table, surface.points);
  volume_rate_ = motion_.adjoint(volume_gradient_);
  area_gradient_ = surface.area_rate.transpose() * Eigen::VectorXd::Ones(surface.vertices.rows());
  area_share_ = motion_.adjoint(area_gradient_) - area_gradient_;
  if (constraint_ && constraint_->gauge_pinned)
    hold_taut(rate);
  rates_ = one_below_the_other(rates);
}

// The tension less the pressure that balances it on a sphere, which does nothing but would be
// reported.
void VesicleLoads::hold_taut(double rate)
{
  const double pressure = area_gradient_.dot(normal_) / volume_gradient_.dot(normal_);
  area_share_ = -area_gradient_;
  taut_load_ =
    -taut_resistance * rate * motion_.adjoint(area_gradient_ - pressure * volume_gradient_);
  resistance_ = taut_resistance * stiffness_matrix(surface_->space->table(), surface_->points);
}

Eigen::VectorXd VesicleLoads::resisting_load(const Eigen::VectorXd& speeds) const
{
  const Collocation& collocation = surface_->collocation();
  return -motion_.parameters_adjoint(
    collocation.fit_adjoint(resistance_ * Eigen::VectorXd(collocation.fit(speeds))));
}

Eigen::VectorXd VesicleLoads::taut_load(const Eigen::VectorXd& at_vertices) const
{
  return taut_load_ + resisting_load(motion_.parameters(at_vertices));
}

// A row's entries come in threes, a node's.
SparseMatrix VesicleLoads::rates_along(const Eigen::Ref<const DirectionRows>& directions) const
{
  const Eigen::Index count = directions.cols() / 3;
  SparseMatrix along(rates_.rows(), count * directions.rows());
  along.resizeNonZeros(rates_.nonZeros() / 3 * count);
  for (int q = 0; q <= rates_.rows(); ++q)
    along.outerIndexPtr()[q] = static_cast<int>(rates_.outerIndexPtr()[q] / 3 * count);
  for (Eigen::Index k = 0; k < rates_.nonZeros() / 3; ++k)
  {
    const int node = rates_.innerIndexPtr()[3 * k] / 3;
    const Eigen::Map<const Eigen::RowVector3d> rate(rates_.valuePtr() + 3 * k);
    for (Eigen::Index a = 0; a < count; ++a)
    {
      along.innerIndexPtr()[count * k + a] = static_cast<int>(count * node + a);
      along.valuePtr()[count * k + a] = rate.dot(directions.row(node).segment<3>(3 * a));
    }
  }
  return along;
}

Eigen::VectorXd VesicleLoads::load() const
{
  Eigen::VectorXd sum =
    taut_load_.size() > 0 ? taut_load_ : Eigen::VectorXd(Eigen::VectorXd::Zero(gradient_.size()));
  for (const Eigen::VectorXd& load : loads_)
    sum += load;
  return sum;
}

Eigen::VectorXd VesicleLoads::tension_rows(
  const Eigen::VectorXd& velocity, const Eigen::VectorXd& tension) const
{
  Eigen::VectorXd rows = area_rates(velocity);
  if (tension.size() == 0)
    return rows;
  rows += constraint().filter * tension;
  if (taut())
    rows -= gauge * surface_->vertex_area.dot(tension) / surface_->area * surface_->vertex_area;
  return rows;
}

Eigen::VectorXd VesicleLoads::area_rates(const Eigen::VectorXd& velocity) const
{
  return constraint().rate * velocity +
    area_share_.dot(velocity) / surface_->area * surface_->vertex_area;
}

Eigen::VectorXd VesicleLoads::area_rates_adjoint(const Eigen::VectorXd& tension) const
{
  return constraint().rate.transpose() * tension +
    surface_->vertex_area.dot(tension) / surface_->area * area_share_;
}

Eigen::VectorXd VesicleLoads::density(const Eigen::VectorXd& load) const
{
  return flat(Points(Eigen::MatrixXd(mass_factors_.solve(Eigen::MatrixXd(rows_of_three(load))))));
}

Eigen::VectorXd VesicleLoads::load_of(const Eigen::VectorXd& density) const
{
  return flat(Points(mass_ * rows_of_three(density)));
}

Points VesicleLoads::at_vertices(const NodalForce& force) const
{
  return rows_of_three(surface_->collocation().to_vertices(force.vector));
}

Points VesicleLoads::tension_at_vertices(const Eigen::VectorXd& tension) const
{
  return at_vertices({ {}, density(-area_rates_adjoint(tension)) });
}

double VesicleLoads::power(const NodalForce& force, const Eigen::VectorXd& velocity) const
{
  return load_of(force.vector).dot(surface_->to_control(velocity));
}

// ∮ f·v dS = −∮ γ ∇_s·v dS
double VesicleLoads::tension_power(
  const Eigen::VectorXd& tension, const Eigen::VectorXd& velocity) const
{
  return -tension.dot(area_rates(surface_->to_control(velocity)));
}

}
