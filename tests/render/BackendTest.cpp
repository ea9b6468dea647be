// The off-screen window: OSMesa without an X server.

#include "TestSurfaces.h"

#include "render/RenderBackend.h"

#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <csignal>
#include <fstream>
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/wait.h>
#include <thread>
#include <vector>

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

/// Starts a process that leaves a window in this way (leave_window.cxx).
pid_t start_leaving(const std::string& how)
{
  const std::string program = VESICLE_LEAVE_WINDOW;
  char* arguments[] = { const_cast<char*>(program.c_str()), const_cast<char*>(how.c_str()),
    nullptr };
  pid_t process = -1;
  posix_spawn(&process, program.c_str(), nullptr, nullptr, arguments, environ);
  return process;
}

std::string end_of(pid_t process)
{
  int status = 0;
  if (process < 0 || waitpid(process, &status, 0) != process)
  {
    return "not started";
  }
  if (WIFSIGNALED(status))
  {
    return WTERMSIG(status) == SIGALRM ? "hung" : "crashed";
  }
  return WEXITSTATUS(status) == 0 ? "ended" : "failed";
}

/// `count` processes, some at a time, all of which should end.
void expect_ends(const std::string& how, int count)
{
  constexpr int at_a_time = 4;
  for (int i = 0; i < count && !testing::Test::HasFailure(); i += at_a_time)
  {
    std::vector<pid_t> processes;
    for (int k = 0; k < std::min(at_a_time, count - i); ++k)
    {
      processes.push_back(start_leaving(how));
    }
    for (const pid_t process : processes)
    {
      EXPECT_EQ(end_of(process), "ended") << "among processes " << i << " to " << i + at_a_time;
    }
  }
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

// libOSMesa joins its threads at exit, and some wait for ever if something is still being drawn.
TEST(RenderBackend, AWindowLeakedAtExitDoesNotCrash)
{
  expect_ends("leaked", 100);
}

class WindowAtExit : public testing::TestWithParam<const char*>
{
};

TEST_P(WindowAtExit, LetsTheProcessEnd)
{
  expect_ends(GetParam(), 12);
}

INSTANTIATE_TEST_SUITE_P(RenderBackend, WindowAtExit,
  testing::Values(
    "leaked-twice", "static", "early-static", "released", "ended-thread", "living-thread"),
  [](const auto& info)
  {
    std::string name = info.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
  });
