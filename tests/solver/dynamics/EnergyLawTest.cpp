// On smooth surfaces the reported energy changes by what the reported powers say, and a relaxation
// never climbs and never crawls.

#include "solver/flow/Shear.h"
#include "solver/simulation/History.h"
#include "solver/simulation/StartMesh.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vesicle
{
namespace
{

using Kind = ShapeRequest::Kind;

struct Rest
{
  const char* name;
  Kind kind;
  double reduced_volume;
  int triangles;
  double balance; ///< bound of |ΔE − work|/work, five times what was measured
};

Scene at_rest(const Rest& rest)
{
  Scene scene;
  scene.vesicle.shape = { rest.kind, rest.triangles, {}, rest.reduced_volume, {}, {} };
  scene.membrane.bending_rigidity = 1;
  return scene;
}

class EnergyLaw : public testing::TestWithParam<Rest>
{
};

// Five steps of 1e-6 at the start, where the force is largest; the work by the trapezoidal rule.
TEST_P(EnergyLaw, BalancesOverShortSteps)
{
  Scene scene = at_rest(GetParam());
  scene.time.step = 1e-6;
  scene.time.end = scene.time.output_every = 5e-6;
  const History run = run_to_end(std::make_shared<Simulation>(scene, make_start_mesh(scene)));
  double work = 0;
  for (std::size_t i = 1; i < run.rows.size(); ++i)
  {
    const Diagnostics &a = run.rows[i - 1], &b = run.rows[i];
    work += (b.time - a.time) * (a.power_in - a.dissipation + b.power_in - b.dissipation) / 2;
  }
  const double change = run.rows.back().bending_energy - run.rows.front().bending_energy;
  EXPECT_LT(work, 0);
  EXPECT_NEAR(change / work, 1, GetParam().balance);
}

INSTANTIATE_TEST_SUITE_P(Shapes, EnergyLaw,
  testing::Values(Rest{ "ProlateOf80", Kind::prolate, 0.9, 80, 2e-5 },
    Rest{ "DiscocyteOf80", Kind::discocyte, 0.8, 80, 3e-5 },
    Rest{ "Prolate", Kind::prolate, 0.6, 320, 1e-3 },
    Rest{ "Oblate", Kind::oblate, 0.6, 320, 2e-4 },
    Rest{ "Discocyte", Kind::discocyte, 0.6, 320, 2.5e-4 }),
  [](const auto& rest) { return rest.param.name; });

// Each crept at steps of 1e-6 to 1e-4 when its force was not the adjoint of its motion.
class Relaxation : public testing::TestWithParam<Rest>
{
};

TEST_P(Relaxation, DescendsInFewSteps)
{
  Scene scene = at_rest(GetParam());
  scene.time.end = scene.time.output_every = 3;
  const History run = run_to_end(std::make_shared<Simulation>(scene, make_start_mesh(scene)));
  EXPECT_LE(run.rows.size(), 121);
  for (std::size_t i = 1; i < run.rows.size(); ++i)
    EXPECT_LE(run.rows[i].bending_energy, (1 + 1e-6) * run.rows[i - 1].bending_energy) << i;
}

INSTANTIATE_TEST_SUITE_P(Shapes, Relaxation,
  testing::Values(Rest{ "Prolate6Of80", Kind::prolate, 0.6, 80, 0 },
    Rest{ "Prolate5Of80", Kind::prolate, 0.5, 80, 0 },
    Rest{ "Oblate5Of80", Kind::oblate, 0.5, 80, 0 },
    Rest{ "Discocyte8Of80", Kind::discocyte, 0.8, 80, 0 },
    Rest{ "Oblate5", Kind::oblate, 0.5, 320, 0 }),
  [](const auto& rest) { return rest.param.name; });

// From small triangles along a sharp rim. A mesh that ran ahead of the normal motion shook them: 24
// steps then, and more.
TEST(RelaxationOfASharpRim, DescendsInFewSteps)
{
  Scene scene = at_rest({ "Oblate", Kind::oblate, 0.6, 1280, 0 });
  scene.time.end = scene.time.output_every = 0.05;
  const History run = run_to_end(std::make_shared<Simulation>(scene, make_start_mesh(scene)));
  ASSERT_GT(run.rows.front().edge_ratio, 3);
  EXPECT_LE(run.rows.size(), 17);
}

// A sphere in shear turns at half the rate, keeps its area and takes long steps.
TEST(TautSphere, TurnsInShear)
{
  Scene scene;
  scene.vesicle.shape = { Kind::sphere, 320, {}, {}, {}, {} };
  scene.membrane.bending_rigidity = 1;
  scene.flow = std::make_shared<Shear>(1);
  scene.time.end = 1;
  scene.time.output_every = 0.5;
  const History run = run_to_end(std::make_shared<Simulation>(scene, make_start_mesh(scene)));
  const Diagnostics& end = run.rows.back();
  EXPECT_NEAR(end.tank_treading_frequency, 0.5, 1e-3);
  EXPECT_LT(std::abs(end.area_drift), 1e-6);
  EXPECT_LE(run.rows.size(), 21);
}

}
}
