// A vesicle in a shear flow, the fluid's velocity around and inside it, and its streamlines:
//   pipeline_example SCENE.toml TIME STREAMLINES.vtp

#include "vtkVesicleProbeFilter.h"
#include "vtkVesicleStepper.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkLineSource.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStreamTracer.h"
#include "vtkXMLPolyDataWriter.h"

#include <cstdlib>
#include <iostream>

namespace
{

/// Points to probe, in the scene's unit of length.
vtkNew<vtkImageData> box()
{
  vtkNew<vtkImageData> points;
  points->SetDimensions(31, 11, 31);
  points->SetOrigin(-3, -1, -3);
  points->SetSpacing(0.2, 0.2, 0.2);
  return points;
}

}

int main(int argc, char** argv)
{
  if (argc != 4)
  {
    std::cerr << "usage: pipeline_example SCENE.toml TIME STREAMLINES.vtp\n";
    return 2;
  }
  vtkNew<vtkVesicleStepper> stepper; // a source of time steps
  stepper->SetSceneFileName(argv[1]);
  stepper->AddOverride("vesicle.triangles=180");

  vtkNew<vtkVesicleProbeFilter> flow;
  flow->SetInputData(box());
  flow->SetSourceConnection(stepper->GetOutputPort());

  vtkNew<vtkLineSource> seeds;
  seeds->SetPoint1(-2.5, 0, -2);
  seeds->SetPoint2(-2.5, 0, 2);
  seeds->SetResolution(20);
  vtkNew<vtkStreamTracer> lines;
  lines->SetInputConnection(flow->GetOutputPort());
  lines->SetSourceConnection(seeds->GetOutputPort());
  lines->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Velocity");
  lines->SetMaximumPropagation(20);
  lines->SetIntegrationDirectionToBoth();

  stepper->UpdateTimeStep(std::atof(argv[2]));
  if (stepper->GetErrorCategory() != vtkVesicleStepper::NoFailure)
  {
    std::cerr << stepper->GetErrorMessage() << '\n';
    return 1;
  }
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputConnection(lines->GetOutputPort());
  writer->SetFileName(argv[3]);
  if (!writer->Write())
  {
    return 1;
  }
  std::cout << lines->GetOutput()->GetNumberOfLines() << " streamlines at t = "
            << stepper->GetOutput()->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()) << '\n';
}
