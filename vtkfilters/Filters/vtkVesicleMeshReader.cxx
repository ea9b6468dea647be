#include "vtkVesicleMeshReader.h"

#include "MeshFiles.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <exception>

vtkStandardNewMacro(vtkVesicleMeshReader);

vtkVesicleMeshReader::vtkVesicleMeshReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkVesicleMeshReader::~vtkVesicleMeshReader()
{
  this->SetFileName(nullptr);
}

int vtkVesicleMeshReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  if (!this->FileName || !*this->FileName)
  {
    vtkErrorMacro(<< "no file: set FileName");
    return 0;
  }
  try
  {
    vtkPolyData::GetData(outputs)->ShallowCopy(vesicle::read_mesh(this->FileName));
    return 1;
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
    return 0;
  }
}

void vtkVesicleMeshReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << '\n';
}
