#include "solver/stokes/TwoFluidFlow.h"

#include "solver/stokes/MembraneFlow.h"

namespace vesicle
{

TwoFluidFlow::TwoFluidFlow(const TriangleMesh& mesh, SurfaceBasis basis, const Points& forces,
  const Points& velocities, double viscosity, double viscosity_ratio)
  : viscosity_(viscosity), ratio_(viscosity_ratio)
{
  const bool one_fluid = ratio_ == 1;
  layer_ = std::make_unique<const FlowField>(
    membrane_flow(mesh, basis, forces, one_fluid ? Points() : velocities));
  if (!one_fluid)
    contrast_.emplace(layer_->panels());
}

FlowField::Flow TwoFluidFlow::at(const Points& points, const Points& imposed) const
{
  FlowField::Flow flow = layer_->at(points);
  flow.velocity = imposed + flow.velocity / viscosity_;
  if (!contrast_)
    return flow;
  flow.velocity -= (1 - ratio_) * contrast_->at(points, flow.inside);
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    if (flow.inside[i] != 0)
      flow.velocity.row(i) *= ratio_ > 0 ? 1 / ratio_ : 0;
  return flow;
}

}
