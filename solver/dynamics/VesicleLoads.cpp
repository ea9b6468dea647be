#include "solver/dynamics/VesicleLoads.h"

#include "solver/ParallelFor.h"
#include "solver/linear/GroupedRows.h"
#include "solver/linear/Symmetric.h"
#include "solver/membrane/SurfaceViscosity.h"

#include <algorithm>
#include <iterator>

namespace vesicle
{

namespace
{

// Of a taut sphere, over the fluid's viscosity times its radius: large enough that what it lets
// through is negligible.
constexpr double taut_resistance = 1e4;

}

VesicleLoads::VesicleLoads(const Vesicle& vesicle, const Surface& surface,
  std::shared_ptr<const ConstraintRows> constraint, double rate, const Eigen::VectorXd& from_others)
  : surface_(&surface), viscosity_ratio_(vesicle.viscosity_ratio),
    motion_(
      surface, constraint && constraint->gauge_pinned ? NodeMotionKind::normal : vesicle.motion),
    gradient_(Eigen::VectorXd::Zero(3 * surface.vertices.rows())),
    constraint_(std::move(constraint)), normal_(surface.to_control(flat(surface.normals)))
{
  if (vesicle.surface_viscosity > 0)
    deformation_.emplace(surface, NodeMotionKind::material);
  run_together(
    { [&] { make_mass(); }, [&] { add_terms(vesicle.terms); }, [&] { add_constraints(); },
      [&]
      {
        if (vesicle.surface_viscosity > 0)
          viscosity_ = viscosity_matrix(surface, vesicle.surface_viscosity);
      } });
  if (constraint_ && constraint_->gauge_pinned)
    hold_taut(rate);
  if (from_others.size() > 0)
    load_from_others_ = -motion_.adjoint(from_others);
}

void VesicleLoads::make_mass()
{
  mass_ = mass_matrix(surface_->space->table(), surface_->points);
  mass_factors_.compute(by_columns(mass_), surface_->space->plans());
}

void VesicleLoads::add_terms(const MembraneTerms& terms)
{
  std::vector<EntryVectors> rates;
  for (const auto& term : terms)
  {
    Variation variation = term->variation(*surface_);
    loads_.emplace_back(-motion_.adjoint(variation.gradient));
    if (!term->external())
      gradient_ += variation.gradient;
    std::move(variation.rates.begin(), variation.rates.end(), std::back_inserter(rates));
  }
  if (!rates.empty())
    stiffness_ = gauss_newton_matrix(surface_->space->table(), rates);
}

void VesicleLoads::add_constraints()
{
  const BasisTable& table = surface_->space->table();
  volume_gradient_ = vesicle::volume_gradient(table, surface_->points);
  volume_rate_ = motion_.adjoint(volume_gradient_);
  area_gradient_ = vesicle::area_gradient(table, surface_->points);
  area_share_ = motion_.adjoint(area_gradient_) - area_gradient_;
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

Eigen::VectorXd VesicleLoads::motion_of(const Eigen::VectorXd& deformation) const
{
  if (!deformation_ || motion_.kind() == NodeMotionKind::material)
    return deformation;
  return motion_.parameters(surface_->collocation().to_vertices(deformation));
}

Eigen::VectorXd VesicleLoads::stiff_load(double tau, const Eigen::VectorXd& deformation) const
{
  return -tau *
    motion_.parameters_adjoint(
      motion_.velocity_adjoint(stiff_force(motion_.velocity(motion_of(deformation)))));
}

// V feels nothing of the rigid part that a deformation doesn't have.
Eigen::VectorXd VesicleLoads::viscous_load(const Eigen::VectorXd& deformation) const
{
  return -(viscosity_ * deformation);
}

Eigen::VectorXd VesicleLoads::resisting_load(const Eigen::VectorXd& deformation) const
{
  const Collocation& collocation = surface_->collocation();
  return -motion_.parameters_adjoint(collocation.fit_adjoint(
    resistance_ * Eigen::VectorXd(collocation.fit(motion_of(deformation)))));
}

Eigen::VectorXd VesicleLoads::taut_load(const Eigen::VectorXd& at_vertices) const
{
  return taut_load_ + resisting_load(deformation().parameters(at_vertices));
}

Eigen::VectorXd VesicleLoads::stiff_force(const Eigen::VectorXd& displacement) const
{
  return multiply_grouped(stiffness_, 3, displacement);
}

SparseMatrix VesicleLoads::stiffness_along(const Eigen::Ref<const DirectionRows>& directions) const
{
  const int count = static_cast<int>(directions.cols() / 3),
            nodes = static_cast<int>(directions.rows());
  SparseMatrix along(count * nodes, count * nodes);
  along.resizeNonZeros(stiffness_.nonZeros() / 9 * count * count);
  const int* start = stiffness_.outerIndexPtr();
  int next = 0;
  for (int i = 0; i < nodes; ++i)
  {
    const int pairs = (start[3 * i + 1] - start[3 * i]) / 3;
    for (int a = 0; a < count; ++a)
    {
      const Eigen::RowVector3d from = directions.row(i).segment<3>(3 * a);
      along.outerIndexPtr()[count * i + a] = next;
      for (int p = 0; p < pairs; ++p)
      {
        const int j = stiffness_.innerIndexPtr()[start[3 * i] + 3 * p] / 3;
        Eigen::RowVector3d pulled = Eigen::RowVector3d::Zero();
        for (int d = 0; d < 3; ++d)
          pulled += from[d] *
            Eigen::Map<const Eigen::RowVector3d>(stiffness_.valuePtr() + start[3 * i + d] + 3 * p);
        for (int b = 0; b < count; ++b, ++next)
        {
          along.innerIndexPtr()[next] = count * j + b;
          along.valuePtr()[next] = pulled.dot(directions.row(j).segment<3>(3 * b));
        }
      }
    }
  }
  along.outerIndexPtr()[count * nodes] = next;
  return along;
}

Eigen::VectorXd VesicleLoads::load() const
{
  Eigen::VectorXd sum =
    taut_load_.size() > 0 ? taut_load_ : Eigen::VectorXd(Eigen::VectorXd::Zero(gradient_.size()));
  for (const Eigen::VectorXd& load : loads_)
    sum += load;
  if (load_from_others_.size() > 0)
    sum += load_from_others_;
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
  return multiply_grouped(constraint().rate, 1, velocity) +
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
