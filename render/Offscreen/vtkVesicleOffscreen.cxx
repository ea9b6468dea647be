#include "vtkVesicleOffscreen.h"

#include "OffscreenWindows.h"

#include "vtkObjectFactory.h"

namespace
{

std::string backend;

}

vtkStandardNewMacro(vtkVesicleOffscreen);

bool vtkVesicleOffscreen::Use()
{
  const auto& windows = vesicle::use_offscreen_windows();
  backend = windows.name;
  if (backend.empty())
  {
    vtkGenericWarningMacro(<< "nothing to draw pictures with: " << windows.failures
                           << "; install the Debian package libosmesa6");
  }
  return !backend.empty();
}

bool vtkVesicleOffscreen::UseWithoutScreen()
{
  const bool screen = vesicle::screen_answers();
  const bool asked_for = !vesicle::environment("VESICLE_RENDER_BACKEND").empty();
  return (screen && !asked_for) || vtkVesicleOffscreen::Use();
}

std::string vtkVesicleOffscreen::GetBackend()
{
  return backend;
}

void vtkVesicleOffscreen::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Backend: " << backend << '\n';
}
