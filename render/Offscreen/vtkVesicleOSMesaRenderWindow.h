#pragma once
/**
 * @class   vtkVesicleOSMesaRenderWindow
 * @brief   off-screen window: software rendering by Mesa's libOSMesa
 */

#include "vtkVesicleOffscreenRenderWindow.h"

#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 4, 0)

class VESICLEOFFSCREEN_EXPORT vtkVesicleOSMesaRenderWindow : public vtkVesicleOffscreenRenderWindow
{
public:
  static vtkVesicleOSMesaRenderWindow* New();
  vtkTypeMacro(vtkVesicleOSMesaRenderWindow, vtkVesicleOffscreenRenderWindow);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkVesicleOSMesaRenderWindow() = default;
  ~vtkVesicleOSMesaRenderWindow() override = default;
  std::unique_ptr<vesicle::OffscreenContext> CreateContext(std::string& whyNot) override;

private:
  vtkVesicleOSMesaRenderWindow(const vtkVesicleOSMesaRenderWindow&) = delete;
  void operator=(const vtkVesicleOSMesaRenderWindow&) = delete;
};

#endif
