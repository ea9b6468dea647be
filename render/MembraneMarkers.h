#pragma once
// Points of the membrane itself, which its flow carries from frame to frame: they show how it treads.

#include "render/SurfaceMeasures.h"

#include <memory>
#include <vector>

class vtkPolyData;

namespace vesicle
{

/// Asked for one frame after the other. Between two frames the velocity of the membrane, relative to
/// its vesicle's centroid, is that of the nearest point of Loop's surface of each, weighted by time; the
/// error is of second order in the time between frames.
class MembraneMarkers
{
public:
  /// So many on each vesicle, evenly spread at first.
  explicit MembraneMarkers(int count);
  ~MembraneMarkers();

  /// Where they are at the next frame. Throws InputError for one with other vesicles than the first, a
  /// surface that isn't closed, or without the point array Velocity.
  std::vector<Point3> at(vtkPolyData* surface, double time);

private:
  struct Vesicle;
  int count_;
  std::vector<Vesicle> vesicles_;
};

}
