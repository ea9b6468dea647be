#pragma once
// Scenes whose numbers have units.

#include "solver/scene/SceneDocument.h"

namespace vesicle
{

/// Makes SI numbers of all values with a unit, each checked for what its key measures, and says
/// units = "SI" at the top. Once one value has a unit all must, but for those without a dimension
/// and 0. Throws InputError with the place of what doesn't fit. A document without units stays as it
/// is.
void convert_units(SceneDocument& document);

}
