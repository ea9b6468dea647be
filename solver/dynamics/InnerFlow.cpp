#include "solver/dynamics/InnerFlow.h"

#include "solver/Errors.h"
#include "solver/dynamics/LocalPreconditioner.h"
#include "solver/linear/Gmres.h"

#include <fmt/format.h>

namespace vesicle
{

InnerFlow::InnerFlow(
  const VesicleLoads& loads, const LayerRules& rules, const LayerSettings& settings)
  : loads_(loads),
    layers_(layer_maps(
      { { &rules, loads.surface().vertices, loads.surface().control } }, { 1 }, settings)),
    layer_inverse_(layer_inverse(loads))
{
}

Eigen::VectorXd InnerFlow::velocity_of(const Eigen::VectorXd& load, double allowed) const
{
  const Surface& surface = loads_.surface();
  return layers_.single({ loads_.density(load) }, allowed) +
    loads_.normal().dot(load) / surface.area * flat(surface.normals);
}

Eigen::VectorXd InnerFlow::traction(const Eigen::VectorXd& velocity) const
{
  // Of the velocity: far below what the mesh leaves of the power.
  constexpr double tolerance = 1e-6;
  constexpr int max_iterations = 200;
  const Surface& surface = loads_.surface();
  const Eigen::VectorXd left =
    velocity / 2 - layers_.contrast({ surface.to_control(velocity) }, velocity, 0);
  const GmresResult result =
    gmres([&](const Eigen::VectorXd& load, double allowed) { return velocity_of(load, allowed); },
      [&](const Eigen::VectorXd& residual) -> Eigen::VectorXd
      { return flat(Points(layer_inverse_ * rows_of_three(surface.to_control(residual)))); },
      left, [&](const Eigen::VectorXd&) { return tolerance * velocity.norm(); }, max_iterations);
  if (!result.converged)
    throw NumericalError(
      fmt::format("the traction of the flow inside did not converge: residual {:.1e} after {} "
                  "iterations",
        result.residual, result.iterations));
  return result.solution;
}

}
