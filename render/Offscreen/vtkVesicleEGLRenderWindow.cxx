#include "vtkVesicleEGLRenderWindow.h"

#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 4, 0)

#include "EGLContext.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkVesicleEGLRenderWindow);

void vtkVesicleEGLRenderWindow::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

std::unique_ptr<vesicle::OffscreenContext> vtkVesicleEGLRenderWindow::CreateContext(
  std::string& whyNot)
{
  return vesicle::make_egl_context(whyNot);
}

#endif
