// Whole runs against published and independently computed values.
#include "solver/simulation/StartMesh.h"
#include "solver/scene/SceneFile.h"
#include "solver/mesh/VertexNormals.h"
#include "solver/simulation/History.h"
#include "tests/solver/support/TestMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace vesicle
{
namespace
{

History run(const std::string& name, const std::vector<std::string>& overrides = {})
{
  const Scene scene =
    read_scene(std::string(VESICLE_SOURCE_DIR) + "/data/scenes/" + name + ".toml", overrides);
  return run_to_end(std::make_shared<Simulation>(scene, make_start_mesh(scene)));
}

/// Of the last shape's points about its centroid.
Eigen::ArrayXd heights(const History& run)
{
  return run.simulation->points(run.last).col(2).array() - run.end().centroid[2];
}

void expect_constraints_kept(const History& run)
{
  for (const Diagnostics& d : run.rows)
  {
    ASSERT_LT(std::abs(d.area_drift), 1e-5);
    ASSERT_LT(std::abs(d.volume_drift), 1e-5);
  }
}

// What gravity and flow put in is dissipated or stored.
void expect_power_balance(const History& run, double tolerance)
{
  double put_in = 0, dissipated = 0;
  for (std::size_t i = 1; i < run.rows.size(); ++i)
  {
    const Diagnostics &a = run.rows[i - 1], &b = run.rows[i];
    put_in += b.dt * (a.power_in + b.power_in) / 2;
    dissipated += b.dt * (a.dissipation + b.dissipation) / 2;
  }
  const double stored = run.rows.back().bending_energy - run.rows.front().bending_energy;
  EXPECT_NEAR(put_in, dissipated + stored, tolerance * put_in);
}

const std::string fast = "accuracy.preset=fast";

// The axisymmetric steady state by a spectral method, the same to all digits at viscosity ratios 1
// and 5. Heights are about the centroid.
constexpr double pear_speed = 2.29870;
constexpr double pear_energy = 1.11266; // E/8πEB
constexpr double pear_lowest = -1.4182;
constexpr double pear_highest = 1.2019;

TEST(Pear, LinearElements)
{
  const History pear = run("pear", { fast });
  expect_constraints_kept(pear);
  expect_power_balance(pear, 0.01);
  const Diagnostics& end = pear.rows.back();
  EXPECT_NEAR(end.velocity[2], pear_speed, 2e-3 * pear_speed);
  EXPECT_NEAR(
    end.energy_over_8pi, pear_energy, 0.015 * pear_energy); // flat triangles: of order 1/N
  EXPECT_LT(*end.tilt_deg, 0.1);
}

// Output times cut few of the steps that the tolerance asks for: 19 where there is one at the end,
// of which the first ten, short ones lead to t = 0.33; one an interval of 0.1 from there.
TEST(Pear, OutputTimesCostFewSteps)
{
  const auto steps = [&](const std::string& every) {
    return run("pear", { "vesicle.triangles=320", "time.output_every=" + every }).rows.back().step;
  };
  EXPECT_LE(steps("0.1"), 10 + 21 + 4);
  EXPECT_LE(steps("2.4"), 20);
}

TEST(Pear, LoopSurface)
{
  // The balance is off by 1.2e-3 and 1.6e-4 whatever the steps: order 1.4 in N.
  for (const auto& [triangles, imbalance] : { std::pair(320, 2e-3), std::pair(1280, 3e-4) })
  {
    const History pear = run("pear", { "vesicle.triangles=" + std::to_string(triangles) });
    expect_constraints_kept(pear);
    expect_power_balance(pear, imbalance);
    const Diagnostics& end = pear.rows.back();
    EXPECT_NEAR(end.velocity[2], pear_speed, 5e-4 * pear_speed) << triangles;
    EXPECT_NEAR(end.energy_over_8pi, pear_energy, 5e-4 * pear_energy) << triangles;
    // A vertex lies on either pole. The odd part of the shape, which the load makes, is 2% and 0.6%
    // too small, as the mesh's energy is that much too stiff: 2.5e-3 and 9e-4, 1.8e-3 and 5e-4.
    const double height = triangles == 320 ? 3e-3 : 1.2e-3;
    EXPECT_NEAR(heights(pear).minCoeff(), pear_lowest, height) << triangles;
    EXPECT_NEAR(heights(pear).maxCoeff(), pear_highest, height) << triangles;
    EXPECT_LT(*end.tilt_deg, 0.1);
  }
}

// A barely loaded vesicle settles at its rest shape's speed, (2/9) Bo/0.961853 at v = .95.
TEST(Pear, RestShapeSettles)
{
  const double exact = 2. / 9 * 0.5 / 0.961853;
  for (const auto& [preset, tolerance] : { std::pair("fast", 5e-3), std::pair("balanced", 2e-3) })
  {
    const History run = vesicle::run("pear",
      { "vesicle.triangles=320", "gravity.bond_number=0.5", "time.end=3",
        std::string("accuracy.preset=") + preset });
    EXPECT_NEAR(run.rows.back().velocity[2], exact, tolerance * exact) << preset;
  }
}

// The load's absolute height is a gauge.
TEST(Pear, TheSameFarUp)
{
  for (const char* preset : { "accuracy.preset=fast", "accuracy.preset=balanced" })
  {
    const std::vector<std::string> small{ "vesicle.triangles=320", "time.end=1",
      "time.output_every=0.5", preset };
    std::vector<std::string> far = small;
    far.push_back("vesicle.center=[0, 0, 1000]");
    const History here = run("pear", small), there = run("pear", far);
    const auto centred = [](const History& run) -> Points {
      return run.last.vesicles[0].points.rowwise() - run.last.vesicles[0].points.colwise().mean();
    };
    EXPECT_LT((centred(here) - centred(there)).cwiseAbs().maxCoeff(), 1e-6) << preset;
  }
}

// Coarse and strongly loaded: nodal loads with an absolute height blow up here. It ends steady: the
// shape no longer moves against its centroid.
TEST(Pear, CoarseAndStronglyLoadedEndsSteady)
{
  for (const char* preset : { "accuracy.preset=fast", "accuracy.preset=balanced" })
  {
    const History run = vesicle::run("pear",
      { "vesicle.triangles=320", "vesicle.reduced_volume=0.9", "gravity.bond_number=20",
        "time.end=6", "time.output_every=1", preset });
    expect_constraints_kept(run);
    EXPECT_NEAR(run.rows.back().velocity[2], 4.515, 0.03 * 4.515) << preset;
    EXPECT_LT(*run.rows.back().tilt_deg, 1) << preset;
    EXPECT_LT(relative_speeds(run).normal, 1e-2) << preset;
  }
}

void expect_steady_after(const History& run, double time)
{
  const Diagnostics& end = run.rows.back();
  EXPECT_GT(end.min_angle_deg, 25);
  for (const Diagnostics& d : run.rows)
    if (d.time > time)
    {
      ASSERT_NEAR(*d.inclination_deg, *end.inclination_deg, 0.1) << d.time;
    }
}

// Reference: 32.424° ± .003, frequency .44502, tension from 3.82 to 6.38.
TEST(TankTreading, LinearElements)
{
  for (const auto& [triangles, tolerance] : { std::pair(320, 1.5), std::pair(1280, 0.6) })
  {
    const History run =
      vesicle::run("tank-treading", { fast, "vesicle.triangles=" + std::to_string(triangles) });
    expect_constraints_kept(run);
    expect_steady_after(run, 10);
    EXPECT_NEAR(*run.rows.back().inclination_deg, 32.424, tolerance) << triangles;
    EXPECT_NEAR(run.rows.back().tank_treading_frequency, 0.44502, 0.005) << triangles;
  }
}

TEST(TankTreading, LoopSurface)
{
  const History run = vesicle::run("tank-treading", { "vesicle.triangles=320" });
  expect_constraints_kept(run);
  expect_steady_after(run, 10);
  const Diagnostics& end = run.rows.back();
  EXPECT_NEAR(*end.inclination_deg, 32.424, 0.15);
  EXPECT_NEAR(end.tank_treading_frequency, 0.44502, 0.0009);
  EXPECT_NEAR(end.tension_min, 3.82, 0.2);
  EXPECT_NEAR(end.tension_max, 6.38, 0.2);
}

// The nearer a tank-treading vesicle is to a sphere, the more it resists like a rigid one: its
// intrinsic viscosity S_xz/(μ rate V) tends to Einstein's 5/2 with the excess area A/r0² − 4π.
TEST(TankTreading, IntrinsicViscosityTendsToEinsteins)
{
  double viscosity[2], excess[2];
  for (int i = 0; i < 2; ++i)
  {
    const History run = vesicle::run("tank-treading",
      { "vesicle.triangles=320", "vesicle.axis=[1, 0, 0.8]", "time.end=5",
        i == 0 ? "vesicle.reduced_volume=0.98" : "vesicle.reduced_volume=0.99" });
    const Diagnostics& end = run.rows.back();
    viscosity[i] = end.stresslet[2] / end.volume;
    excess[i] = end.area - 4 * M_PI;
  }
  EXPECT_LT(viscosity[0], viscosity[1]);
  const double slope = (viscosity[1] - viscosity[0]) / (excess[1] - excess[0]);
  EXPECT_NEAR(viscosity[1] - slope * excess[1], 2.5, 0.025) << viscosity[0] << ", " << viscosity[1];
}

TEST(InextensibleDrop, ReachesThePapersAngleFromAnyStart)
{
  for (double start : { 0., 45., 90. })
  {
    const double radians = start * M_PI / 180;
    const History run = vesicle::run("inextensible-drop",
      { fast, "vesicle.triangles=320", "time.end=8",
        "vesicle.axis=[" + std::to_string(std::cos(radians)) + ", 0.0, " +
          std::to_string(std::sin(radians)) + "]" });
    EXPECT_NEAR(*run.rows.back().inclination_deg, 33.2, 1.5) << start;
  }
}

void expect_falling_energy(const History& run)
{
  for (std::size_t i = 1; i < run.rows.size(); ++i)
    ASSERT_LT(run.rows[i].bending_energy, (1 + 1e-6) * run.rows[i - 1].bending_energy)
      << run.rows[i].time;
}

// E* = 1.38744 (data/reference/equilibria.csv).
TEST(RelaxProlate, LinearElements)
{
  const History run = vesicle::run("relax-prolate", { fast });
  expect_constraints_kept(run);
  expect_falling_energy(run);
  const Diagnostics& end = run.rows.back();
  EXPECT_NEAR(end.energy_over_8pi, 1.38744, 0.015 * 1.38744);
  EXPECT_NEAR(end.semi_axes[1] / end.semi_axes[2], 1, 0.03) << "axisymmetric";
}

TEST(RelaxProlate, LoopSurface)
{
  for (const auto& [triangles, tolerance] : { std::pair(320, 2e-3), std::pair(1280, 4e-4) })
  {
    const History run = vesicle::run(
      "relax-prolate", { "time.end=4", "vesicle.triangles=" + std::to_string(triangles) });
    expect_constraints_kept(run);
    expect_falling_energy(run);
    EXPECT_NEAR(run.rows.back().energy_over_8pi, 1.38744, tolerance * 1.38744) << triangles;
  }
}

// Spontaneous curvature, equilibria of an independent axisymmetric solution: prolate v = .9 has
// E* = .369899361 at c0 = 1. Measured: 1.6e-3, 2.9e-4 too high at 320 and 1,280 triangles, t = 4.
TEST(RelaxProlate, WithSpontaneousCurvature)
{
  for (const auto& [triangles, tolerance] : { std::pair(320, 3e-3), std::pair(1280, 1e-3) })
  {
    const History run = vesicle::run("relax-prolate",
      { "time.end=4", "time.output_every=4", "vesicle.reduced_volume=0.9",
        "membrane.spontaneous_curvature=1", "vesicle.triangles=" + std::to_string(triangles) });
    expect_constraints_kept(run);
    expect_falling_energy(run);
    EXPECT_NEAR(run.rows.back().energy_over_8pi, 0.369899361, tolerance * 0.369899361) << triangles;
  }
}

// Area-difference elasticity, the same independent solution: prolate v = .9, stiffness 1.4, has
// E* = 1.288087536 where the leaflets prefer m0 = 1.2. Measured: 3.0e-4, 4.5e-5 too high at 320 and
// 1,280 triangles, t = 4.
TEST(RelaxProlate, WithAreaDifference)
{
  for (const auto& [triangles, tolerance] : { std::pair(320, 6e-4), std::pair(1280, 1e-4) })
  {
    const History run = vesicle::run("relax-prolate",
      { "time.end=4", "time.output_every=4", "vesicle.reduced_volume=0.9",
        "membrane.area_difference_stiffness=1.4", "membrane.area_difference=1.2",
        "vesicle.triangles=" + std::to_string(triangles) });
    expect_constraints_kept(run);
    expect_falling_energy(run);
    EXPECT_NEAR(run.rows.back().energy_over_8pi, 1.288087536, tolerance * 1.288087536)
      << triangles << " " << run.rows.back().energy_over_8pi;
  }
}

// Whole runs choose their own steps; what is observed agrees all the same when the vesicle is
// turned, or described in SI units.
TEST(RelaxProlate, TheSameTurnedAndInSiUnits)
{
  for (const char* preset : { "accuracy.preset=fast", "accuracy.preset=balanced" })
  {
    const std::vector<std::string> small{ preset, "vesicle.triangles=320", "time.end=0.5",
      "time.output_every=0.25" };
    std::vector<std::string> turned = small;
    turned.push_back("vesicle.rotation=[1, 2, 3, 50]");
    // r0 = 10 µm, EB = 1e-19 J, μ = 1 mPa s: the time unit μ r0³/EB is 10 s.
    const std::vector<std::string> si{ preset, "vesicle.triangles=320", "vesicle.radius=1e-5",
      "membrane.bending_rigidity=1e-19", "fluid.viscosity=1e-3", "time.end=5",
      "time.output_every=2.5" };
    const History a = run("relax-prolate", small), b = run("relax-prolate", turned),
                  c = run("relax-prolate", si);
    EXPECT_EQ(a.rows.size(), c.rows.size());
    for (const History* other : { &b, &c })
      EXPECT_NEAR(other->rows.back().energy_over_8pi, a.rows.back().energy_over_8pi, 1e-6)
        << preset;
    EXPECT_NEAR(c.rows.back().semi_axes[0], 1e-5 * a.rows.back().semi_axes[0], 1e-11) << preset;
    EXPECT_NEAR(b.rows.back().semi_axes[0], a.rows.back().semi_axes[0], 1e-6) << preset;
  }
}

TEST(RigidSphere, RisesAtTwoNinths)
{
  for (const auto& [preset, tolerance] :
    { std::pair("accuracy.preset=fast", 1e-2), std::pair("accuracy.preset=balanced", 1e-3) })
  {
    const History run = vesicle::run("rigid-sphere", { preset });
    EXPECT_NEAR(run.rows.back().velocity[2], 2. / 9, tolerance * 2. / 9) << preset;
  }
}

// What the projection removes in all falls as dt² (a time error of third order a step).
TEST(Corrections, FallWithTheTimeStep)
{
  double removed[2];
  for (int i = 0; i < 2; ++i)
  {
    const History run = vesicle::run("tank-treading",
      { fast, "vesicle.triangles=320", "time.end=1", "time.output_every=0.5",
        i == 0 ? "time.step=0.025" : "time.step=0.0125" });
    removed[i] = run.rows.back().volume_correction;
  }
  EXPECT_NEAR(std::log2(removed[0] / removed[1]), 2, 0.2) << removed[0] << ", " << removed[1];
}

// The distance between two shapes on one mesh along the normals of the first: where the nodes are
// along the surface is no physics, and on smooth surfaces of first order in the step.
double normal_distance(const Points& a, const Points& b, const Triangles& triangles)
{
  const Points normals = vertex_normals(a, triangles);
  return normals.cwiseProduct(a - b).rowwise().sum().norm();
}

// Second order in time where bending is stiff: three step sizes compared at the same time.
TEST(Integrator, IsOfSecondOrder)
{
  for (const char* preset : { "accuracy.preset=fast", "accuracy.preset=balanced" })
  {
    Points shape[4];
    Triangles triangles;
    for (int i = 0; i < 4; ++i)
    {
      const double dt = 0.02 / (1 << i);
      const History history = vesicle::run("pear",
        { preset, "vesicle.triangles=320", "vesicle.reduced_volume=0.9", "gravity.bond_number=20",
          "time.end=0.4", "time.output_every=0.4", "time.step=" + std::to_string(dt) });
      shape[i] = history.last.vesicles[0].points;
      triangles = history.simulation->start_mesh().triangles;
    }
    const double e0 = normal_distance(shape[0], shape[1], triangles),
                 e1 = normal_distance(shape[1], shape[2], triangles),
                 e2 = normal_distance(shape[2], shape[3], triangles);
    EXPECT_NEAR(std::log2(e0 / e1), 2, 0.3) << preset << ": " << e0 << ", " << e1;
    EXPECT_NEAR(std::log2(e1 / e2), 2, 0.3) << preset << ": " << e1 << ", " << e2;
  }
}

}
}
