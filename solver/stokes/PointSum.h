#pragma once
// Velocities that forces at points make at other points, Σ G f: the part of the single layer that
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

/// Where the points are is set once. The place of a tree, an FMM or another device.
class PointSum
{
public:
  virtual ~PointSum() = default;
  /// velocity += Σ G f at every target, N by 3; `forces`: #sources by 3, with 1/8πμ in them.
  virtual void add(const RowVectors& forces, Precision precision, Points& velocity) const = 0;
};

/// Pair by pair. No target may be a source. Threads share the targets; results do not depend on their
/// number.
class DirectSum final : public PointSum
{
public:
  DirectSum(const RowVectors& sources, const Points& targets);
  void add(const RowVectors& forces, Precision precision, Points& velocity) const override;

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
  void add(const Places<Real>& at, const RowVectors& forces, Points& velocity) const;

  Places<double> full_;
  Places<float> single_;
};

}
