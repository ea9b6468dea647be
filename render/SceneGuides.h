#pragma once
// What drives the vesicle, to be drawn in a corner of its pictures.

#include "render/CornerMarker.h"

#include "solver/scene/Scene.h"

#include <vector>

namespace vesicle
{

/// The flow far away as arrows where it shows its kind (a profile, what comes in and goes out), the
/// longest of unit length, and gravity, which points down for a load that grows with z. Empty where
/// the scene has neither.
std::vector<Guide> scene_guides(const Scene& scene, const View& view);

}
