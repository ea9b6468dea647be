#pragma once
// The layers of vesicles at one shape as maps on densities and velocities, summed in the way that
// settings say.

#include "solver/dynamics/Method.h"
#include "solver/stokes/PointSum.h"
#include "solver/stokes/StokesOperator.h"
#include "solver/stokes/Wall.h"

#include <functional>
#include <optional>

namespace vesicle
{

/// The velocities at all vertices (3N) that force densities at the nodes of each vesicle make, off by
/// no more than is allowed (PointSum).
using LayerMap = std::function<Eigen::VectorXd(const std::vector<Eigen::VectorXd>&, double)>;

/// Σ (1 − λ) K u at all vertices (3N), of each vesicle's velocities at the nodes and of all at the
/// vertices, off by no more than is allowed.
using ContrastMap = std::function<Eigen::VectorXd(
  const std::vector<Eigen::VectorXd>&, const Eigen::VectorXd&, double)>;

struct LayerMaps
{
  LayerMap single;
  ContrastMap contrast; ///< empty where all fluids have the same viscosity
};

/// `contrasts`: 1 − λ of each; `wall`: beside all of them. The surfaces' rules must outlive the maps.
LayerMaps layer_maps(std::vector<LayerSurface> surfaces, const std::vector<double>& contrasts,
  const LayerSettings& settings, const std::optional<Wall>& wall = std::nullopt);

}
