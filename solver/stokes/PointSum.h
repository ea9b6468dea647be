#pragma once
// Velocities that forces or stresslets at points make at other points: the part of the layers that
// knows nothing of surfaces.

#include "solver/mesh/TriangleMesh.h"
#include "solver/stokes/kernels/StokesletKernel.h"
#include "solver/surface/SurfaceIntegrals.h"

#include <functional>
#include <memory>

#include <vector>

namespace vesicle
{

enum class Precision
{
  single, ///< leaves single_precision_error
  full
};
/// Relative to the velocity, root mean square: points on a sphere and random forces leave 7e-6.
inline constexpr double single_precision_error = 1e-5;

/// Where the points are is set once. The place of a tree, an FMM or another device.
class PointSum
{
public:
  virtual ~PointSum() = default;
  /// velocity += the sum over all sources at every target, N by 3; `strengths`: a row a source, with
  /// the kernel's factor in them.
  virtual void add(const Eigen::Ref<const Eigen::MatrixXd>& strengths, Precision precision,
    Points& velocity) const = 0;
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
  void add(const Eigen::Ref<const Eigen::MatrixXd>& strengths, Precision precision,
    Points& velocity) const override;

private:
  template<class Real>
  struct Places
  {
    Eigen::Array<Real, Eigen::Dynamic, 3> sources;
    std::vector<Real> targets; ///< x, y, z of sum_lanes targets, and so on
    template<class To>
    Places<To> cast() const;
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
