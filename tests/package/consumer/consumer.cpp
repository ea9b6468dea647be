// Vesicle's filters in a pipeline of VTK's own; the solver and the render library link as well.

#include "vtkConsumerSource.h"

#include "MeshConversion.h"
#include "vtkVesicleCurvatureFilter.h"
#include "vtkVesicleOffscreen.h"

#include "render/SurfaceMeasures.h"
#include "solver/mesh/MeshIntegrals.h"
#include "solver/mesh/Topology.h"
#include "solver/mesh/TriangleMesh.h"

#include "vtkCleanPolyData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

namespace
{

void require(bool condition, const char* what)
{
  if (!condition)
  {
    std::cerr << "failed: " << what << '\n';
    std::exit(1);
  }
}

}

int main()
{
  constexpr double scale = 2;
  vtkNew<vtkConsumerSource> source;
  vtkNew<vtkTransform> transform;
  transform->Scale(scale, scale, scale);
  vtkNew<vtkTransformPolyDataFilter> scaled;
  scaled->SetTransform(transform);
  scaled->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputConnection(scaled->GetOutputPort());
  vtkNew<vtkVesicleCurvatureFilter> curvature;
  curvature->SetInputConnection(clean->GetOutputPort());
  curvature->SetCurvatureTypeToMean();
  curvature->Update();

  vtkPolyData* surface = curvature->GetOutput();
  require(surface->GetNumberOfPolys() == 320, "320 triangles");
  vtkDataArray* mean = surface->GetPointData()->GetScalars();
  require(mean && std::string(mean->GetName()) == "Mean_Curvature", "Mean_Curvature is active");
  require(mean->GetRange()[0] > 0 && mean->GetRange()[0] < 1 / scale,
    "a prolate's waist is flatter than the sphere of its volume");

  const vesicle::TriangleMesh mesh = vesicle::to_mesh(surface);
  require(vesicle::topology(mesh).closed, "the solver's topology");
  const double volume = 4 * M_PI / 3 * std::pow(scale, 3);
  require(std::abs(vesicle::flat_volume(mesh) - volume) < 1e-6 * volume, "the volume");
  const auto center = vesicle::surface_centroid(surface);
  require(std::abs(center[0]) < 1e-12 * scale, "the render library's centroid");
  require(vtkVesicleOffscreen::Use(), "an off-screen window");
  return 0;
}
