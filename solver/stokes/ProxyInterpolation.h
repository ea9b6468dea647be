#pragma once
// Between a cluster's proxies and what stands for its halves (ClusterTree.h).

#include "solver/stokes/ClusterTree.h"

namespace vesicle
{

template<class Real>
using ThreeColumns = Eigen::Matrix<Real, Eigen::Dynamic, 3>;

template<class Real>
class ProxyInterpolation
{
public:
  ProxyInterpolation() = default;
  /// Between the proxies of `cluster` and points in its box.
  ProxyInterpolation(const Cluster& cluster, const RowVectors& points);

  /// Forces of the points, shared out: proxies += Lᵀ points.
  void up(
    Eigen::Ref<const ThreeColumns<Real>> points, Eigen::Ref<ThreeColumns<Real>> proxies) const;
  /// Velocities at the proxies, interpolated: points += L proxies.
  void down(
    Eigen::Ref<const ThreeColumns<Real>> proxies, Eigen::Ref<ThreeColumns<Real>> points) const;

private:
  using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
  Matrix along_;  ///< side 0: L = along(i, a) · across(i, b)
  Matrix across_; ///< sides 1 and 2
};

extern template class ProxyInterpolation<float>;
extern template class ProxyInterpolation<double>;

}
