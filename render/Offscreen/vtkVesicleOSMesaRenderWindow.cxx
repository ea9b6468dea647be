#include "vtkVesicleOSMesaRenderWindow.h"

#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 4, 0)

#include "OSMesaContext.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkVesicleOSMesaRenderWindow);

void vtkVesicleOSMesaRenderWindow::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

std::unique_ptr<vesicle::OffscreenContext> vtkVesicleOSMesaRenderWindow::CreateContext(
  std::string& whyNot)
{
  return vesicle::make_osmesa_context(whyNot);
}

#endif
