// Sums of point forces: each instruction set against the formula, both precisions, any number of points.

#include "solver/stokes/PointSum.h"

#include "tests/solver/stokes/InstructionSets.h"

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
void expect_loops_give_the_formula(const StokesletLoops& loops, double tolerance)
{
  for (double distance = 1e-6; distance < 1e7; distance *= 7)
  {
    const RowVectors sources = distance * random_rows(33, 4), forces = random_rows(33, 5);
    const Points at = distance * random_rows(sum_lanes, 6);
    EXPECT_LT(error(test::velocities_by<Real, PointKind::force>(loops, sources, forces, at),
                formula(sources, forces, at)),
      tolerance)
      << distance;
  }
}

TEST(StokesletLoops, OfEachInstructionSetGiveTheFormula)
{
  for (const StokesletLoops* loops : test::all_loops())
  {
    expect_loops_give_the_formula<double>(*loops, 1e-13);
    expect_loops_give_the_formula<float>(*loops, single_precision_error);
  }
}

}
}
