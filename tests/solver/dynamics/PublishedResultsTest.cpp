// Whole runs against published and independently computed values.
#include "solver/dynamics/Simulation.h"
#include "solver/scene/SceneFile.h"
#include "tests/solver/support/TestMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace vesicle
{
namespace
{

struct History
{
  std::vector<Diagnostics> rows;
  State last;
};

History run(const std::string& name, const std::vector<std::string>& overrides = {})
{
  const Scene scene =
    read_scene(std::string(VESICLE_SOURCE_DIR) + "/data/scenes/" + name + ".toml", overrides);
  const Simulation simulation(scene, make_start_mesh(scene));
  History run{ {}, simulation.start() };
  run.rows.push_back(simulation.diagnose(run.last));
  while (!simulation.finished(run.last))
  {
    run.last = simulation.step(run.last);
    run.rows.push_back(simulation.diagnose(run.last));
  }
  return run;
}

void expect_constraints_kept(const History& run)
{
  for (const Diagnostics& d : run.rows)
  {
    ASSERT_LT(std::abs(d.area_drift), 1e-5);
    ASSERT_LT(std::abs(d.volume_drift), 1e-5);
  }
}

TEST(Pear, SpeedEnergyAndPowerBalance)
{
  const History pear = run("pear");
  expect_constraints_kept(pear);
  const Diagnostics& end = pear.rows.back();
  EXPECT_NEAR(end.velocity[2], 2.285, 0.02 * 2.285);
  EXPECT_NEAR(end.energy_over_8pi, 1.114, 0.02 * 1.114);
  EXPECT_LT(*end.tilt_deg, 0.1);

  double put_in = 0, dissipated = 0;
  for (std::size_t i = 1; i < pear.rows.size(); ++i)
  {
    const Diagnostics &a = pear.rows[i - 1], &b = pear.rows[i];
    put_in += b.dt * (a.power_in + b.power_in) / 2;
    dissipated += b.dt * (a.dissipation + b.dissipation) / 2;
  }
  const double stored = end.bending_energy - pear.rows.front().bending_energy;
  EXPECT_NEAR(put_in, dissipated + stored, 0.01 * put_in);
}

// The load's absolute height is a gauge.
TEST(Pear, TheSameFarUp)
{
  const std::vector<std::string> small{ "vesicle.triangles=320", "time.end=1",
    "time.output_every=0.5" };
  std::vector<std::string> far = small;
  far.push_back("vesicle.center=[0, 0, 1000]");
  const History here = run("pear", small), there = run("pear", far);
  const auto centred = [](const History& run) -> Points
  { return run.last.points.rowwise() - run.last.points.colwise().mean(); };
  EXPECT_LT((centred(here) - centred(there)).cwiseAbs().maxCoeff(), 1e-6);
}

// Coarse and strongly loaded: nodal loads with an absolute height blow up here.
TEST(Pear, CoarseAndStronglyLoadedEndsSteady)
{
  const History run = vesicle::run("pear",
    { "vesicle.triangles=320", "vesicle.reduced_volume=0.9", "gravity.bond_number=20", "time.end=6",
      "time.output_every=1" });
  expect_constraints_kept(run);
  const Eigen::RowVector3d U(
    run.rows.back().velocity[0], run.rows.back().velocity[1], run.rows.back().velocity[2]);
  EXPECT_NEAR(U.z(), 4.515, 0.03 * 4.515); // 1,280 triangles
}

TEST(TankTreading, InclinationSteadyOverTwentyShearTimes)
{
  const double reference = 32.424;
  for (const auto& [triangles, tolerance] : { std::pair(320, 1.5), std::pair(1280, 0.6) })
  {
    const History run =
      vesicle::run("tank-treading", { "vesicle.triangles=" + std::to_string(triangles) });
    expect_constraints_kept(run);
    const Diagnostics& end = run.rows.back();
    EXPECT_NEAR(*end.inclination_deg, reference, tolerance) << triangles;
    EXPECT_NEAR(end.tank_treading_frequency, 0.44502, 0.005) << triangles;
    EXPECT_GT(end.min_angle_deg, 25) << triangles;
    for (const Diagnostics& d : run.rows)
      if (d.time > 10)
      {
        ASSERT_NEAR(*d.inclination_deg, *end.inclination_deg, 0.1) << d.time;
      }
  }
}

TEST(InextensibleDrop, ReachesThePapersAngleFromAnyStart)
{
  for (double start : { 0., 45., 90. })
  {
    const double radians = start * M_PI / 180;
    const History run = vesicle::run("inextensible-drop",
      { "vesicle.triangles=320", "time.end=8",
        "vesicle.axis=[" + std::to_string(std::cos(radians)) + ", 0.0, " +
          std::to_string(std::sin(radians)) + "]" });
    EXPECT_NEAR(*run.rows.back().inclination_deg, 33.2, 1.5) << start;
  }
}

TEST(RelaxProlate, EnergyOnlyFalls)
{
  const History run = vesicle::run("relax-prolate");
  expect_constraints_kept(run);
  for (std::size_t i = 1; i < run.rows.size(); ++i)
    ASSERT_LT(run.rows[i].bending_energy, (1 + 1e-6) * run.rows[i - 1].bending_energy)
      << run.rows[i].time;
  const Diagnostics& end = run.rows.back();
  EXPECT_NEAR(end.energy_over_8pi, 1.38744, 0.015 * 1.38744);
  EXPECT_NEAR(end.semi_axes[1] / end.semi_axes[2], 1, 0.03) << "axisymmetric";
}

TEST(RigidSphere, RisesAtTwoNinths)
{
  const History run = vesicle::run("rigid-sphere");
  const Diagnostics& end = run.rows.back();
  const double bond = 1;
  EXPECT_NEAR(end.velocity[2], 2. / 9 * bond, 0.01 * 2. / 9 * bond);
}

// What the projection removes in all falls as dt² (a time error of third order a step).
TEST(Corrections, FallWithTheTimeStep)
{
  double removed[2];
  for (int i = 0; i < 2; ++i)
  {
    const History run = vesicle::run("tank-treading",
      { "vesicle.triangles=320", "time.end=1", "time.output_every=0.5",
        i == 0 ? "time.step=0.025" : "time.step=0.0125" });
    removed[i] = run.rows.back().volume_correction;
  }
  EXPECT_NEAR(std::log2(removed[0] / removed[1]), 2, 0.2) << removed[0] << ", " << removed[1];
}

// Second order in time where bending is stiff: the tail of the run, three step sizes. (The first
// steps, in which modes on the scale of the mesh die out, are slower than second order.)
TEST(Integrator, IsOfSecondOrder)
{
  Points shape[4];
  for (int i = 0; i < 4; ++i)
  {
    const double dt = 0.02 / (1 << i);
    shape[i] = vesicle::run("pear",
      { "vesicle.triangles=320", "vesicle.reduced_volume=0.9", "gravity.bond_number=20",
        "time.end=0.4", "time.output_every=0.4", "time.step=" + std::to_string(dt) })
                 .last.points;
  }
  const double e0 = (shape[0] - shape[1]).norm(), e1 = (shape[1] - shape[2]).norm(),
               e2 = (shape[2] - shape[3]).norm();
  EXPECT_NEAR(std::log2(e0 / e1), 2, 0.3) << e0 << ", " << e1;
  EXPECT_NEAR(std::log2(e1 / e2), 2, 0.3) << e1 << ", " << e2;
}

}
}
