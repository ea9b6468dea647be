#include "solver/stokes/PointSum.h"

#include "solver/ParallelFor.h"
#include "solver/stokes/TargetBlocks.h"

#include <array>

namespace vesicle
{

namespace
{

// Sources that stay in the cache while all of a task's targets see them.
constexpr int chunk = 1024;
constexpr int fewest_tasks = 32;

}

template<class Real>
template<class To>
DirectSum::Places<To> DirectSum::Places<Real>::cast() const
{
  return { sources.template cast<To>(), { targets.begin(), targets.end() } };
}

// Around the targets' mean, where single precision has the most digits.
DirectSum::DirectSum(const RowVectors& sources, const Points& targets)
{
  const Eigen::RowVector3d origin = targets.colwise().mean();
  full_.sources = (sources.rowwise() - origin).array();
  full_.targets = in_blocks<double>(targets.rowwise() - origin);
  single_ = full_.cast<float>();
}

template<class Real>
void DirectSum::add(const Places<Real>& at, const RowVectors& forces, Points& velocity) const
{
  const Eigen::Array<Real, Eigen::Dynamic, 3> f = forces.array().template cast<Real>();
  const int blocks = static_cast<int>(at.targets.size()) / block_size,
            a_task = std::clamp(blocks / fewest_tasks, 1, most_blocks_a_task),
            sources = static_cast<int>(f.rows()), n = static_cast<int>(velocity.rows());
  parallel_for((blocks + a_task - 1) / a_task,
    [&](int task)
    {
      const int first = task * a_task, count = std::min(a_task, blocks - first);
      std::array<Real, most_blocks_a_task * block_size> sum{};
      for (int q = 0; q < sources; q += chunk)
      {
        const auto& x = at.sources;
        const PointForces<Real> forces_of_chunk{ &x(q, 0), &x(q, 1), &x(q, 2), &f(q, 0), &f(q, 1),
          &f(q, 2), std::min(chunk, sources - q) };
        for (int b = 0; b < count; ++b)
          add_point_forces(forces_of_chunk, at.targets.data() + (first + b) * block_size,
            sum.data() + b * block_size);
      }
      for (int i = first * sum_lanes; i < std::min((first + count) * sum_lanes, n); ++i)
        for (int c = 0; c < 3; ++c)
          velocity(i, c) += sum[place_in_blocks(i - first * sum_lanes, c)];
    });
}

void DirectSum::add(const RowVectors& forces, Precision precision, Points& velocity) const
{
  if (precision == Precision::full)
    add(full_, forces, velocity);
  else
    add(single_, forces, velocity);
}

}
