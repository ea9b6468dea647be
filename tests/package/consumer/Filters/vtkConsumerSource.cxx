#include "vtkConsumerSource.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkConsumerSource);

vtkConsumerSource::vtkConsumerSource()
{
  this->SetShape(Prolate);
  this->SetBasis(Linear); // the volume of the triangles
  this->SetReducedVolume(0.8);
  this->SetTriangles(320);
}
