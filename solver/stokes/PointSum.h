#pragma once
// Velocities that forces or stresslets at points make at other points: the part of the layers that
// knows nothing of surfaces.

#include "solver/mesh/TriangleMesh.h"
#include "solver/surface/SurfaceIntegrals.h"

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

/// What acts at a source, by its number of components: a force f, whose velocity is G f, or a
/// symmetric tensor s (xx, xy, xz, yy, yz, zz), whose velocity is X (X·s X)/r⁵.
enum class PointKind
{
  force = 3,
  stresslet = 6
};

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

}
