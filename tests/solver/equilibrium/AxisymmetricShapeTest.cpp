// Against an independent integration of the Euler–Lagrange equations, data/reference/equilibria.csv.
#include "solver/equilibrium/AxisymmetricShape.h"

#include "solver/Errors.h"
#include "tests/solver/equilibrium/Reference.h"

#include <gtest/gtest.h>

#include <numbers>

namespace vesicle
{
namespace
{

using std::numbers::pi;

TEST(AxisymmetricShape, HasTheEnergyTensionAndPressureOfTheReference)
{
  const auto rows = test::reference_equilibria();
  ASSERT_EQ(rows.size(), 28U);
  for (const test::ReferenceEquilibrium& row : rows)
  {
    const AxisymmetricShape shape =
      axisymmetric_equilibrium(equilibrium_branch(row.branch), row.reduced_volume);
    SCOPED_TRACE(row.branch + " " + std::to_string(row.reduced_volume));
    EXPECT_NEAR(shape.energy / (8 * pi), row.energy, 2e-7);
    EXPECT_NEAR(shape.multipliers.tension, row.tension, 1e-5);
    EXPECT_NEAR(shape.multipliers.pressure, row.pressure, 3e-5);
    const Meridian::Measures m = shape.meridian.measures();
    EXPECT_NEAR(6 * std::sqrt(pi) * m.volume * std::pow(m.area, -1.5), row.reduced_volume, 1e-9);
  }
}

TEST(AxisymmetricShape, IsThereUpToTheSphere)
{
  for (const double left : { 1e-2, 1e-4, 1e-6 })
    for (const auto branch : { EquilibriumBranch::prolate, EquilibriumBranch::oblate })
    {
      const double energy = axisymmetric_equilibrium(branch, 1 - left).energy / (8 * pi);
      // 1 + 2 (1 − v) to first order, of either branch.
      EXPECT_NEAR((energy - 1) / left, 2, 6 * std::sqrt(left)) << left;
    }
}

TEST(AxisymmetricShape, RefusesWhatABranchHasNot)
{
  EXPECT_THROW(axisymmetric_equilibrium(EquilibriumBranch::stomatocyte, 0.7), InputError);
  EXPECT_THROW(axisymmetric_equilibrium(EquilibriumBranch::prolate, 1), InputError);
  EXPECT_THROW(axisymmetric_equilibrium(EquilibriumBranch::prolate, -0.1), InputError);
  EXPECT_THROW(equilibrium_branch("torus"), InputError);
}

}
}
