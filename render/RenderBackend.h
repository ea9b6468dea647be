#pragma once
// Where pictures are drawn: render/Offscreen/OffscreenWindows.h says in which order what is tried.

#include <string>

namespace vesicle
{

struct RenderBackend
{
  std::string name;         ///< "OSMesa", "EGL", "VTK OSMesa", "VTK" or "X"
  std::string window_class; ///< what vtkRenderWindow::New() makes from now on
  std::string gl_renderer;  ///< OpenGL's GL_RENDERER, e.g. "llvmpipe (LLVM 15.0.6, 256 bits)"
};

/// Chooses the back end on the first call and logs it. Throws std::runtime_error saying what to
/// install when nothing works.
const RenderBackend& render_backend();

}
