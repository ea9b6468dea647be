#pragma once
// A uniform mesh with a chosen number of triangles on the surface of any other mesh.

#include "solver/mesh/MeshQuality.h"

namespace vesicle
{

/// How a resampled mesh differs from the one it was made from, both taken as flat triangles.
/// Lengths are in units of the input's r0 = (3V/4π)^{1/3}.
struct RemeshReport
{
  int triangles = 0; ///< of the new mesh
  /// Distance of the new vertices to the input and of the input's vertices to the new triangles.
  /// New vertices stand out from the flat triangles of a coarse input.
  double max_distance = 0;
  double rms_distance = 0;
  double area_error = 0; ///< new / input − 1
  double volume_error = 0;
  double input_reduced_volume = 0;
  double reduced_volume = 0;
  MeshQuality quality; ///< edges in the input's units
  int least_valence = 0;
  int largest_valence = 0;
};

struct Remeshed
{
  TriangleMesh mesh;
  RemeshReport report;
};

/// A mesh of about `triangles` triangles of nearly equal size, with its vertices on a smooth
/// surface through the input's vertices. Where a coarse mesh resolves the shape it is one, cut in
/// four time after time: however fine, it has no more extraordinary vertices (valence other than
/// six) than that one, twelve to thirty on most shapes, and Loop's surface converges. The number
/// may then be off by 1%; 20, 80, 320, 1280 … are met exactly. A shape with sharper tips or rims is
/// meshed directly with `triangles` triangles (one more if that is odd: closed meshes have even
/// numbers), and a fifth of the vertices or so is extraordinary. The input must be as
/// prepare_for_dynamics() leaves it; its triangles may be uneven, far more or far fewer. Area and
/// volume aren't corrected. Throws InputError for fewer than 20 or more than 200,000 triangles, or
/// if there are too few to follow the input's shape.
Remeshed remesh(const TriangleMesh& input, int triangles);

}
