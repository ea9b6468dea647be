#pragma once
// How sums over points take positions and strengths in either precision (kernels/StokesletKernel.h).

#include "solver/stokes/kernels/StokesletKernel.h"
#include "solver/surface/SurfaceIntegrals.h"

#include <cmath>
#include <type_traits>

namespace vesicle
{

/// Double precision takes positions as they are. Single precision counts them in a spacing so small that it
/// doesn't matter, half a billionth of what there is.
template<class Real>
class PointGrid
{
public:
  using Positions = Eigen::Array<Coordinate<Real>, Eigen::Dynamic, 3>;

  /// Of coordinates up to `extent`, which isn't finite where one of them isn't.
  explicit PointGrid(double extent)
  {
    constexpr double most = (1 << 30) - 1; // of which differences fit into Coordinate
    if (!std::is_same_v<Real, double> && extent != 0)
      spacing_ = extent / most;
  }

  Positions positions(const RowVectors& x) const
  {
    if constexpr (std::is_same_v<Real, double>)
      return x.array();
    if (!std::isfinite(spacing_)) // a step gone wrong: unit() tells
      return Positions::Zero(x.rows(), 3);
    return (x.array() / spacing_).rint().template cast<Coordinate<Real>>();
  }

  /// A field's unit in the grid's; not a number where a position isn't.
  double unit(PointKind kind) const
  {
    const double inverse = std::isfinite(spacing_) ? 1 / spacing_ : NAN;
    return components_of(kind) == 3 ? inverse : inverse * inverse; // forces' go with 1/r
  }

private:
  double spacing_ = 1;
};

/// The largest coordinate; not finite where one isn't.
inline double extent_of(const RowVectors& x)
{
  return x.array().abs().template maxCoeff<Eigen::PropagateNaN>();
}

/// What strengths are divided by to stay in the range of Real, however small they are.
template<class Real>
double strength_unit(const Eigen::Ref<const Eigen::MatrixXd>& strengths)
{
  const double largest =
    std::is_same_v<Real, double> || strengths.size() == 0 ? 0 : strengths.cwiseAbs().maxCoeff();
  return largest > 0 ? largest : 1;
}

}
