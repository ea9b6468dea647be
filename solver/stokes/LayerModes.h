#pragma once
// Eigenfunctions of the single layer on the unit sphere.

#include "solver/mesh/TriangleMesh.h"

#include <functional>
#include <vector>

namespace vesicle
{

/// S f = eigenvalue · f with μ = 1 on the unit sphere. For vector harmonics of order l with the
/// solid harmonic p_l: ∇p = grad Y + l Y n is W_l, (l + 1)/((2l + 1)(2l − 1)); V_l = grad Y − (l +
/// 1) Y n, l/((2l + 1)(2l + 3)); toroidal x × grad Y, 1/(2l + 1).
struct LayerMode
{
  const char* name;
  std::function<Vector3(const Vector3&)> field;
  double eigenvalue;
};

/// Translation 2/3, rotation 1/3, strain 1/5, and toroidal, V and W for l = 2.
const std::vector<LayerMode>& sphere_layer_modes();

}
