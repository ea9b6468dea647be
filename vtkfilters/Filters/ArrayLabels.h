#pragma once
// What the numbers of an array are, where VTK has a place for it.

#include "VesicleFiltersModule.h"

class vtkDataArray;

namespace vesicle
{

/// Gives an array the unit that its name has in the output contract (vtkDataArray::UNITS_LABEL, in
/// words, as units are the scene's or the mesh's own: "1/length^2"; "1": a plain number), and the
/// three components of a vector the names X, Y, Z. Arrays of other names get no unit.
VESICLEFILTERS_EXPORT void label(vtkDataArray* array);

}
