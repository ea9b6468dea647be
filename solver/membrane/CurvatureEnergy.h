#pragma once
// Energies that know the shape by its curvature alone, E = ∮ φ(2H) dS + f(A, M) with M = ∮ H dS, and
// what their first and second variations are made of.

#include "solver/surface/CurvatureFunctional.h"

namespace vesicle
{

/// The sum of terms at one shape. ∂E/∂c is the gradient of `density`; ∂²E/∂c² is its second variation
/// and mean_stiffness ∇M ∇Mᵀ, for changes that keep the area.
struct CurvatureEnergy
{
  explicit CurvatureEnergy(Eigen::Index rows) : density(rows) {}

  double energy = 0;
  CurvatureDensity density;
  double mean_stiffness = 0;
};

}
