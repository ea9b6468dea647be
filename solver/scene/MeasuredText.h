#pragma once
// Numbers of a scene for people to read.

#include "solver/scene/Scene.h"

#include <string>

namespace vesicle
{

/// "10 um" of a scene in SI, "1e-05" of others. `what` it measures is told as the schema does:
/// "length", "energy / area".
std::string measured_text(double value, const char* what, Units units, int digits = 4);

}
