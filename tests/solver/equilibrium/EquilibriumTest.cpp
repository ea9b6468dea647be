// Equilibria on meshes against an independent integration of the Euler–Lagrange equations. Bounds are
// twice what was measured, or what is promised.
#include "solver/equilibrium/BranchEquilibrium.h"

#include "solver/Errors.h"
#include "solver/membrane/AreaDifference.h"
#include "solver/membrane/HelfrichBending.h"
#include "solver/mesh/MeshQuality.h"
#include "tests/solver/equilibrium/Reference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vesicle
{
namespace
{

using std::numbers::pi;

struct Shape
{
  EquilibriumBranch branch;
  double reduced_volume;
};

double energy_error(const BranchEquilibrium& found, const Shape& s)
{
  return found.equilibrium.energy / (8 * pi) /
    test::reference_equilibrium(branch_name(s.branch), s.reduced_volume).energy -
    1;
}

constexpr auto prolate = EquilibriumBranch::prolate, oblate = EquilibriumBranch::oblate,
               stomatocyte = EquilibriumBranch::stomatocyte;

TEST(Equilibrium, HasTheReferencesEnergyTo1em4At1280Triangles)
{
  for (const Shape& s : { Shape{ prolate, 0.5 }, { oblate, 0.6 }, { stomatocyte, 0.3 } })
  {
    const BranchEquilibrium found = branch_equilibrium({ s.branch, s.reduced_volume, 1280 });
    SCOPED_TRACE(branch_name(s.branch));
    EXPECT_EQ(found.mesh.triangles.rows(), 1280);
    // The discrete energy is that of a surface that may be: it isn't below.
    EXPECT_GT(energy_error(found, s), 0);
    EXPECT_LT(energy_error(found, s), 1e-4);
    EXPECT_TRUE(found.equilibrium.stable());
    EXPECT_GT(mesh_quality(found.mesh).min_angle_deg, 30);
  }
}

TEST(Equilibrium, BalancesForcesAndKeepsAreaAndVolume)
{
  const BranchEquilibrium found = branch_equilibrium({ prolate, 0.8, 320 });
  const Equilibrium& e = found.equilibrium;
  const auto reference = test::reference_equilibrium("prolate", 0.8);
  EXPECT_NEAR(e.area / (4 * pi * std::pow(0.8, -2. / 3)), 1, 1e-12);
  EXPECT_NEAR(e.volume / (4 * pi / 3), 1, 1e-12);
  EXPECT_LT(e.imbalance, 1e-4);
  EXPECT_NEAR(e.multipliers.tension, reference.tension, 5e-3);
  EXPECT_NEAR(e.multipliers.pressure, reference.pressure, 1e-2);
}

// N^{-3/2} at least, from 1.3e-4 at 320.
TEST(Equilibrium, ConvergesWithTheNumberOfTriangles)
{
  const Shape s{ prolate, 0.8 };
  const double coarse = energy_error(branch_equilibrium({ s.branch, s.reduced_volume, 320 }), s),
               fine = energy_error(branch_equilibrium({ s.branch, s.reduced_volume, 1280 }), s);
  EXPECT_LT(coarse, 2.6e-4);
  EXPECT_LT(fine, coarse / 6);
}

// Oblates lose their stability against two modes with cos 2φ between v = .7 and v = .8, and against
// stomatocytes between .55 and .5.
TEST(Equilibrium, KnowsWhichOblatesAreStable)
{
  const auto lowest = [](double v) -> Eigen::VectorXd {
    return branch_equilibrium({ oblate, v, 320 }).equilibrium.modes.eigenvalues;
  };
  EXPECT_GT(lowest(0.7)[0], 1);
  const Eigen::VectorXd round = lowest(0.8);
  EXPECT_NEAR(round[0], -1.867, 0.3); // at 5,120 triangles
  EXPECT_NEAR(round[0], round[1], 1e-3);
  EXPECT_GT(round[2], 10);
  const Eigen::VectorXd flat =
    branch_equilibrium({ oblate, 0.5, 1280 }).equilibrium.modes.eigenvalues;
  EXPECT_LT(flat[0], -0.5);
  EXPECT_GT(flat[1], 5);
}

TEST(Equilibrium, FollowsTheUnstableDirectionToTheProlate)
{
  const BranchEquilibrium found = branch_equilibrium({ oblate, 0.8, 320, true });
  EXPECT_TRUE(found.equilibrium.stable());
  EXPECT_NEAR(energy_error(found, { prolate, 0.8 }), 0, 2e-3);
}

TEST(Equilibrium, WatchesEveryStep)
{
  int steps = 0;
  const BranchEquilibrium found = branch_equilibrium({ prolate, 0.9, 320 },
    [&](const EquilibriumProgress& progress)
    {
      EXPECT_EQ(progress.step, steps++);
      EXPECT_GT(progress.energy, 8 * pi);
    });
  EXPECT_EQ(steps, found.equilibrium.steps);
}

// With area-difference elasticity the energy's part beyond bending is 8π² α (m − m0)²; for α large m
// is what it prefers.
TEST(Equilibrium, TakesOtherTermsAlong)
{
  const BranchEquilibrium start = branch_equilibrium({ prolate, 0.9, 320 });
  const SurfaceSpace space(
    SurfaceBasis::loop, start.mesh.triangles, static_cast<int>(start.mesh.points.rows()));
  const double m0 = 1.1;
  MembraneTerms terms;
  terms.push_back(make_bending(space, 0));
  terms.push_back(std::make_unique<AreaDifference>(100, m0));
  const EnergyProblem problem{ space, terms, start.equilibrium.area, start.equilibrium.volume };
  const Equilibrium found = equilibrium_below(problem, start.mesh.points);
  const Surface surface(space, found.vertices);
  EXPECT_NEAR(integrated_mean_curvature(surface) / std::sqrt(4 * pi * surface.area), m0, 0.02);
  EXPECT_GT(found.energy, start.equilibrium.energy);
  EXPECT_LT(found.imbalance, 5e-3);
}

}
}
