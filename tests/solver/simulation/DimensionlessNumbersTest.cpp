#include "solver/simulation/DimensionlessNumbers.h"

#include "solver/Errors.h"
#include "solver/scene/SceneFile.h"
#include "solver/simulation/Simulation.h"
#include "solver/simulation/StartMesh.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace vesicle
{
namespace
{

// A vesicle of 10 µm in water, 1e-19 J, sheared by 1/s under gravity: t0 = μ r0³/EB = 10 s.
const char* const si_scene = R"(
  [vesicle]
  shape = "prolate"
  reduced_volume = 0.9
  radius = 1e-5
  triangles = 80
  [membrane]
  bending_rigidity = 1e-19
  [fluid]
  viscosity = 1e-3
  [flow]
  kind = "shear"
  rate = 1.0
  [gravity]
  density_difference = 50.0
  acceleration = 9.81
  [time]
  end = 10.0
  output_every = 1.0
)";

Simulation simulation(const std::vector<std::string>& overrides)
{
  const Scene scene = parse_scene(si_scene, "scene.toml", ".", overrides);
  return Simulation(scene, make_start_mesh(scene));
}

std::string refusal(const std::vector<std::string>& overrides)
{
  try
  {
    simulation(overrides);
  }
  catch (const InputError& error)
  {
    return error.what();
  }
  return "";
}

TEST(DimensionlessNumbers, OfASceneInSiUnits)
{
  const Simulation si = simulation({});
  const DimensionlessNumbers& n = si.numbers();
  EXPECT_NEAR(n.radius, 1e-5, 1e-11);
  EXPECT_NEAR(n.time_unit, 10, 1e-4);
  ASSERT_TRUE(n.bond && n.capillary && n.duration);
  EXPECT_NEAR(*n.bond, 50 * 9.81 * 1e-20 / 1e-19, 1e-3); // Δρ g r0⁴/EB
  EXPECT_NEAR(*n.capillary, 10, 1e-3);
  EXPECT_EQ(si.notes().find("units"), std::string::npos) << si.notes();
  EXPECT_EQ(to_text(n), "r0 = 1e-05, time unit μ r0³/EB = 10, Bo = 49.05, Ca = 10");
}

TEST(DimensionlessNumbers, OnlyOfWhatTheSceneHas)
{
  const Scene scene = parse_scene(R"(
    [vesicle]
    shape = "sphere"
    triangles = 80
    [membrane]
    bending_rigidity = 1.0
    [time]
    end = "steady"
    output_every = 1.0
    )",
    "scene.toml");
  const Simulation at_rest(scene, make_start_mesh(scene));
  const DimensionlessNumbers& n = at_rest.numbers();
  EXPECT_FALSE(n.bond || n.capillary || n.duration);
}

TEST(DimensionlessNumbers, MicrometresBesideJoulesAreNoticed)
{
  // r0 = 10 "m": Bo = 4.9e25, Ca = 1e19.
  EXPECT_NE(refusal({ "vesicle.radius=10" }).find("bending is lost"), std::string::npos);
  EXPECT_NE(refusal({ "vesicle.radius=1e120" }).find("another unit of length"), std::string::npos);
  EXPECT_NE(refusal({ "fluid.viscosity=1e300" }).find("can't be computed with"), std::string::npos);
  const std::string notes = simulation({ "flow.rate=1e5" }).notes();
  EXPECT_NE(notes.find("Ca = 1e+06"), std::string::npos) << notes;
  const std::string short_run = simulation({ "time.end=1e-9", "time.output_every=1e-9" }).notes();
  EXPECT_NE(short_run.find("nothing will have moved"), std::string::npos) << short_run;
}

}
}
