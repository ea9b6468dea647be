#pragma once
// Arrows for the flow of lipids along the membrane, at a modest number of vertices: the tangential
// part of the point array Velocity relative to the centroid's velocity. Where the vesicle drifts
// and how its shape changes is not in them.

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
  /// Of the longest arrow, in the vesicle's radius.
  static constexpr double relative_length = 0.3;

  VelocityArrows();

  vtkActor* actor() const { return actor_; }

  /// An arrow of `speed` is `length` long. Throws InputError when the array Velocity is missing or
  /// not finite.
  void show(vtkPolyData* surface, double speed, double length);

  /// Of the fastest point.
  static double largest_speed(vtkPolyData* surface);

private:
  std::vector<long long> points_; ///< kept while the mesh stays the same, so that arrows don't jump
  vtkIdType mesh_points_ = 0;
  vtkNew<vtkPolyData> feet_;
  vtkNew<vtkArrowSource> arrow_;
  vtkNew<vtkGlyph3D> glyphs_;
  vtkNew<vtkPolyDataMapper> mapper_;
  vtkNew<vtkActor> actor_;
};

}
