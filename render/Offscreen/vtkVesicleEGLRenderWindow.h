#pragma once
/**
 * @class   vtkVesicleEGLRenderWindow
 * @brief   off-screen window: libEGL on Mesa's surfaceless platform
 */

#include "vtkVesicleOffscreenRenderWindow.h"

#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 4, 0)

class VESICLEOFFSCREEN_EXPORT vtkVesicleEGLRenderWindow : public vtkVesicleOffscreenRenderWindow
{
public:
  static vtkVesicleEGLRenderWindow* New();
  vtkTypeMacro(vtkVesicleEGLRenderWindow, vtkVesicleOffscreenRenderWindow);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkVesicleEGLRenderWindow() = default;
  ~vtkVesicleEGLRenderWindow() override = default;
  std::unique_ptr<vesicle::OffscreenContext> CreateContext(std::string& whyNot) override;

private:
  vtkVesicleEGLRenderWindow(const vtkVesicleEGLRenderWindow&) = delete;
  void operator=(const vtkVesicleEGLRenderWindow&) = delete;
};

#endif
