// What one core reaches: multiplications with additions in registers, Stokeslets by loops written by
// hand, and the solver's own. Rates are of the core's own time.
#include "tests/benchmarks/InstructionSet.h"
#include "tests/benchmarks/Measuring.h"

#include "solver/stokes/PointSum.h"
#include "solver/stokes/TreeSum.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace vesicle::benchmarks
{
namespace
{

benchmark::Counter rate(double count)
{
  return { count, benchmark::Counter::kIsIterationInvariantRate };
}

template<class Real>
void multiply_add(benchmark::State& state, const HandWritten<Real>& loops)
{
  constexpr long rounds = 10000;
  for (auto _ : state)
    benchmark::DoNotOptimize(loops.multiply_add(rounds));
  state.counters["flop/s"] = rate(static_cast<double>(rounds * loops.flop_a_round));
}

/// Sources that fill a chunk of DirectSum's, and targets that are none of them, in thousandths.
template<class Real>
struct Places
{
  static constexpr int count = 1024;
  std::vector<Coordinate<Real>> x, y, z, targets;
  std::vector<Real> force;

  explicit Places(int number) : x(count), y(count), z(count), targets(3 * number), force(count, 1)
  {
    for (int i = 0; i < count; ++i)
      x[i] = 2000 + i, y[i] = 1000 + 2 * i, z[i] = 3000;
    for (int i = 0; i < number; ++i)
      targets[i] = 5000 + 1000 * i, targets[number + i] = 1000 * i, targets[2 * number + i] = 1000;
  }
  PointForces<Real> forces() const
  {
    return { { x.data(), y.data(), z.data() }, { force.data(), force.data(), force.data() },
      count };
  }
  /// The largest error of velocities, relative.
  double error(const std::vector<double>& velocities) const
  {
    const auto number = static_cast<int>(targets.size()) / 3;
    double largest = 0;
    for (int i = 0; i < number; ++i)
    {
      Vector3 exact = Vector3::Zero(), found;
      for (int q = 0; q < count; ++q)
      {
        const Vector3 d{ double(x[q] - targets[i]), double(y[q] - targets[number + i]),
          double(z[q] - targets[2 * number + i]) };
        const double r = d.norm();
        exact += Vector3::Ones() / r + d.sum() / (r * r * r) * d;
      }
      for (int c = 0; c < 3; ++c)
        found[c] = velocities[c * number + i];
      largest = std::max(largest, (found - exact).norm() / exact.norm());
    }
    return largest;
  }
};

template<class Real>
using Loop = void (*)(const PointForces<Real>&, const Coordinate<Real>*, double*);

template<class Real>
void stokeslets(benchmark::State& state, Loop<Real> loop, int targets)
{
  const Places<Real> places(targets);
  std::vector<double> velocities(3 * targets);
  loop(places.forces(), places.targets.data(), velocities.data());
  if (!(places.error(velocities) <
        (sizeof(Real) == sizeof(double) ? 1e-13 : single_precision_error)))
    state.SkipWithError("the loop is wrong");
  for (auto _ : state)
  {
    loop(places.forces(), places.targets.data(), velocities.data());
    benchmark::DoNotOptimize(velocities.data());
  }
  state.counters["pairs/s"] = rate(static_cast<double>(Places<Real>::count) * targets);
}

/// Points all over a sphere.
Points spiral(int count, double radius)
{
  Points points(count, 3);
  for (int i = 0; i < count; ++i)
  {
    const double z = 1 - (2 * i + 1.) / count, angle = std::numbers::pi * (3 - std::sqrt(5.)) * i,
                 r = std::sqrt(1 - z * z);
    points.row(i) << radius * r * std::cos(angle), radius * r * std::sin(angle), radius * z;
  }
  return points;
}

// As many as 5,120 triangles have.
void direct_sum(benchmark::State& state, double allowed)
{
  const Threads one(1);
  const RowVectors sources = spiral(15360, 1), forces = RowVectors::Ones(sources.rows(), 3);
  const Points targets = spiral(2562, 1.01);
  const DirectSum sum(sources, targets);
  Points velocity = Points::Zero(targets.rows(), 3);
  for (auto _ : state)
    sum.add(forces, allowed, velocity);
  state.counters["pairs/s"] =
    rate(static_cast<double>(sources.rows()) * static_cast<double>(targets.rows()));
}

// Two thirds of the points are sources.
void tree_sum(benchmark::State& state, double tolerance)
{
  const Threads one(1);
  const RowVectors sources = spiral(static_cast<int>(2 * state.range(0) / 3), 1),
                   forces = RowVectors::Ones(sources.rows(), 3);
  const Points targets = spiral(static_cast<int>(state.range(0) / 3), 1.01);
  const TreeSum sum({ sources, targets }, tolerance);
  Points velocity = Points::Zero(targets.rows(), 3);
  for (auto _ : state)
    sum.add(forces, 0, velocity);
}

template<class Real>
void add(const std::string& name, const HandWritten<Real>& by_hand, Loop<Real> ours)
{
  const auto add = [&](const std::string& what, auto... benchmark)
  { benchmark::RegisterBenchmark((what + name).c_str(), benchmark...); };
  add("Peak/", multiply_add<Real>, by_hand);
  add("ByHand/", stokeslets<Real>, by_hand.add_stokeslets, by_hand.targets);
  add("Kernel/", stokeslets<Real>, ours, sum_lanes);
}

[[maybe_unused]] const bool added = []
{
  for (const InstructionSet& set : instruction_sets())
  {
    add<double>(set.name + std::string("/double"), set.in_double,
      set.ours.add_points<double, PointKind::force>());
    add<float>(set.name + std::string("/single"), set.in_single,
      set.ours.add_points<float, PointKind::force>());
  }
  return true;
}();
BENCHMARK_CAPTURE(direct_sum, double, 0)->Name("DirectSum/double")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(direct_sum, single, single_precision_error)
  ->Name("DirectSum/single")
  ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(tree_sum, 1e-4, 1e-4)
  ->Name("TreeSum/1e-4")
  ->RangeMultiplier(4)
  ->Range(16384, 1000000)
  ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(tree_sum, 1e-6, 1e-6)
  ->Name("TreeSum/1e-6")
  ->RangeMultiplier(4)
  ->Range(16384, 1000000)
  ->Unit(benchmark::kMillisecond);

}
}
