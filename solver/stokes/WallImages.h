#pragma once
// What a plane wall adds to the layers of surfaces beside it, at their vertices: the images of all
// points of the regular rules, and sparse corrections where a surface is near the wall.

#include "solver/stokes/PointSum.h"
#include "solver/stokes/StokesOperator.h"
#include "solver/stokes/Wall.h"
#include "solver/surface/RigidMotions.h"

namespace vesicle
{

/// At the operator's shape. The surfaces' rules must outlive it, the operator need not.
///
/// All is done in the wall's frame (WallFrame) with the mirrored surfaces, from which the images seem
/// to come: for them the vertices of all surfaces, their own too, are vertices beside them, whose
/// peaks get rules of their own where a surface is nearer to the wall than some two edges.
///
/// The images of the double layer of a rigid motion are zero: nothing but what a velocity has beyond the
/// nearest rigid motion is summed, so that rigid motions are as exact as without a wall.
class WallImages
{
public:
  /// `kind`: of the layer, forces or stresslets; `factors`: of each surface's layer; `make_sum`: of that
  /// kind's images.
  WallImages(const StokesOperator& layer, const Wall& wall, PointKind kind,
    const std::vector<double>& factors, const MakePointSum& make_sum);

  /// To the velocities at all vertices, 3N, what f = Σ N_k f_k adds (LayerSum), or u (DoubleLayer): 3
  /// numbers a node of each surface. Threads share points and vertices; results do not depend on
  /// their number.
  void add(
    const std::vector<Eigen::VectorXd>& nodal, double allowed, Eigen::VectorXd& velocities) const;

private:
  struct Source
  {
    const BasisTable* table;
    double factor;
    Eigen::VectorXd weight; ///< of the table's rows; contains dS/8πμ and the factor
    RowVectors normal;      ///< mirrored, times the weight; of stresslets only
    int first_point;        ///< among all
    std::optional<NearSurfaceCorrections> near;
    std::optional<RigidMotions> rigid; ///< of the control points; of stresslets only
  };
  Points mirrored(const Source& source, const Eigen::VectorXd& nodal) const;
  Eigen::MatrixXd strengths(const Source& source, const Points& mirrored) const;

  WallFrame frame_;
  PointKind kind_;
  std::vector<Source> sources_;
  std::unique_ptr<const PointSum> sum_;
  int points_ = 0;
};

}
