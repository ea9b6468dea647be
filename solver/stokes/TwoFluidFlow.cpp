#include "solver/stokes/TwoFluidFlow.h"

#include "solver/stokes/MembraneFlow.h"

namespace vesicle
{

TwoFluidFlow::TwoFluidFlow(const TriangleMesh& mesh, SurfaceBasis basis, const Points& forces,
  const Points& velocities, double viscosity, double viscosity_ratio,
  const std::optional<Wall>& wall)
  : viscosity_(viscosity), ratio_(viscosity_ratio), wall_(wall)
{
  const bool one_fluid = ratio_ == 1;
  const Points moving = one_fluid ? Points() : velocities;
  layer_ = std::make_unique<const FlowField>(membrane_flow(mesh, basis, forces, moving));
  if (!one_fluid)
    contrast_.emplace(layer_->panels());
  if (wall)
    images_.emplace(*wall, mesh, basis, forces, moving);
}

FlowField::Flow TwoFluidFlow::at(const Points& points, const Points& imposed) const
{
  FlowField::Flow flow = layer_->at(points);
  flow.velocity = imposed + flow.velocity / viscosity_;
  if (contrast_)
    flow.velocity -= (1 - ratio_) * contrast_->at(points, flow.inside);
  if (images_)
    flow.velocity += images_->at(points, 1 / viscosity_, ratio_ - 1);
  for (Eigen::Index i = 0; i < points.rows() && contrast_; ++i)
    if (flow.inside[i] != 0)
      flow.velocity.row(i) *= ratio_ > 0 ? 1 / ratio_ : 0;
  if (wall_)
    rest_behind(*wall_, points, flow.velocity);
  return flow;
}

}
