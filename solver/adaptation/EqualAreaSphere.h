#pragma once
// A sphere on which every patch of a surface has its own area.

#include "solver/surface/Surface.h"

namespace vesicle
{

/// A surface's vertices, moved to the sphere of its area about the origin: N by 3. From their directions as
/// seen from the volume's centroid they go along a flow that carries the surface's area until it is
/// even (J. Moser, Trans. Amer. Math. Soc. 120 (1965) 286): no patch of the surface is dilated, all
/// strain is shear. Of a body of revolution each circle becomes the circle with the same area on its
/// sides. Throws InputError where the surface isn't star-shaped about its centroid, or its mesh so
/// coarse that patches are dilated by more than 5% in the root mean square.
Points equal_area_sphere(const Surface& surface);

}
