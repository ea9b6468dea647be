#include "EGLContext.h"

#include "SharedLibrary.h"

#include <cstdlib>

namespace vesicle
{
namespace
{

// From EGL/egl.h and EGL/eglext.h, so that neither is needed to build.
constexpr unsigned platform_surfaceless_mesa = 0x31DD;
constexpr unsigned opengl_api = 0x30A2;
constexpr int egl_none = 0x3038;
constexpr int surface_type = 0x3033;
constexpr int pbuffer_bit = 0x0001;
constexpr int renderable_type = 0x3040;
constexpr int opengl_bit = 0x0008;
constexpr int context_major_version = 0x3098;
constexpr int context_minor_version = 0x30FB;
constexpr int context_profile_mask = 0x30FD;
constexpr int context_core_profile_bit = 0x0001;

struct EGL
{
  void* (*get_platform_display)(unsigned platform, void* native, const void* attributes);
  unsigned (*initialize)(void* display, int* major, int* minor);
  unsigned (*bind_api)(unsigned api);
  unsigned (*choose_config)(void* display, const int* attributes, void** configs, int size, int* n);
  void* (*create_context)(void* display, void* config, void* share, const int* attributes);
  unsigned (*destroy_context)(void* display, void* context);
  unsigned (*make_current)(void* display, void* draw, void* read, void* context);
  void* (*get_current_context)();
  void* display;
  void* config;
  bool ended;
};
EGL egl{};

/// Windows may outlive libEGL's driver: ParaView's last until the process ends. From here on
/// OpenGL's functions do nothing and libEGL isn't called any more.
void end()
{
  egl.make_current(egl.display, nullptr, nullptr, nullptr);
  egl.ended = true;
}

bool load_functions(std::string& why_not)
{
  void* library = dlopen("libEGL.so.1", RTLD_NOW);
  if (!library)
  {
    why_not = "libEGL.so.1 is missing (Debian packages libegl1 and libegl-mesa0)";
    return false;
  }
  const bool complete = find_symbol(library, "eglGetPlatformDisplay", egl.get_platform_display) &&
    find_symbol(library, "eglInitialize", egl.initialize) &&
    find_symbol(library, "eglBindAPI", egl.bind_api) &&
    find_symbol(library, "eglChooseConfig", egl.choose_config) &&
    find_symbol(library, "eglCreateContext", egl.create_context) &&
    find_symbol(library, "eglDestroyContext", egl.destroy_context) &&
    find_symbol(library, "eglMakeCurrent", egl.make_current) &&
    find_symbol(library, "eglGetCurrentContext", egl.get_current_context);
  if (!complete)
  {
    why_not = "libEGL.so.1 is older than EGL 1.5";
  }
  return complete;
}

bool load(std::string& why_not)
{
  if (!load_functions(why_not))
  {
    return false;
  }
  why_not = "libEGL has no surfaceless display (Debian package libegl-mesa0)";
  egl.display = egl.get_platform_display(platform_surfaceless_mesa, nullptr, nullptr);
  if (!egl.display || !egl.initialize(egl.display, nullptr, nullptr) || !egl.bind_api(opengl_api))
  {
    return false;
  }
  constexpr int attributes[] = { surface_type, pbuffer_bit, renderable_type, opengl_bit, egl_none };
  int count = 0;
  return egl.choose_config(egl.display, attributes, &egl.config, 1, &count) && count > 0 &&
    std::atexit(end) == 0; // runs before the libraries loaded so far end
}

class EGLContext : public OffscreenContext
{
public:
  explicit EGLContext(void* context) : context_(context) {}

  ~EGLContext() override
  {
    if (!egl.ended)
    {
      release_current();
      egl.destroy_context(egl.display, context_);
    }
  }

  bool make_current() override
  {
    // libEGL registers with GLVND's dispatcher itself.
    return egl.ended || is_current() || egl.make_current(egl.display, nullptr, nullptr, context_);
  }

  bool is_current() const override { return !egl.ended && egl.get_current_context() == context_; }

  void release_current() override
  {
    if (is_current())
    {
      egl.make_current(egl.display, nullptr, nullptr, nullptr);
    }
  }

private:
  void* context_;
};

}

std::unique_ptr<OffscreenContext> make_egl_context(std::string& why_not)
{
  static std::string failure;
  static const bool loaded = load(failure);
  if (!loaded)
  {
    why_not = failure;
    return nullptr;
  }
  constexpr int attributes[] = { context_major_version, 3, context_minor_version, 2,
    context_profile_mask, context_core_profile_bit, egl_none };
  egl.bind_api(opengl_api); // the choice of API is a thread's own
  void* context = egl.create_context(egl.display, egl.config, nullptr, attributes);
  if (!context)
  {
    why_not = "libEGL offers no OpenGL 3.2 core context";
    return nullptr;
  }
  return std::make_unique<EGLContext>(context);
}

}
