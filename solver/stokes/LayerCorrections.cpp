#include "solver/stokes/LayerCorrections.h"

#include "solver/ParallelFor.h"
#include "solver/stokes/kernels/StokesletKernel.h"

#include <array>

namespace vesicle
{

LayerCorrections::LayerCorrections(const LayerRules& rules) : rules_(&rules)
{
  std::size_t size = 0;
  for (const LayerRules::Group& group : rules.groups())
  {
    start_.push_back(size);
    size += group.nodes.size() * stokeslet_components * stokeslet_lanes;
  }
  blocks_.assign(size, 0);
}

void LayerCorrections::add(const Eigen::VectorXd& density, int first, Points& velocity) const
{
  constexpr int grain = 4; // groups
  parallel_for(
    static_cast<int>(start_.size()),
    [&](int number)
    {
      const LayerRules::Group& group = rules_->groups()[number];
      thread_local std::vector<double> own;
      own.resize(3 * group.nodes.size());
      for (std::size_t k = 0; k < group.nodes.size(); ++k)
        for (int c = 0; c < 3; ++c)
          own[3 * k + c] = density[3 * group.nodes[k] + c];
      std::array<double, 3 * stokeslet_lanes> sum;
      multiply_stokeslets(blocks_.data() + start_[number], static_cast<int>(group.nodes.size()),
        own.data(), sum.data());
      for (std::size_t lane = 0; lane < group.target.size(); ++lane)
        for (int c = 0; c < 3; ++c)
          velocity(first + group.target[lane], c) += sum[c * stokeslet_lanes + lane];
    },
    grain);
}

}
