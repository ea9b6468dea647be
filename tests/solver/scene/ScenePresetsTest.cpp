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

TEST(ScenePresets, DefaultIsBalancedWhichIsFastForNow)
{
  const auto standard = scene_with("").accuracy;
  const auto fast = Scene::preset(Scene::Preset::fast);
  EXPECT_EQ(standard.preset, Scene::Preset::balanced);
  EXPECT_EQ(standard.scheme, fast.scheme);
  EXPECT_EQ(standard.integrator, fast.integrator);
  EXPECT_EQ(standard.mesh_motion, fast.mesh_motion);
  EXPECT_EQ(standard.quadrature, fast.quadrature);
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
               "\"imex-midpoint\"\naccuracy.operator = \"dense\"\naccuracy.precision = \"single\"")
      .accuracy;
  EXPECT_EQ(accuracy.preset, Scene::Preset::paper);
  EXPECT_EQ(accuracy.quadrature, 12);
  EXPECT_EQ(accuracy.integrator, Scene::Integrator::imex_midpoint);
  EXPECT_EQ(accuracy.mesh_motion, Scene::MeshMotion::material);
  EXPECT_EQ(accuracy.stokes_operator, Scene::Operator::dense);
  EXPECT_EQ(accuracy.precision, Scene::Precision::single_precision);
}
