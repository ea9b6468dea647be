#pragma once
// Velocities that forces or stresslets at points make at other points: the part of the layers that
// knows nothing of surfaces.

#include "solver/mesh/TriangleMesh.h"
#include "solver/stokes/PointGrid.h"
#include "solver/surface/SurfaceIntegrals.h"

#include <functional>
#include <memory>

#include <vector>

namespace vesicle
{

/// What rounding to single precision leaves of the velocity, at the most, root mean square: points on a sphere
/// and random forces leave 2e-7, images of a wall near by up to 1.2e-6.
inline constexpr double single_precision_error = 2e-6;

/// Where the points are is set once. The place of a tree, an FMM or another device.
class PointSum
{
public:
  virtual ~PointSum() = default;
  /// velocity += the sum over all sources at every target, N by 3; `strengths`: a row a source, with
  /// the kernel's factor in them. It may be off by `allowed`, relative to the velocity, root mean
  /// square, about; 0: by what it leaves at its best.
  virtual void add(
    const Eigen::Ref<const Eigen::MatrixXd>& strengths, double allowed, Points& velocity) const = 0;
};

/// Where sources and targets are, one body's after the other's.
struct PointPlaces
{
  RowVectors sources;
  Points targets;
  /// Of each body, and the number of all; empty: of one.
  std::vector<int> first_source = {}, first_target = {};
};

/// What makes a sum between sources and targets.
using MakePointSum = std::function<std::unique_ptr<const PointSum>(const PointPlaces&)>;

/// The symmetric parts of a bᵀ, row by row: xx, xy, xz, yy, yz, zz.
Eigen::Matrix<double, Eigen::Dynamic, 6> symmetric_products(
  const RowVectors& a, const RowVectors& b);

/// Where single precision has the most digits: from this origin. An image's wall stays z = 0.
Eigen::RowVector3d summation_origin(PointKind kind, const Points& targets);

/// Pair by pair. No target may be a source. Threads share the targets; results do not depend on their
/// number.
template<PointKind kind>
class DirectPointSum final : public PointSum
{
public:
  DirectPointSum(const RowVectors& sources, const Points& targets);
  void add(const Eigen::Ref<const Eigen::MatrixXd>& strengths, double allowed,
    Points& velocity) const override;

private:
  DirectPointSum(
    const RowVectors& sources, const Points& targets, const Eigen::RowVector3d& origin);
  template<class Real>
  struct Places
  {
    Places(const RowVectors& sources, const RowVectors& targets);
    PointGrid<Real> grid;
    typename PointGrid<Real>::Positions sources;
    std::vector<Coordinate<Real>> targets; ///< x, y, z of sum_lanes targets, and so on
  };
  template<class Real>
  void add(const Places<Real>& at, const Eigen::Ref<const Eigen::MatrixXd>& strengths,
    Points& velocity) const;

  Places<double> full_;
  Places<float> single_;
};
using DirectSum = DirectPointSum<PointKind::force>;

extern template class DirectPointSum<PointKind::force>;
extern template class DirectPointSum<PointKind::stresslet>;
extern template class DirectPointSum<PointKind::force_image>;
extern template class DirectPointSum<PointKind::stresslet_image>;

}
