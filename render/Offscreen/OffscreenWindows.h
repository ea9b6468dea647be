#pragma once
// Where pictures are drawn without a screen: the first of these that works.
//   1. VTK's own OSMesa window, where VTK was built with it (VTK 9.4 or later: chosen at run time)
//   2. libOSMesa with our window class
//   3. libEGL's surfaceless platform with our window class
//   4. VTK's default window, only where an X server answers at DISPLAY
// The environment variable VESICLE_RENDER_BACKEND (osmesa, egl or x) tries that one alone.

#include "VesicleOffscreenModule.h"

#include <string>

namespace vesicle
{

struct OffscreenWindows
{
  std::string name;     ///< "OSMesa", "EGL", "VTK OSMesa", "VTK" or "X"; empty: nothing works
  std::string failures; ///< what was tried before and why it can't be used; empty: nothing
};

/// Chooses on the first call, and registers the window (and an interactor without events) with
/// VTK's object factory, so that vtkRenderWindow::New() makes it, also for charts and
/// vtkContextView. VTK's rendering library must have been initialised before (vtk_module_autoinit,
/// or in Python by its import).
VESICLEOFFSCREEN_EXPORT const OffscreenWindows& use_offscreen_windows();

/// Whether an X server answers at DISPLAY: VTK's own window ends the process where none does.
VESICLEOFFSCREEN_EXPORT bool screen_answers();

/// The value of an environment variable; empty where it isn't set.
VESICLEOFFSCREEN_EXPORT std::string environment(const char* name);

}
