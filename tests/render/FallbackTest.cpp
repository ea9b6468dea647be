// What happens where OSMesa is not to be had. Each case stands for a machine: the choice of the
// back end is made once a process, and the failing one comes first.

#include "TestSurfaces.h"

#include "render/Offscreen/EGLContext.h"
#include "render/RenderBackend.h"

#include <gtest/gtest.h>

using namespace vesicle;
using namespace vesicle::test;

TEST(RenderFallback, NothingToDrawWithIsAClearError)
{
  setenv("VESICLE_RENDER_BACKEND", "x", 1);
  const auto message = message_of<NothingToDrawWith>([] { render_backend(); });
  EXPECT_NE(message.find("libosmesa6"), std::string::npos) << message;
  EXPECT_NE(message.find("DISPLAY"), std::string::npos) << message;
}

TEST(RenderFallback, EglDrawsWithoutASurface)
{
  std::string why_not;
  if (!make_egl_context(why_not))
  {
    GTEST_SKIP() << why_not;
  }
  setenv("VESICLE_RENDER_BACKEND", "egl", 1);
  EXPECT_EQ(render_backend().name, "EGL");
  EXPECT_EQ(render_backend().window_class, "vtkVesicleEGLRenderWindow");
  PictureSettings settings;
  settings.size = { 320, 180 };
  Picture one(settings);
  Picture two(settings);
  one.draw(make_surface());
  two.draw(make_surface());
  EXPECT_EQ(difference(one.image(), two.image()), 0);
  EXPECT_GT(colors_of(one.image()).size(), 100u);
}
