#include "render/RenderBackend.h"

#include "render/Offscreen/OffscreenWindows.h"

#include "vtkNew.h"
#include "vtkRenderWindow.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <sstream>

namespace vesicle
{
namespace
{

/// The line "OpenGL renderer string:  …" of VTK's report.
std::string gl_renderer(vtkRenderWindow* window)
{
  const char* report = window->ReportCapabilities();
  std::istringstream lines(report ? report : "");
  const std::string key = "OpenGL renderer string:";
  for (std::string line; std::getline(lines, line);)
  {
    if (line.compare(0, key.size(), key) == 0)
    {
      const auto value = line.find_first_not_of(' ', key.size());
      return value == std::string::npos ? "" : line.substr(value);
    }
  }
  return "unknown";
}

RenderBackend choose()
{
  const OffscreenWindows& windows = use_offscreen_windows();
  if (windows.name.empty())
  {
    throw NothingToDrawWith("nothing to draw pictures with: " + windows.failures +
      "; install the Debian package libosmesa6");
  }
  if (!windows.failures.empty())
  {
    spdlog::warn(windows.failures + "using " + windows.name + " instead");
  }
  vtkNew<vtkRenderWindow> probe;
  probe->SetOffScreenRendering(1);
  probe->SetSize(16, 16);
  probe->Render();
  RenderBackend backend{ windows.name, probe->GetClassName(), gl_renderer(probe) };
  // spdlog's own formatting would compile fmt's anew.
  spdlog::info(fmt::format("drawing off-screen with {} ({}, {})", backend.name, backend.gl_renderer,
    backend.window_class));
  return backend;
}

}

const RenderBackend& render_backend()
{
  static const RenderBackend backend = choose();
  return backend;
}

}
