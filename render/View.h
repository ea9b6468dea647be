#pragma once
// From where the camera looks, and how much it must show.

#include "render/SurfaceMeasures.h"

#include <optional>
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

  /// "front" ("xz") looks along +y, so that x goes right and z (flows, gravity) up; "side" ("yz")
  /// along −x, "top" ("xy") along −z, "iso" shows x, y and z alike. "auto" is front, "x", "y" and
  /// "z" look along minus that axis, "isometric" is iso. Throws InputError for others.
  static View named(const std::string& name);
};

/// Half the room that every frame seen so far needs in the picture plane.
struct Framing
{
  double half_width = 0;
  double half_height = 0;
  double radius = 0;            ///< largest distance of a point from its frame's centroid
  std::optional<Point3> center; ///< where the camera stays; empty: at each frame's centroid

  /// The room about the frame's own centroid, which the camera follows.
  void include(vtkPolyData* surface, const View& view);
};

/// The room for all frames together, for a camera that stays.
class Passage
{
public:
  void include(vtkPolyData* surface, const View& view);
  Framing framing(const View& view) const;

private:
  Point3 low_{}, high_{}; ///< along right, up and toward_camera
  double radius_ = 0;
  bool any_ = false;
};

/// Looks at `focus` in parallel projection (a silhouette is then the true outline) such that the
/// framing, widened by `margin`, fits into `usable_width` (a share of the picture's width, counted
/// from the left) of a picture with this aspect ratio (width / height).
void aim_camera(vtkCamera* camera, const View& view, const Point3& focus, const Framing& framing,
  double margin, double usable_width, double aspect);

}
