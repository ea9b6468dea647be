#pragma once
// VTK calls OpenGL through GLVND's libOpenGL, which forwards every call to the driver that is
// current on the thread. libGLX and libEGL register their drivers with libGLdispatch; OSMesa
// doesn't, so calls would go nowhere. This registers a driver by hand, with the dispatcher's own
// functions (NVIDIA/libglvnd, src/GLdispatch/GLdispatch.h, ABI version 1).

#include <string>

namespace vesicle
{

/// One driver known to the dispatcher. Lives as long as the process: the dispatcher keeps
/// pointers to it.
class GLDispatchVendor
{
public:
  using GetProcAddress = void* (*)(const char* name, void*);

  /// Null, with the reason in why_not, when the dispatcher is missing or too new.
  static GLDispatchVendor* create(GetProcAddress get_proc_address, std::string& why_not);

  /// Sends the calling thread's OpenGL calls to this driver. False when another window system's
  /// context (GLX, EGL) is current: only its owner may release that.
  bool make_current() const;
  bool is_current() const;
  void release_current() const;

private:
  GLDispatchVendor() = default;
  int id_ = 0;
  void* table_ = nullptr;
};

}
