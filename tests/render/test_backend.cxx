// The off-screen window: OSMesa without an X server.

#include "TestSurfaces.h"

#include "render/RenderBackend.h"

#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"

#include <fstream>
#include <gtest/gtest.h>
#include <thread>

using namespace vesicle;
using namespace vesicle::test;

namespace
{

bool is_mapped(const std::string& library)
{
  std::ifstream maps("/proc/self/maps");
  for (std::string line; std::getline(maps, line);)
  {
    if (line.find(library) != std::string::npos)
    {
      return true;
    }
  }
  return false;
}

vtkSmartPointer<vtkImageData> draw_at(int width, int height, const std::string& color)
{
  PictureSettings settings;
  settings.size = { width, height };
  settings.color = color;
  Picture picture(settings);
  picture.draw(make_surface());
  return picture.image();
}

}

TEST(RenderBackend, IsOSMesaWithoutAnXServer)
{
  ASSERT_EQ(std::getenv("DISPLAY"), nullptr);
  const RenderBackend& backend = render_backend();
  EXPECT_EQ(backend.name, "OSMesa");
  EXPECT_EQ(backend.window_class, "vtkVesicleOSMesaRenderWindow");
  EXPECT_NE(backend.gl_renderer.find("llvmpipe"), std::string::npos) << backend.gl_renderer;
  EXPECT_TRUE(is_mapped("libOSMesa"));
}

TEST(RenderBackend, OverridesVtksOwnWindowAndInteractor)
{
  render_backend();
  vtkNew<vtkRenderWindow> window;
  EXPECT_STREQ(window->GetClassName(), "vtkVesicleOSMesaRenderWindow");
  vtkNew<vtkRenderWindowInteractor> interactor;
  EXPECT_STREQ(interactor->GetClassName(), "vtkGenericRenderWindowInteractor");
}

TEST(RenderBackend, WindowsInSequenceAreAlike)
{
  const auto first = draw_at(320, 180, "Mean_Curvature");
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_EQ(difference(first, draw_at(320, 180, "Mean_Curvature")), 0);
  }
}

TEST(RenderBackend, TwoWindowsAtOnceDoNotDisturbEachOther)
{
  PictureSettings settings;
  settings.size = { 320, 180 };
  Picture one(settings);
  settings.color = "Tension";
  settings.size = { 200, 240 };
  Picture two(settings);
  for (int i = 0; i < 3; ++i)
  {
    one.draw(make_surface());
    two.draw(make_surface());
  }
  EXPECT_EQ(difference(one.image(), draw_at(320, 180, "Mean_Curvature")), 0);
  EXPECT_EQ(difference(two.image(), draw_at(200, 240, "Tension")), 0);
}

TEST(RenderBackend, ResizesThereAndBack)
{
  PictureSettings settings;
  settings.size = { 320, 180 };
  Picture picture(settings);
  picture.draw(make_surface());
  const auto before = picture.image();
  picture.window()->SetSize(500, 300);
  picture.draw(make_surface());
  EXPECT_EQ(size_of(picture.image()), (std::array{ 500, 300 }));
  picture.window()->SetSize(320, 180);
  picture.draw(make_surface());
  EXPECT_EQ(difference(before, picture.image()), 0);
}

TEST(RenderBackend, DrawsOnAnotherThread)
{
  const auto here = draw_at(320, 180, "Mean_Curvature");
  vtkSmartPointer<vtkImageData> there;
  std::thread([&] { there = draw_at(320, 180, "Mean_Curvature"); }).join();
  EXPECT_EQ(difference(here, there), 0);
}

TEST(RenderBackend, AWindowMayMoveBetweenThreads)
{
  PictureSettings settings;
  settings.size = { 320, 180 };
  Picture picture(settings);
  std::thread([&] { picture.draw(make_surface()); }).join();
  const auto before = picture.image();
  picture.draw(make_surface());
  EXPECT_EQ(difference(before, picture.image()), 0);
}

TEST(RenderBackend, CanBeFinalizedAndUsedAgain)
{
  PictureSettings settings;
  settings.size = { 320, 180 };
  Picture picture(settings);
  picture.draw(make_surface());
  const auto before = picture.image();
  picture.window()->Finalize();
  picture.draw(make_surface());
  EXPECT_EQ(difference(before, picture.image()), 0);
}

TEST(RenderBackend, AWindowLeakedAtExitDoesNotCrash)
{
  const auto leak_and_exit = []
  {
    static auto* picture = new Picture(PictureSettings{}); // static: known to leak checkers
    picture->draw(make_surface());
    std::exit(0);
  };
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(leak_and_exit(), testing::ExitedWithCode(0), "");
}
