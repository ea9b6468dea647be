#include "solver/stokes/LayerMatrix.h"

#include "solver/ParallelFor.h"

#include <array>

namespace vesicle
{

void LayerMatrix::resize(int groups, int nodes, int vertices)
{
  blocks_.resize(groups * nodes * node_stride);
  targets_.resize(groups * lanes);
  nodes_ = nodes;
  vertices_ = vertices;
}

double* LayerMatrix::group(int number)
{
  return blocks_.data() + number * nodes_ * node_stride;
}

int* LayerMatrix::targets(int number)
{
  return targets_.data() + number * lanes;
}

Eigen::VectorXd LayerMatrix::operator*(const Eigen::VectorXd& density) const
{
  Eigen::VectorXd velocity(3 * vertices_);
  const int groups = static_cast<int>(targets_.size() / lanes);
  parallel_for(
    groups,
    [&](int number)
    {
      std::array<double, 3 * lanes> sum;
      multiply_stokeslets(
        blocks_.data() + number * nodes_ * node_stride, nodes_, density.data(), sum.data());
      for (std::size_t lane = 0; lane < lanes; ++lane)
        if (const int target = targets_[number * lanes + lane]; target >= 0)
          for (int c = 0; c < 3; ++c)
            velocity[3 * target + c] = sum[c * lanes + lane];
    },
    8);
  return velocity;
}

}
