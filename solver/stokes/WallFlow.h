#pragma once
// What a plane wall adds to the flow of a membrane, anywhere in the fluids.

#include "solver/stokes/SurfacePanels.h"
#include "solver/stokes/Wall.h"
#include "solver/surface/SurfaceBasis.h"

namespace vesicle
{

/// The images of a surface's single and double layer, as those of FlowField and PanelContrast, whose rules
/// they have: panels near a point's mirror point have one made for it.
class WallFlow
{
public:
  /// As for membrane_flow.
  WallFlow(const Wall& wall, const TriangleMesh& mesh, SurfaceBasis basis, const Points& forces,
    const Points& velocities);

  /// `layer` times the images of S f, for μ = 1, plus `contrast` times those of K u, N by 3. `contrast`
  /// is 0 where there are no velocities. Threads share the points; results do not depend on their number.
  Points at(const Points& points, double layer, double contrast) const;

private:
  Vector3 fixed(int panel, const Vector3& x, double layer, double contrast) const;
  Vector3 near(int panel, const Vector3& x, double layer, double contrast) const;

  WallFrame frame_;
  SurfacePanels panels_; ///< mirrored
  int rows_per_panel_;
  RowVectors position_, force_, velocity_, area_; ///< the fixed rule's rows; 3/4π n dS
};

}
