#include "solver/dynamics/LoadStage.h"

#include "solver/Errors.h"
#include "solver/ParallelFor.h"
#include "solver/linear/Gmres.h"
#include "solver/dynamics/LocalPreconditioner.h"
#include "solver/surface/RigidMotions.h"

#include <fmt/format.h>

#include <cmath>

namespace vesicle
{

LoadStage::LoadStage(const SystemShape& shape, LayerMaps layers, double tau,
  const Eigen::VectorXd& reference, const State& guess)
  : shape_(shape), layers_(std::move(layers)), tau_(tau)
{
  std::vector<Eigen::VectorXd> scales;
  for (std::size_t v = 0; v < count(); ++v)
  {
    const VesicleLoads& own = loads(v);
    const Surface& surface = own.surface();
    known_load_.push_back(own.load());
    reference_load_.push_back(implicit(v) && reference.size() > 0
        ? Eigen::VectorXd(
            -own.stiff_load(tau, own.deformation().parameters(shape.part(reference, v))))
        : Eigen::VectorXd());
    if (reference_load_.back().size() > 0)
      known_load_.back() += reference_load_.back();
    guess_.push_back(unknowns_of(v, guess));
    const bool has_guess =
      v < guess.vesicles.size() && guess.vesicles[v].velocity.rows() == surface.vertices.rows();
    guessed_velocity_.push_back(
      has_guess ? Eigen::VectorXd(flat(guess.vesicles[v].velocity)) : Eigen::VectorXd());

    // Rows as velocities: a residual of 1 is an error of the velocity of about 1.
    const Eigen::Index parameters = has_parameters(v) ? own.deformation().size() : 0,
                       n = own.has_tension() ? surface.vertices.rows() : 0, extra = 2;
    const Eigen::Index contrast = has_contrast() ? 3 * surface.vertices.rows() : 0;
    Eigen::VectorXd scale = Eigen::VectorXd::Ones(parameters + n + extra + contrast);
    if (n > 0)
      scale.segment(parameters, n) =
        3 * std::sqrt(surface.area / static_cast<double>(n)) * surface.vertex_area.cwiseInverse();
    scale.segment(parameters + n, extra).setConstant(1 / surface.area);
    first_.push_back(first_.back() + scale.size());
    scales.push_back(std::move(scale));
  }
  scale_.resize(unknowns());
  for (std::size_t v = 0; v < count(); ++v)
    scale_.segment(first_[v], scales[v].size()) = scales[v];
}

std::vector<LoadUnknowns> LoadStage::split(const Eigen::VectorXd& x) const
{
  std::vector<LoadUnknowns> result;
  for (std::size_t v = 0; v < count(); ++v)
  {
    const VesicleLoads& own = loads(v);
    LoadUnknowns& part = result.emplace_back();
    Eigen::Index at = first_[v];
    if (has_parameters(v))
    {
      part.parameters = x.segment(at, own.deformation().size());
      at += part.parameters.size();
    }
    if (own.has_tension())
    {
      part.tension = x.segment(at, own.surface().vertices.rows());
      at += part.tension.size();
    }
    part.pressure = x[at++];
    part.volume_speed = x[at++];
    part.contrast = x.segment(at, first_[v + 1] - at);
  }
  return result;
}

Eigen::VectorXd LoadStage::join(const std::vector<LoadUnknowns>& parts) const
{
  Eigen::VectorXd x(unknowns());
  for (std::size_t v = 0; v < count(); ++v)
  {
    const LoadUnknowns& part = parts[v];
    Eigen::Index at = first_[v];
    x.segment(at, part.parameters.size()) = part.parameters;
    at += part.parameters.size();
    x.segment(at, part.tension.size()) = part.tension;
    at += part.tension.size();
    x[at++] = part.pressure;
    x[at++] = part.volume_speed;
    x.segment(at, part.contrast.size()) = part.contrast;
  }
  return x;
}

LoadUnknowns LoadStage::unknowns_of(std::size_t v, const State& guess) const
{
  const VesicleLoads& own = loads(v);
  const Eigen::Index n = own.surface().vertices.rows();
  LoadUnknowns x;
  if (has_parameters(v))
    x.parameters = Eigen::VectorXd::Zero(own.deformation().size());
  if (own.has_tension())
    x.tension = Eigen::VectorXd::Zero(n);
  if (v >= guess.vesicles.size() || guess.vesicles[v].velocity.rows() != n)
    return x;
  const VesicleState& near = guess.vesicles[v];
  if (has_parameters(v))
    x.parameters = own.deformation().parameters(flat(near.velocity));
  if (own.has_tension() && near.tension.size() == n)
    x.tension = near.tension;
  x.pressure = near.pressure;
  x.volume_speed = near.volume_speed;
  return x;
}

bool LoadStage::implicit(std::size_t v) const
{
  return loads(v).stiff() && tau_ > 0;
}

bool LoadStage::has_parameters(std::size_t v) const
{
  return implicit(v) || loads(v).taut() || loads(v).viscous();
}

Eigen::VectorXd LoadStage::load_of(std::size_t v, const LoadUnknowns& x) const
{
  const VesicleLoads& own = loads(v);
  Eigen::VectorXd load = Eigen::VectorXd::Zero(own.gradient().size());
  if (x.parameters.size() > 0)
  {
    if (implicit(v))
      load += own.stiff_load(tau_, x.parameters);
    if (own.viscous())
      load += own.viscous_load(x.parameters);
    if (own.taut())
      load += own.resisting_load(x.parameters);
  }
  if (x.tension.size() > 0)
    load -= own.area_rates_adjoint(x.tension);
  if (x.pressure != 0)
    load -= x.pressure * own.volume_rate();
  return load;
}

Eigen::VectorXd LoadStage::velocity_of(const std::vector<Eigen::VectorXd>& loads,
  const std::vector<LoadUnknowns>& x, double allowed) const
{
  std::vector<Eigen::VectorXd> densities(count());
  parallel_for(count(), [&](std::size_t v) { densities[v] = this->loads(v).density(loads[v]); });
  Eigen::VectorXd velocity = layers_.single(densities, allowed);
  for (std::size_t v = 0; v < loads.size(); ++v)
  {
    auto own = velocity.segment(3 * shape_.first[v], loads[v].size());
    own = share_of_layer(v) * own + x[v].volume_speed * flat(this->loads(v).surface().normals);
    if (x[v].contrast.size() > 0)
      own += x[v].contrast;
  }
  return velocity;
}

double LoadStage::share_of_layer(std::size_t v) const
{
  return 2 / (1 + loads(v).viscosity_ratio());
}

Eigen::VectorXd LoadStage::imposed_share(std::size_t v) const
{
  return share_of_layer(v) * shape_.part(shape_.imposed, v);
}

// Σ (1 − λ) (K u + n̂ (Qᵀv·u)/2A).
Eigen::VectorXd LoadStage::contrast_of(const std::vector<Eigen::VectorXd>& control,
  const Eigen::VectorXd& velocity, double allowed) const
{
  Eigen::VectorXd result = layers_.contrast(control, velocity, allowed);
  for (std::size_t v = 0; v < count(); ++v)
  {
    const Surface& surface = loads(v).surface();
    const double flux = loads(v).volume_rate().dot(control[v]);
    result.segment(3 * shape_.first[v], control[v].size()) +=
      (1 - loads(v).viscosity_ratio()) * flux / (2 * surface.area) * flat(surface.normals);
  }
  return result;
}

// What the guess' velocities have beyond those of the other unknowns, `without`, or as if K were zero.
void LoadStage::start_contrast(std::vector<LoadUnknowns>& x, const Eigen::VectorXd& without) const
{
  for (std::size_t v = 0; v < count(); ++v)
    x[v].contrast = guessed_velocity_[v].size() > 0
      ? Eigen::VectorXd(guessed_velocity_[v] - shape_.part(without, v))
      : imposed_share(v);
}

std::vector<LoadUnknowns> LoadStage::rows(const std::vector<Eigen::VectorXd>& loads,
  const std::vector<LoadUnknowns>& x, const Eigen::VectorXd& velocity, double allowed) const
{
  std::vector<LoadUnknowns> result(count());
  std::vector<Eigen::VectorXd> control(count());
  parallel_for(count(),
    [&](std::size_t v)
    { control[v] = this->loads(v).surface().to_control(shape_.part(velocity, v)); });
  const Eigen::VectorXd contrast =
    has_contrast() ? contrast_of(control, velocity, allowed) : Eigen::VectorXd();
  parallel_for(count(),
    [&](std::size_t v)
    {
      const VesicleLoads& own = this->loads(v);
      LoadUnknowns& part = result[v];
      const Eigen::VectorXd& u = control[v];
      if (has_parameters(v))
      {
        part.parameters = -own.deformation().parameters(shape_.part(velocity, v));
        if (x[v].parameters.size() > 0)
          part.parameters += x[v].parameters;
      }
      if (own.has_tension())
        part.tension = own.tension_rows(u, x[v].tension);
      part.pressure = own.volume_rate().dot(u);
      part.volume_speed = own.normal().dot(loads[v]);
      if (has_contrast())
        part.contrast = x[v].contrast + share_of_layer(v) * shape_.part(contrast, v);
    });
  return result;
}

// w first, as if K acted on its rigid motions alone; then the rest, with the velocities that w makes.
std::vector<LoadUnknowns> LoadStage::precondition(
  const std::vector<LocalPreconditioner>& preconditioners, const std::vector<RigidMotions>& rigid,
  std::vector<LoadUnknowns> residual) const
{
  std::vector<LoadUnknowns> x(count());
  parallel_for(count(),
    [&](std::size_t v)
    {
      const VesicleLoads& own = loads(v);
      LoadUnknowns& left = residual[v];
      Eigen::VectorXd w = left.contrast;
      if (has_contrast())
      {
        w -= (1 - own.viscosity_ratio()) / 2 * rigid[v].nearest(w);
        const Eigen::VectorXd u = own.surface().to_control(w);
        if (has_parameters(v))
          left.parameters += own.deformation().parameters(w);
        if (own.has_tension())
          left.tension -= own.area_rates(u);
        left.pressure -= own.volume_rate().dot(u);
      }
      x[v] = preconditioners[v].solve(own, left);
      x[v].contrast = std::move(w);
    });
  return x;
}

StageSolution LoadStage::solve(const std::vector<LocalPreconditioner>& preconditioners,
  double tolerance, int max_iterations) const
{
  // What is solved for is the difference from the guess.
  std::vector<Eigen::VectorXd> guessed_load;
  for (std::size_t v = 0; v < count(); ++v)
    guessed_load.emplace_back(known_load_[v] + load_of(v, guess_[v]));
  std::vector<LoadUnknowns> guess = guess_;
  Eigen::VectorXd guessed_velocity = velocity_of(guessed_load, guess);
  std::vector<RigidMotions> rigid;
  if (has_contrast())
  {
    start_contrast(guess, guessed_velocity);
    for (std::size_t v = 0; v < count(); ++v)
    {
      guessed_velocity.segment(3 * shape_.first[v], guess[v].contrast.size()) += guess[v].contrast;
      rigid.emplace_back(loads(v).surface().vertices, loads(v).surface().vertex_area);
    }
  }
  else
    guessed_velocity += shape_.imposed;
  std::vector<LoadUnknowns> left = rows(guessed_load, guess, guessed_velocity);
  if (has_contrast())
    for (std::size_t v = 0; v < count(); ++v)
      left[v].contrast -= imposed_share(v);
  const Eigen::VectorXd b = -join(left).cwiseProduct(scale_);
  // The velocities that the Krylov vectors make, for the true size of the solution's.
  std::vector<Eigen::VectorXd> velocities;
  const auto apply = [&](const Eigen::VectorXd& y, double allowed) -> Eigen::VectorXd
  {
    const std::vector<LoadUnknowns> x = split(y);
    std::vector<Eigen::VectorXd> loads(count());
    parallel_for(count(), [&](std::size_t v) { loads[v] = load_of(v, x[v]); });
    velocities.push_back(velocity_of(loads, x, allowed));
    return join(rows(loads, x, velocities.back(), allowed)).cwiseProduct(scale_);
  };
  const auto precondition = [&](const Eigen::VectorXd& r) -> Eigen::VectorXd
  { return join(this->precondition(preconditioners, rigid, split(r.cwiseQuotient(scale_)))); };
  const auto velocity_with = [&](const Eigen::VectorXd& coefficients)
  {
    Eigen::VectorXd velocity = guessed_velocity;
    for (Eigen::Index i = 0; i < coefficients.size(); ++i)
      velocity += coefficients[i] * velocities[i];
    return velocity;
  };
  const auto wanted = [&](const Eigen::VectorXd& coefficients)
  { return tolerance * velocity_with(coefficients).norm(); };
  const GmresResult linear = gmres(apply, precondition, b, wanted, max_iterations);
  if (!linear.solution.allFinite() || !std::isfinite(linear.residual))
    throw NumericalError(
      fmt::format("the linear system of {} unknowns has no finite solution", unknowns()));
  if (!linear.converged)
    throw NumericalError(fmt::format(
      "the linear solve of {} unknowns did not converge: residual {:.1e} after {} iterations",
      unknowns(), linear.residual, linear.iterations));

  StageSolution solution = solution_of(split(join(guess) + linear.solution));
  solution.velocity = velocity_with(linear.coefficients);
  solution.iterations = linear.iterations;
  return solution;
}

// All but the velocity and the number of iterations.
StageSolution LoadStage::solution_of(const std::vector<LoadUnknowns>& x) const
{
  StageSolution result;
  for (std::size_t v = 0; v < count(); ++v)
  {
    const VesicleLoads& own = loads(v);
    StageSolution::Part& part = result.vesicles.emplace_back();
    part.tension = x[v].tension;
    part.volume_speed = x[v].volume_speed;
    part.pressure = x[v].pressure;
    part.stiff_force = shape_.vesicles[v].stiff_force;
    Eigen::VectorXd change = reference_load_[v];
    if (implicit(v))
      change = (change.size() > 0 ? change : Eigen::VectorXd::Zero(known_load_[v].size())) +
        own.stiff_load(tau_, x[v].parameters);
    if (change.size() > 0)
      part.stiff_force += own.density(change);
  }
  return result;
}

}
