#include "vtkVesicleMeshWriter.h"

#include "MeshConversion.h"
#include "MeshFiles.h"
#include "SurfacePorts.h"

#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <exception>
#include <string>

vtkStandardNewMacro(vtkVesicleMeshWriter);

vtkVesicleMeshWriter::~vtkVesicleMeshWriter()
{
  this->SetFileName(nullptr);
}

int vtkVesicleMeshWriter::FillInputPortInformation(int, vtkInformation* info)
{
  vesicle::take_surfaces_together(info);
  return 1;
}

void vtkVesicleMeshWriter::WriteData()
{
  this->SetErrorCode(vtkErrorCode::NoError);
  if (!this->FileName || !*this->FileName)
  {
    this->SetErrorCode(vtkErrorCode::NoFileNameError);
    vtkErrorMacro(<< "no file: set FileName");
    return;
  }
  try
  {
    const std::string lost =
      vesicle::write_mesh(vesicle::triangulated(this->GetInput(), "input"), this->FileName);
    if (!lost.empty())
    {
      vtkWarningMacro(<< lost);
    }
  }
  catch (const std::exception& error)
  {
    this->SetErrorCode(vtkErrorCode::CannotOpenFileError);
    vtkErrorMacro(<< error.what());
  }
}

void vtkVesicleMeshWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << '\n';
}
