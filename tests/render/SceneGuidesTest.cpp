// Arrows for flows and gravity.

#include "render/SceneGuides.h"

#include "solver/flow/Extension.h"
#include "solver/flow/Poiseuille.h"
#include "solver/flow/Rotation.h"
#include "solver/flow/Shear.h"

#include "vtkMath.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace vesicle;

namespace
{

const View front = View::named("front");

std::vector<Point3> arrows_of(const Guide& guide)
{
  std::vector<Point3> arrows;
  for (const auto& a : guide.arrows)
  {
    arrows.push_back({ a.to[0] - a.from[0], a.to[1] - a.from[1], a.to[2] - a.from[2] });
  }
  return arrows;
}

Guide flow_guide(std::shared_ptr<const ImposedFlow> flow)
{
  Scene scene;
  scene.flow = std::move(flow);
  const auto guides = scene_guides(scene, front);
  EXPECT_EQ(guides.size(), 1u);
  EXPECT_EQ(guides.at(0).label, "flow");
  return guides.at(0);
}

}

TEST(SceneGuides, AFluidAtRestHasNone)
{
  EXPECT_TRUE(scene_guides(Scene{}, front).empty());
}

TEST(SceneGuides, ShearIsAProfileAlongZ)
{
  const Guide guide = flow_guide(std::make_shared<Shear>(-3));
  double longest = 0;
  for (const auto& a : guide.arrows)
  {
    EXPECT_EQ(a.from[0], 0);
    EXPECT_EQ(a.to[2], a.from[2]);
    EXPECT_LT((a.to[0] - a.from[0]) * a.from[2], 0); // to the left above, to the right below
    longest = std::max(longest, std::abs(a.to[0]));
  }
  EXPECT_NEAR(longest, 1, 1e-14);
  EXPECT_EQ(guide.lines.size(), 1u);
}

TEST(SceneGuides, PoiseuilleIsFastestOnTheAxis)
{
  const auto flow = std::make_shared<Poiseuille>(2, 5, Vector3::UnitX(), Vector3(1, 2, 3));
  for (const Point3& u : arrows_of(flow_guide(flow)))
  {
    EXPECT_GE(u[0], 0);
    EXPECT_LE(u[0], 1 + 1e-14);
    EXPECT_EQ(u[1], 0);
  }
}

TEST(SceneGuides, ExtensionGoesOutAlongXAndInAlongZ)
{
  const Guide guide = flow_guide(std::make_shared<Extension>(Extension::Type::planar, 1));
  ASSERT_EQ(guide.arrows.size(), 4u);
  for (const auto& a : guide.arrows)
  {
    const double x = 0.5 * (a.from[0] + a.to[0]), z = 0.5 * (a.from[2] + a.to[2]);
    EXPECT_GE((a.to[0] - a.from[0]) * x, 0);
    EXPECT_LE((a.to[2] - a.from[2]) * z, 0);
  }
}

TEST(SceneGuides, RotationGoesRoundItsAxis)
{
  const Guide guide = flow_guide(std::make_shared<Rotation>(2, Vector3::UnitY()));
  ASSERT_EQ(guide.arrows.size(), 4u);
  EXPECT_TRUE(guide.lines.empty());
  for (const auto& a : guide.arrows)
  {
    const double x = 0.5 * (a.from[0] + a.to[0]), z = 0.5 * (a.from[2] + a.to[2]);
    EXPECT_GT((a.to[0] - a.from[0]) * z - (a.to[2] - a.from[2]) * x, 0); // e_y × x
    EXPECT_NEAR((a.to[0] - a.from[0]) * x + (a.to[2] - a.from[2]) * z, 0, 1e-14);
  }
}

TEST(SceneGuides, GravityPointsDown)
{
  Scene scene;
  scene.gravity = Scene::Gravity{};
  scene.gravity->bond_number = 10;
  const auto guides = scene_guides(scene, front);
  ASSERT_EQ(guides.size(), 1u);
  EXPECT_LT(arrows_of(guides[0])[0][2], 0);
}

TEST(SceneGuides, AreLeftOutWhenTheyPointAtTheViewer)
{
  Scene scene;
  scene.gravity = Scene::Gravity{};
  const Guide gravity = scene_guides(scene, front)[0];
  EXPECT_TRUE(guide_marker(gravity, front, 640, 360, {}));
  EXPECT_FALSE(guide_marker(gravity, View::named("top"), 640, 360, {}));
}
