#pragma once
// The flow around and inside a membrane between two fluids, from what a frame of a run holds: forces and
// velocities at the vertices.

#include "solver/stokes/FlowField.h"
#include "solver/stokes/PanelContrast.h"
#include "solver/stokes/WallFlow.h"
#include "solver/surface/SurfaceBasis.h"

#include <memory>
#include <optional>

namespace vesicle
{

/// Outside u = u∞ + S f/μ − (1 − λ) K u, inside λ u is that, λ the viscosity ratio of inside to
/// outside. With λ = 0 nothing is known of the fluid inside: its velocity is given as 0. With a wall both
/// layers have their images; behind it the velocity is 0.
class TwoFluidFlow
{
public:
  /// In any consistent units; `forces` on the fluids and `velocities` at the vertices, N by 3, as for
  /// membrane_flow. Velocities may be empty where `viscosity_ratio` is 1. Throws InputError if the
  /// mesh can't carry the basis.
  TwoFluidFlow(const TriangleMesh& mesh, SurfaceBasis basis, const Points& forces,
    const Points& velocities, double viscosity, double viscosity_ratio,
    const std::optional<Wall>& wall = {});

  /// `imposed`: u∞ at the points, N by 3.
  FlowField::Flow at(const Points& points, const Points& imposed) const;

private:
  double viscosity_, ratio_;
  std::unique_ptr<const FlowField> layer_;
  std::optional<PanelContrast> contrast_; ///< none: one viscosity
  std::optional<Wall> wall_;
  std::optional<WallFlow> images_; ///< none: no wall
};

}
