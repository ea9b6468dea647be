// Sums of point forces: each instruction set against the formula, both precisions, any number of points.

#include "solver/stokes/PointSum.h"

#include "solver/stokes/kernels/StokesletLoops.h"

#include <gtest/gtest.h>

#include <random>

namespace vesicle
{
namespace
{

RowVectors random_rows(int rows, unsigned seed)
{
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  return RowVectors::NullaryExpr(rows, 3, [&] { return normal(random); });
}

Points formula(const RowVectors& sources, const RowVectors& forces, const Points& targets)
{
  Points velocity = Points::Zero(targets.rows(), 3);
  for (Eigen::Index i = 0; i < targets.rows(); ++i)
    for (Eigen::Index q = 0; q < sources.rows(); ++q)
    {
      const Eigen::RowVector3d d = sources.row(q) - targets.row(i), f = forces.row(q);
      velocity.row(i) += f / d.norm() + d.dot(f) / std::pow(d.norm(), 3) * d;
    }
  return velocity;
}

double error(const Points& velocity, const Points& exact)
{
  return (velocity - exact).norm() / exact.norm();
}

TEST(DirectSum, IsTheFormulaInBothPrecisions)
{
  for (const int targets : { 1, 16, 37, 642 })
  {
    const RowVectors sources = random_rows(1500, 1).rowwise() + Eigen::RowVector3d(100, 0, 0),
                     forces = random_rows(1500, 2);
    const Points at = random_rows(targets, 3).rowwise() + Eigen::RowVector3d(100, 0, 0);
    const Points exact = formula(sources, forces, at), start = Points::Constant(targets, 3, 7);
    const DirectSum sum(sources, at);
    Points full = start, single = start;
    sum.add(forces, Precision::full, full);
    sum.add(forces, Precision::single, single);
    EXPECT_LT(error(full - start, exact), 1e-13) << targets;
    EXPECT_LT(error(single - start, exact), single_precision_error) << targets;
  }
}

// From 1e-6 to 1e6 apart: what 1/√ is made of has to be good at every exponent.
template<class Real>
void expect_loops_give_the_formula(
  void (*add)(const PointForces<Real>&, const Real*, Real*), double tolerance)
{
  for (double distance = 1e-6; distance < 1e7; distance *= 7)
  {
    const RowVectors sources = distance * random_rows(33, 4), forces = random_rows(33, 5);
    const Points at = distance * random_rows(sum_lanes, 6);
    const Eigen::Array<Real, Eigen::Dynamic, 3> x = sources.array().cast<Real>(),
                                                f = forces.array().cast<Real>();
    std::vector<Real> targets(3 * sum_lanes), velocities(3 * sum_lanes);
    for (int i = 0; i < sum_lanes; ++i)
      for (int c = 0; c < 3; ++c)
        targets[c * sum_lanes + i] = static_cast<Real>(at(i, c));
    add({ { &x(0, 0), &x(0, 1), &x(0, 2) }, { &f(0, 0), &f(0, 1), &f(0, 2) }, 33 }, targets.data(),
      velocities.data());
    Points velocity(sum_lanes, 3);
    for (int i = 0; i < sum_lanes; ++i)
      for (int c = 0; c < 3; ++c)
        velocity(i, c) = velocities[c * sum_lanes + i];
    EXPECT_LT(error(velocity, formula(sources, forces, at)), tolerance) << distance;
  }
}

TEST(StokesletLoops, OfEachInstructionSetGiveTheFormula)
{
  std::vector<const StokesletLoops*> all{ &portable_loops() };
#ifdef VESICLE_X86_LOOPS
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    all.push_back(&avx2_loops());
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq"))
    all.push_back(&avx512_loops());
#endif
  for (const StokesletLoops* loops : all)
  {
    expect_loops_give_the_formula<double>(loops->add_forces_double, 1e-13);
    expect_loops_give_the_formula<float>(loops->add_forces_float, single_precision_error);
  }
}

}
}
