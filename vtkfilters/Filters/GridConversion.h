#pragma once
// Grids of files as VTK's data sets.

#include "solver/mesh/io/GridFile.h"

#include "vtkDataSet.h"
#include "vtkSmartPointer.h"

#include <string>

namespace vesicle
{

/// Throws InputError "name: …" where an array has not a tuple for each point or cell. Nothing else is looked at:
/// GridCheck.h.
vtkSmartPointer<vtkDataSet> to_data_set(const GridFile& grid, const std::string& name);

}
