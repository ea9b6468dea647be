#pragma once
// A start for the stomatocyte's branch, which no shape of the scenes is near to.

#include "solver/scene/Scene.h"

namespace vesicle::validation
{

/// A bowl (Bowl.h). r0 = 1 and the reduced volume v hold for the scene's surface to 1e-6; as many triangles
/// as the scene's shape asks for.
TriangleMesh stomatocyte(const Scene& scene, double v);

}
