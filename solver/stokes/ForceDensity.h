#pragma once
// A force density as a function on a surface, whatever it is made of.

#include "solver/surface/SurfaceIntegrals.h"

#include <functional>

namespace vesicle
{

/// f, a force an area, at the rows of a basis table at a shape: #rows by 3.
using ForceDensity = std::function<RowVectors(const BasisTable&, const SurfacePoints&)>;

/// Σ N_k f_k of vectors at the nodes, N by 3.
ForceDensity nodal_density(const Points& nodal);
/// Σ N_k φ_k n with the surface's own normal: φ at the nodes, N.
ForceDensity normal_density(const Eigen::VectorXd& nodal);

}
