/**
 * @class   vtkVesicleOffscreen
 * @brief   lets vtkRenderWindow draw where there is no screen
 *
 * VTK packages for Linux know windows on an X server alone and end the process where there is none.
 * After Use(), vtkRenderWindow::New() makes a window that draws into memory through libOSMesa or
 * libEGL, and vtkRenderWindowInteractor::New() one without events; charts and vtkContextView follow
 * suit. Windows made before stay what they are.
 *
 * The environment variable VESICLE_RENDER_BACKEND (osmesa, egl or x) tries that way alone.
 */

#ifndef vtkVesicleOffscreen_h
#define vtkVesicleOffscreen_h

#include "VesicleOffscreenModule.h" // for the export macro
#include "vtkObject.h"

#include <string> // for the back end's name

class VESICLEOFFSCREEN_EXPORT vtkVesicleOffscreen : public vtkObject
{
public:
  static vtkVesicleOffscreen* New();
  vtkTypeMacro(vtkVesicleOffscreen, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * From now on windows need no screen. False, with a warning that says what to install, where
   * nothing works.
   */
  static bool Use();

  /**
   * As Use(), but does nothing where DISPLAY names a screen (unless VESICLE_RENDER_BACKEND is set):
   * windows then open there.
   */
  static bool UseWithoutScreen();

  /**
   * What draws: "OSMesa", "EGL", "X", or "VTK" and "VTK OSMesa" for a VTK that can do it itself;
   * empty before Use() and where nothing works.
   */
  static std::string GetBackend();

protected:
  vtkVesicleOffscreen() = default;
  ~vtkVesicleOffscreen() override = default;

private:
  vtkVesicleOffscreen(const vtkVesicleOffscreen&) = delete;
  void operator=(const vtkVesicleOffscreen&) = delete;
};

#endif
