#include "OffscreenWindows.h"

#include "EGLContext.h"
#include "OSMesaContext.h"
#include "vtkVesicleEGLRenderWindow.h"
#include "vtkVesicleOSMesaRenderWindow.h"

#include "vtkGenericRenderWindowInteractor.h"
#include "vtkObjectFactory.h"
#include "vtkRenderingOpenGLConfigure.h"
#include "vtkVersion.h"

#include <cstdlib>

#include <dlfcn.h>

namespace vesicle
{

std::string environment(const char* name)
{
  const char* value = std::getenv(name);
  return value ? value : "";
}

bool screen_answers()
{
  static const bool answers = []
  {
    if (environment("DISPLAY").empty())
    {
      return false;
    }
    void* x11 = dlopen("libX11.so.6", RTLD_LAZY | RTLD_LOCAL);
    const auto open =
      x11 ? reinterpret_cast<void* (*)(const char*)>(dlsym(x11, "XOpenDisplay")) : nullptr;
    const auto close =
      x11 ? reinterpret_cast<int (*)(void*)>(dlsym(x11, "XCloseDisplay")) : nullptr;
    void* display = open && close ? open(nullptr) : nullptr;
    if (display)
    {
      close(display);
    }
    return display != nullptr;
  }();
  return answers;
}

namespace
{

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)

OffscreenWindows choose()
{
  setenv("VTK_DEFAULT_OPENGL_WINDOW", "vtkOSOpenGLRenderWindow", 0);
  return { "VTK", "" };
}

#elif defined(VTK_OPENGL_HAS_OSMESA)

OffscreenWindows choose()
{
  return { "VTK OSMesa", "" };
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

bool wanted(const std::string& name)
{
  const std::string only = environment("VESICLE_RENDER_BACKEND");
  return only.empty() || only == name;
}

struct Way
{
  std::string name;
  std::string backend; // in VESICLE_RENDER_BACKEND
  std::unique_ptr<OffscreenContext> (*make_context)(std::string& why_not);
  const char* window;
  vtkObjectFactory::CreateFunction create;
};

OffscreenWindows choose()
{
  const Way ways[] = { { "OSMesa", "osmesa", make_osmesa_context, "vtkVesicleOSMesaRenderWindow",
                         vtkObjectFactoryCreatevtkVesicleOSMesaRenderWindow },
    { "EGL", "egl", make_egl_context, "vtkVesicleEGLRenderWindow",
      vtkObjectFactoryCreatevtkVesicleEGLRenderWindow } };
  std::string failures;
  std::string why_not;
  for (const Way& way : ways)
  {
    if (wanted(way.backend) && way.make_context(why_not))
    {
      OffscreenFactory::register_window(way.window, way.create);
      return { way.name, failures };
    }
    failures += wanted(way.backend) ? why_not + "; " : "";
  }
  if (wanted("x") && screen_answers())
  {
    return { "X", failures };
  }
  const std::string display = environment("DISPLAY");
  return { "",
    failures + "no X server (" +
      (display.empty() ? "DISPLAY is not set" : "nothing answers at DISPLAY " + display) + ")" };
}

#endif

}

const OffscreenWindows& use_offscreen_windows()
{
  static const OffscreenWindows windows = choose();
  return windows;
}

}
