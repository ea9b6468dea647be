#pragma once
// Arrows for the surface's velocity at a modest number of vertices.

#include "vtkActor.h"
#include "vtkArrowSource.h"
#include "vtkGlyph3D.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"

#include <vector>

namespace vesicle
{

class VelocityArrows
{
public:
  VelocityArrows();

  vtkActor* actor() const { return actor_; }

  /// Shows the point array Velocity, relative to the centroid's velocity when `comoving`; an arrow
  /// of `speed` is `length` long. Throws InputError when the array is missing or not finite.
  void show(vtkPolyData* surface, bool comoving, double speed, double length);

  /// Largest speed of the array (relative to the centroid's velocity when `comoving`).
  static double largest_speed(vtkPolyData* surface, bool comoving);

private:
  void choose_points(vtkPolyData* surface);

  std::vector<long long> points_; ///< kept while the mesh stays the same, so that arrows don't jump
  vtkIdType mesh_points_ = 0;
  vtkNew<vtkPolyData> feet_;
  vtkNew<vtkArrowSource> arrow_;
  vtkNew<vtkGlyph3D> glyphs_;
  vtkNew<vtkPolyDataMapper> mapper_;
  vtkNew<vtkActor> actor_;
};

}
