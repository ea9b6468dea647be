#include "render/RenderBackend.h"

#include "render/vtkVesicleEGLRenderWindow.h"
#include "render/vtkVesicleOSMesaRenderWindow.h"

#include "vtkGenericRenderWindowInteractor.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkRenderWindow.h"
#include "vtkRenderingOpenGLConfigure.h"
#include "vtkVersion.h"

#include "render/EGLContext.h"
#include "render/OSMesaContext.h"

#include <spdlog/spdlog.h>

#include <cstdlib>
#include <sstream>
#include <stdexcept>

namespace vesicle
{
namespace
{

std::string environment(const char* name)
{
  const char* value = std::getenv(name);
  return value ? value : "";
}

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

RenderBackend describe(const std::string& name)
{
  vtkNew<vtkRenderWindow> probe;
  probe->SetOffScreenRendering(1);
  probe->SetSize(16, 16);
  probe->Render();
  RenderBackend backend{ name, probe->GetClassName(), gl_renderer(probe) };
  spdlog::info(
    "drawing off-screen with {} ({}, {})", backend.name, backend.gl_renderer, backend.window_class);
  return backend;
}

bool wanted(const std::string& name)
{
  const std::string only = environment("VESICLE_RENDER_BACKEND");
  return only.empty() || only == name;
}

RenderBackend choose_x(const std::string& failures)
{
  if (wanted("x") && !environment("DISPLAY").empty())
  {
    return describe("X");
  }
  throw std::runtime_error("nothing to draw pictures with:" + failures +
    " no X server (DISPLAY is not set); install the Debian package libosmesa6");
}

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)

RenderBackend choose()
{
  setenv("VTK_DEFAULT_OPENGL_WINDOW", "vtkOSOpenGLRenderWindow", 0);
  return describe("VTK");
}

#elif defined(VTK_OPENGL_HAS_OSMESA)

RenderBackend choose()
{
  return describe("VTK OSMesa");
}

#else

VTK_CREATE_CREATE_FUNCTION(vtkGenericRenderWindowInteractor);
VTK_CREATE_CREATE_FUNCTION(vtkVesicleEGLRenderWindow);
VTK_CREATE_CREATE_FUNCTION(vtkVesicleOSMesaRenderWindow);

/// Answers New() of the window and of the interactor with classes that need no X server.
class OffscreenFactory : public vtkObjectFactory
{
public:
  static void register_window(const char* window, vtkObjectFactory::CreateFunction create)
  {
    // VTK's own overrides would win (the window) or crash without X (the interactor).
    vtkObjectFactory::SetAllEnableFlags(0, "vtkRenderWindow");
    vtkObjectFactory::SetAllEnableFlags(0, "vtkRenderWindowInteractor");
    auto* factory = new OffscreenFactory;
    factory->InitializeObjectBase();
    factory->RegisterOverride("vtkRenderWindow", window, "Vesicle off-screen", 1, create);
    factory->RegisterOverride("vtkRenderWindowInteractor", "vtkGenericRenderWindowInteractor",
      "Vesicle off-screen", 1, vtkObjectFactoryCreatevtkGenericRenderWindowInteractor);
    vtkObjectFactory::RegisterFactory(factory);
    factory->Delete();
  }

  const char* GetVTKSourceVersion() override { return VTK_SOURCE_VERSION; }
  const char* GetDescription() override { return "Vesicle's off-screen windows"; }
};

RenderBackend choose()
{
  std::string failures;
  std::string why_not;
  if (wanted("osmesa"))
  {
    if (make_osmesa_context(why_not))
    {
      OffscreenFactory::register_window(
        "vtkVesicleOSMesaRenderWindow", vtkObjectFactoryCreatevtkVesicleOSMesaRenderWindow);
      return describe("OSMesa");
    }
    spdlog::warn("{}; trying EGL instead", why_not);
    failures += ' ' + why_not + ';';
  }
  if (wanted("egl"))
  {
    if (make_egl_context(why_not))
    {
      OffscreenFactory::register_window(
        "vtkVesicleEGLRenderWindow", vtkObjectFactoryCreatevtkVesicleEGLRenderWindow);
      return describe("EGL");
    }
    failures += ' ' + why_not + ';';
  }
  return choose_x(failures);
}

#endif

}

const RenderBackend& render_backend()
{
  static const RenderBackend backend = choose();
  return backend;
}

}
