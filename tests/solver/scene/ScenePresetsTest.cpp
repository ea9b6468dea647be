#include "solver/scene/SceneFile.h"

#include <gtest/gtest.h>

#include <string>

using namespace vesicle;

namespace
{

Scene scene_with(const std::string& tables)
{
  return parse_scene(
    "time.end = 1\ntime.output_every = 1\nvesicle.shape = \"sphere\"\n" + tables, "s.toml");
}

}

TEST(ScenePresets, DefaultIsBalancedWhichIsLoop)
{
  const auto standard = scene_with("").accuracy;
  EXPECT_EQ(standard.preset, Scene::Preset::balanced);
  EXPECT_EQ(standard.basis, Scene::Basis::loop);
  EXPECT_EQ(standard.bending, Scene::Bending::variational);
  EXPECT_EQ(standard.scheme, Scene::Scheme::robust);
  EXPECT_EQ(standard.quadrature, 3);
}

TEST(ScenePresets, FastIsLinearElements)
{
  const auto fast = scene_with("accuracy.preset = \"fast\"").accuracy;
  EXPECT_EQ(fast.basis, Scene::Basis::linear);
  EXPECT_EQ(fast.bending, Scene::Bending::cotan);
  EXPECT_EQ(fast.scheme, Scene::Scheme::robust);
}

TEST(ScenePresets, BendingFollowsTheBasis)
{
  EXPECT_EQ(scene_with("accuracy.basis = \"linear\"").accuracy.bending, Scene::Bending::cotan);
}

TEST(ScenePresets, Paper)
{
  const auto paper = scene_with("accuracy.preset = \"paper\"").accuracy;
  EXPECT_EQ(paper.scheme, Scene::Scheme::paper);
  EXPECT_EQ(paper.integrator, Scene::Integrator::imex_euler);
  EXPECT_EQ(paper.mesh_motion, Scene::MeshMotion::material);
  EXPECT_EQ(paper.quadrature, 3);
}

TEST(ScenePresets, AccurateTightensTheToleranceUnlessOneIsGiven)
{
  EXPECT_EQ(scene_with("").time.tolerance, 1e-3);
  EXPECT_EQ(scene_with("accuracy.preset = \"accurate\"").time.tolerance, 1e-4);
  EXPECT_EQ(scene_with("accuracy.preset = \"accurate\"").accuracy.quadrature, 6);
  EXPECT_EQ(
    scene_with("accuracy.preset = \"accurate\"\ntime.tolerance = 1e-2").time.tolerance, 1e-2);
}

TEST(ScenePresets, KnobsOverrideThePreset)
{
  const auto accuracy =
    scene_with("accuracy.quadrature = 12\naccuracy.preset = \"paper\"\naccuracy.integrator = "
               "\"imex-midpoint\"")
      .accuracy;
  EXPECT_EQ(accuracy.preset, Scene::Preset::paper);
  EXPECT_EQ(accuracy.quadrature, 12);
  EXPECT_EQ(accuracy.integrator, Scene::Integrator::imex_midpoint);
  EXPECT_EQ(accuracy.mesh_motion, Scene::MeshMotion::material);
}
