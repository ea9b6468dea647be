#pragma once
// From where the camera looks, and how much it must show.

#include "render/SurfaceMeasures.h"

#include <string>

class vtkCamera;

namespace vesicle
{

/// Unit vectors of the picture plane; the camera sits at focus + toward_camera.
struct View
{
  Point3 right;
  Point3 up;
  Point3 toward_camera;

  /// "auto" looks along +y, so that x goes right and z (flows, gravity) up; "x", "y" and "z" look
  /// along minus that axis; "isometric" shows x, y and z alike. Throws InputError for others.
  static View named(const std::string& name);
};

/// Half the room that every frame seen so far needs about its centroid, in the picture plane.
struct Framing
{
  double half_width = 0;
  double half_height = 0;
  double radius = 0; ///< largest distance of a point from the centroid

  void include(vtkPolyData* surface, const View& view);
};

/// Looks at `focus` in parallel projection (a silhouette is then the true outline) such that the
/// framing, widened by `margin`, fits into `usable_width` (a share of the picture's width, counted
/// from the left) of a picture with this aspect ratio (width / height).
void aim_camera(vtkCamera* camera, const View& view, const Point3& focus, const Framing& framing,
  double margin, double usable_width, double aspect);

}
