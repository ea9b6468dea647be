#pragma once
// Where pictures are drawn: the first of these that works.
//   1. VTK's own OSMesa window, where VTK was built with it (VTK 9.4 or later: chosen at run time)
//   2. libOSMesa with our window class
//   3. libEGL's surfaceless platform with our window class
//   4. VTK's default window, only where DISPLAY names an X server
// The environment variable VESICLE_RENDER_BACKEND (osmesa, egl or x) tries that one alone.

#include <string>

namespace vesicle
{

struct RenderBackend
{
  std::string name;         ///< "OSMesa", "EGL", "VTK OSMesa", "VTK" or "X"
  std::string window_class; ///< what vtkRenderWindow::New() makes from now on
  std::string gl_renderer;  ///< OpenGL's GL_RENDERER, e.g. "llvmpipe (LLVM 15.0.6, 256 bits)"
};

/// Chooses the back end on the first call, logs it, and registers its window (and an interactor
/// without events) with VTK's object factory, so that charts and vtkContextView draw there too.
/// Throws std::runtime_error saying what to install when nothing works.
const RenderBackend& render_backend();

}
