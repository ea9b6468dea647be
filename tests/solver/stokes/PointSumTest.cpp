// Sums of point forces: each instruction set against the formula, both precisions, any number of points.

#include "solver/stokes/PointSum.h"

#include "tests/solver/stokes/InstructionSets.h"

#include <gtest/gtest.h>

#include <limits>
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
    sum.add(forces, 0, full);
    sum.add(forces, single_precision_error, single);
    EXPECT_LT(error(full - start, exact), 1e-13) << targets;
    EXPECT_LT(error(single - start, exact), single_precision_error) << targets;
  }
}

Points stresslet_formula(
  const RowVectors& sources, const Eigen::MatrixXd& strengths, const Points& targets)
{
  Points velocity = Points::Zero(targets.rows(), 3);
  for (Eigen::Index i = 0; i < targets.rows(); ++i)
    for (Eigen::Index q = 0; q < sources.rows(); ++q)
    {
      const Eigen::RowVector3d d = sources.row(q) - targets.row(i);
      const auto s = strengths.row(q);
      const double along = s[0] * d[0] * d[0] + s[3] * d[1] * d[1] + s[5] * d[2] * d[2] +
        2 * (s[1] * d[0] * d[1] + s[2] * d[0] * d[2] + s[4] * d[1] * d[2]);
      velocity.row(i) += along / std::pow(d.norm(), 5) * d;
    }
  return velocity;
}

// Powers of distances between 1e-6 and 1e6 are outside of single precision's range, and so are strengths. (With
// the groups 300 sizes apart, not 30, the grid's spacing begins to show between neighbours: 2.1e-6.)
TEST(DirectPointSum, SinglePrecisionTakesAnySizes)
{
  const Eigen::MatrixXd strengths = symmetric_products(random_rows(200, 1), random_rows(200, 2));
  for (const double size : { 1e-6, 1., 1e6 })
    for (const double strength : { 1e-60, 1., 1e60 })
    {
      RowVectors sources = size * random_rows(200, 3);
      sources.topRows(100).rowwise() += Eigen::RowVector3d(30 * size, 0, 0);
      const Points targets = size * random_rows(37, 4);
      const Points exact = strength * stresslet_formula(sources, strengths, targets);
      Points velocity = Points::Zero(37, 3);
      DirectPointSum<PointKind::stresslet>(sources, targets)
        .add(strength * strengths, single_precision_error, velocity);
      EXPECT_LT(error(velocity, exact), single_precision_error) << size << " " << strength;
    }
}

TEST(DirectPointSum, ANumberThatIsNoneIsSeenInBothPrecisions)
{
  RowVectors sources = 1e4 * random_rows(20, 1); // far apart, also in whole numbers
  sources(7, 1) = std::numeric_limits<double>::quiet_NaN();
  for (const double allowed : { 0., 1e-3 })
  {
    Points velocity = Points::Zero(20, 3);
    DirectSum(sources, 1e4 * random_rows(20, 3)).add(random_rows(20, 2), allowed, velocity);
    EXPECT_FALSE(velocity.allFinite()) << allowed;
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
