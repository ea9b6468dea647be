// Directions of view and what they have to show.

#include "TestSurfaces.h"

#include "render/View.h"
#include "solver/Errors.h"

#include <gtest/gtest.h>

using namespace vesicle;
using namespace vesicle::test;

namespace
{

void expect_view(const char* name, const Point3& right, const Point3& up)
{
  const View view = View::named(name);
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_NEAR(view.right[i], right[i], 1e-15) << name;
    EXPECT_NEAR(view.up[i], up[i], 1e-15) << name;
  }
}

}

TEST(View, PresetsAreNamedAfterTheirPlane)
{
  const Point3 x{ 1, 0, 0 }, y{ 0, 1, 0 }, z{ 0, 0, 1 };
  for (const char* name : { "auto", "front", "xz" })
  {
    expect_view(name, x, z);
  }
  for (const char* name : { "side", "yz", "x" })
  {
    expect_view(name, y, z);
  }
  for (const char* name : { "top", "xy", "z" })
  {
    expect_view(name, x, y);
  }
  expect_view("y", { -1, 0, 0 }, z);
}

TEST(View, IsoShowsTheAxesAlike)
{
  for (const char* name : { "iso", "isometric" })
  {
    const View view = View::named(name);
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_NEAR(std::hypot(view.right[axis], view.up[axis]), std::sqrt(2. / 3), 1e-14);
    }
  }
}

TEST(View, UnknownNamesAreRefusedWithTheKnownOnes)
{
  const auto message = message_of<InputError>([] { View::named("above"); });
  EXPECT_NE(message.find("front, side, top, iso"), std::string::npos) << message;
}

TEST(Passage, HoldsAllFramesAboutTheirMiddle)
{
  const View view = View::named("front");
  Passage passage;
  passage.include(make_surface(0), view);
  passage.include(make_surface(3), view); // at (3, 0, 6)
  const Framing framing = passage.framing(view);
  EXPECT_NEAR(framing.half_width, 1.5 + 1.5, 0.02);
  EXPECT_NEAR(framing.half_height, 1 + 3, 0.02);
  EXPECT_NEAR((*framing.center)[0], 1.5, 0.02);
  EXPECT_NEAR((*framing.center)[1], 0, 0.02);
  EXPECT_NEAR((*framing.center)[2], 3, 0.02);
}
