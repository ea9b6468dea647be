#pragma once
// The double layer of a surface's velocity anywhere in the fluids, right up to the surface and on it.

#include "solver/stokes/SurfacePanels.h"

#include <span>
#include <vector>

namespace vesicle
{

/// (K u)(x) of DoubleLayer.h at points that have nothing to do with the mesh. Near the surface the
/// velocity u* of the nearest point is taken out, K u = K (u − u*) + u* inside the surface, + 0
/// outside, and near panels have a rule for x (NearRule.h).
class PanelContrast
{
public:
  /// The panels have a velocity and must outlive it.
  explicit PanelContrast(const SurfacePanels& panels);

  /// N by 3. `inside`: 1 of the points that the surface encloses. Threads share the points; results
  /// do not depend on their number.
  Points at(const Points& points, const std::vector<unsigned char>& inside) const;

private:
  Vector3 near_surface(const Vector3& x, std::span<const int> near, bool inside) const;

  const SurfacePanels& panels_;
  int rows_per_panel_;
  RowVectors position_, velocity_, area_; ///< the fixed rule's rows; 3/4π n dS
  Eigen::Matrix<double, Eigen::Dynamic, 6> strength_;
};

}
