#pragma once
// Where pictures are drawn: render/Offscreen/OffscreenWindows.h says in which order what is tried.

#include "solver/Errors.h"

#include <string>

namespace vesicle
{

/// This machine has nothing that draws; the message says what to install.
struct NothingToDrawWith : IoError
{
  using IoError::IoError;
};

struct RenderBackend
{
  std::string name;         ///< "OSMesa", "EGL", "VTK OSMesa", "VTK" or "X"
  std::string window_class; ///< what vtkRenderWindow::New() makes from now on
  std::string gl_renderer;  ///< OpenGL's GL_RENDERER, e.g. "llvmpipe (LLVM 15.0.6, 256 bits)"
};

/// Chooses the back end on the first call and logs it. Throws NothingToDrawWith when nothing
/// works.
const RenderBackend& render_backend();

}
