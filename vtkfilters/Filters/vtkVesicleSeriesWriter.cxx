#include "vtkVesicleSeriesWriter.h"

#include "SeriesWriter.h"
#include "SurfacePorts.h"

#include "solver/Errors.h"

#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <exception>
#include <filesystem>

vtkStandardNewMacro(vtkVesicleSeriesWriter);

namespace
{

double time_of(vtkDataObject* surface)
{
  vtkDataArray* value = surface->GetFieldData()->GetArray("TimeValue");
  if (value && value->GetNumberOfTuples() == 1)
  {
    return value->GetComponent(0, 0);
  }
  if (surface->GetInformation()->Has(vtkDataObject::DATA_TIME_STEP()))
  {
    return surface->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP());
  }
  throw vesicle::InputError("the surface has no time: give it the field data array TimeValue");
}

std::unique_ptr<vesicle::SeriesWriter> series_in(const std::filesystem::path& file)
{
  return std::make_unique<vesicle::SeriesWriter>(file.parent_path(), file.stem().string());
}

}

vtkVesicleSeriesWriter::vtkVesicleSeriesWriter() = default;

vtkVesicleSeriesWriter::~vtkVesicleSeriesWriter()
{
  delete[] this->FileName;
}

void vtkVesicleSeriesWriter::SetFileName(const char* name)
{
  vtkSetStringBodyMacro(FileName, name);
  this->Series.reset();
}

int vtkVesicleSeriesWriter::FillInputPortInformation(int, vtkInformation* info)
{
  vesicle::take_surfaces_together(info);
  return 1;
}

void vtkVesicleSeriesWriter::WriteData()
{
  this->SetErrorCode(vtkErrorCode::NoError);
  if (!this->FileName || !*this->FileName)
  {
    this->SetErrorCode(vtkErrorCode::NoFileNameError);
    vtkErrorMacro(<< "no series: set FileName");
    return;
  }
  try
  {
    if (!this->Series)
    {
      this->Series = series_in(this->FileName);
    }
    this->Series->append(this->GetInput(), time_of(this->GetInput()));
  }
  catch (const std::exception& error)
  {
    this->SetErrorCode(vtkErrorCode::CannotOpenFileError);
    vtkErrorMacro(<< error.what());
  }
}

void vtkVesicleSeriesWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << '\n';
}
