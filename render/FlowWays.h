#pragma once
// The ways that the fluid goes in a picture's plane through the vesicle's middle.

#include "render/View.h"

#include <memory>
#include <vector>

class vtkPolyData;

namespace vesicle
{

struct ImposedFlow;

/// The part of the plane that is looked at.
struct FlowPlane
{
  View view;
  Point3 center;
  double half_width = 0, half_height = 0;
  /// Velocities are relative to the centroid's, as a camera sees them that follows it.
  bool along = true;
  /// That of a file, which surfaces don't hold; empty: the flow that the surface says.
  std::shared_ptr<const ImposedFlow> field;
};

/// From its start on, along right, up and toward_camera (0) of the view, from the centre.
using Way = std::vector<Point3>;

double length_of(const Way& way);

/// Each as far as the fluid goes in one and the same time, in the velocity's part within the plane.
struct FlowWays
{
  std::vector<Way> ways;
  double time = 0;
  double distance = 0; ///< between the starts, a pattern that fills the plane
};

/// In the time in which what moves at `speed` > 0 goes as far as the longest way is to be; what is
/// faster goes no farther. Ways start in the fluid outside; those too short to be seen are left out.
/// Throws InputError for a surface that doesn't say how the fluid moves (see vtkVesicleProbeFilter),
/// or how its own points do.
FlowWays flow_ways(vtkPolyData* surface, const FlowPlane& plane, double speed);

/// Of the fluid outside where ways start, within the plane. Throws likewise.
double largest_flow_speed(vtkPolyData* surface, const FlowPlane& plane);

}
