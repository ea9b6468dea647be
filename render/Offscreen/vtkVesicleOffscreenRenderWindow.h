#pragma once
/**
 * @class   vtkVesicleOffscreenRenderWindow
 * @brief   a render window that needs no window system
 *
 * Stock Linux packages of VTK know only windows on an X server. This one draws into framebuffer
 * objects of an OpenGL context without a surface; its subclasses say where that context comes
 * from. It is for VTK 9.1 to 9.3, which load OpenGL through GLEW.
 */

#include "VesicleOffscreenModule.h" // for the export macro
#include "vtkVersionMacros.h"

#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 4, 0)

#include "vtkOpenGLRenderWindow.h"

#include <memory>
#include <string>

namespace vesicle
{
class OffscreenContext;
}

class VESICLEOFFSCREEN_EXPORT vtkVesicleOffscreenRenderWindow : public vtkOpenGLRenderWindow
{
public:
  vtkTypeMacro(vtkVesicleOffscreenRenderWindow, vtkOpenGLRenderWindow);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void Initialize() override;
  void Finalize() override;
  void Frame() override;

  void MakeCurrent() override;
  bool IsCurrent() override;
  void ReleaseCurrent() override;
  void OpenGLInitContext() override;

  ///@{
  /**
   * There is no screen, no pointer and no event.
   */
  void SetFullScreen(vtkTypeBool) override {}
  void WindowRemap() override {}
  void HideCursor() override {}
  void ShowCursor() override {}
  vtkTypeBool GetEventPending() override { return 0; }
  int* GetScreenSize() override;
  void* GetGenericDisplayId() override { return nullptr; }
  void* GetGenericWindowId() override { return nullptr; }
  void* GetGenericParentId() override { return nullptr; }
  void* GetGenericDrawable() override { return nullptr; }
  void* GetGenericContext() override;
  void SetDisplayId(void*) override {}
  void SetWindowId(void*) override {}
  void SetNextWindowId(void*) override {}
  void SetParentId(void*) override {}
  void SetWindowInfo(const char*) override {}
  void SetNextWindowInfo(const char*) override {}
  void SetParentInfo(const char*) override {}
  ///@}

protected:
  vtkVesicleOffscreenRenderWindow();
  ~vtkVesicleOffscreenRenderWindow() override;

  /**
   * A new context; null, with the reason in whyNot, when there is none to be had.
   */
  virtual std::unique_ptr<vesicle::OffscreenContext> CreateContext(std::string& whyNot) = 0;

  void CreateAWindow() override;
  void DestroyWindow() override;

private:
  std::unique_ptr<vesicle::OffscreenContext> Context;

  vtkVesicleOffscreenRenderWindow(const vtkVesicleOffscreenRenderWindow&) = delete;
  void operator=(const vtkVesicleOffscreenRenderWindow&) = delete;
};

#endif
