#include "solver/stokes/ProxyInterpolation.h"

namespace vesicle
{

template<class Real>
ProxyInterpolation<Real>::ProxyInterpolation(const Cluster& cluster, const RowVectors& points)
  : along_(cluster.weights(0, points).template cast<Real>()),
    across_(points.rows(), cluster.grid[1] * cluster.grid[2])
{
  const Eigen::MatrixXd second = cluster.weights(1, points), third = cluster.weights(2, points);
  for (Eigen::Index k = 0; k < across_.cols(); ++k)
    across_.col(k) = second.col(k % second.cols())
                       .cwiseProduct(third.col(k / second.cols()))
                       .template cast<Real>();
}

template<class Real>
void ProxyInterpolation<Real>::up(
  Eigen::Ref<const ThreeColumns<Real>> points, Eigen::Ref<ThreeColumns<Real>> proxies) const
{
  for (int component = 0; component < 3; ++component)
    proxies.col(component).reshaped(along_.cols(), across_.cols()).noalias() +=
      along_.transpose() * (points.col(component).asDiagonal() * across_);
}

template<class Real>
void ProxyInterpolation<Real>::down(
  Eigen::Ref<const ThreeColumns<Real>> proxies, Eigen::Ref<ThreeColumns<Real>> points) const
{
  for (int component = 0; component < 3; ++component)
  {
    const Matrix spread = along_ * proxies.col(component).reshaped(along_.cols(), across_.cols());
    points.col(component) += spread.cwiseProduct(across_).rowwise().sum();
  }
}

template class ProxyInterpolation<float>;
template class ProxyInterpolation<double>;

}
