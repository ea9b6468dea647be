#pragma once
// One vesicle on the stage: its surface coloured by an array, mesh edges, arrows.

#include "render/SmoothSurface.h"
#include "render/SurfaceMeasures.h"
#include "render/VelocityArrows.h"

#include "vtkActor.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolyDataNormals.h"

#include <string>

class vtkLookupTable;
class vtkRenderer;

namespace vesicle
{

class VesicleActor
{
public:
  struct Look
  {
    std::string color; ///< point array
    bool smooth = false;
    bool edges = false;
    bool arrows = false;
    double line_width = 1; ///< of edges, in pixels
  };

  VesicleActor(Look look, vtkLookupTable* colors);

  void add_to(vtkRenderer* renderer);

  /// Throws InputError for a surface that can't be drawn (array missing or not finite; smooth: mesh
  /// not closed).
  void show(vtkPolyData* surface);
  /// Arrows of the lipid flow: one of `speed` is `length` long.
  void show_arrows(vtkPolyData* surface, double speed, double length);
  /// Moves everything by this.
  void place(const Point3& shift);

private:
  void set_surface(vtkPolyData* surface);

  Look look_;
  SmoothSurface smooth_;
  vtkNew<vtkPolyDataNormals> normals_;
  vtkNew<vtkPolyDataMapper> mapper_;
  vtkNew<vtkActor> actor_;
  vtkNew<vtkPolyDataMapper> edge_mapper_;
  vtkNew<vtkActor> edges_;
  VelocityArrows arrows_;
};

}
