#pragma once
// Dots on the membrane.

#include "render/SurfaceMeasures.h"

#include "vtkActor.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"

#include <vector>

class vtkRenderer;

namespace vesicle
{

class MarkerDots
{
public:
  MarkerDots();

  void add_to(vtkRenderer* renderer);

  /// `radius`: of the vesicle.
  void show(const std::vector<Point3>& places, double radius);

private:
  vtkNew<vtkPolyData> places_;
  vtkNew<vtkSphereSource> dot_;
  vtkNew<vtkActor> actor_;
};

}
