// The shipped scene of a red cell, on a coarse mesh, through the beginning of its first turn.

#include "solver/scene/SceneFile.h"
#include "solver/simulation/History.h"
#include "solver/simulation/StartMesh.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

namespace vesicle
{
namespace
{

History run_to_10_ms(double tolerance)
{
  const Scene scene = read_scene(
    std::filesystem::path(VESICLE_SOURCE_DIR) / "data/scenes/red-cell.toml",
    { "vesicle.triangles=320", "time.end=\"10 ms\"", fmt::format("time.tolerance={}", tolerance) });
  return run_to_end(std::make_shared<Simulation>(scene, make_start_meshes(scene)));
}

/// What flow and dissipation leave of the energy gained, over it.
double unpaid(const History& run)
{
  double paid = 0;
  for (std::size_t i = 1; i < run.rows.size(); ++i)
  {
    const Diagnostics &before = run.rows[i - 1], &after = run.rows[i];
    paid +=
      after.dt / 2 * (before.power_in - before.dissipation + after.power_in - after.dissipation);
  }
  return paid / (run.end().bending_energy - run.rows.front().bending_energy) - 1;
}

TEST(RedCell, KeepsAreaAndVolume)
{
  const History run = run_to_10_ms(1e-3);
  EXPECT_LT(largest_drift(run), 1e-9);
  EXPECT_GT(run.end().min_angle_deg, 35);
  for (const Diagnostics& row : run.rows)
  {
    ASSERT_TRUE(row.split);
    EXPECT_GT(row.split->inside, 0);
    EXPECT_GT(row.split->outside, 0);
    EXPECT_EQ(row.split->membrane, 0);
  }
}

// What is reported has forces that are implicit over the next step: its power is right to first order in
// the steps, which a fourth of the tolerance halves.
TEST(RedCell, PaysForItsEnergy)
{
  const double coarse = unpaid(run_to_10_ms(1e-3)), fine = unpaid(run_to_10_ms(2.5e-4));
  EXPECT_LT(std::abs(coarse), 0.1);
  EXPECT_LT(std::abs(fine), 0.7 * std::abs(coarse));
}

}
}
