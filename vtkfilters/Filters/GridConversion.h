#pragma once
// Grids of files as VTK's data sets.

#include "solver/mesh/io/GridFile.h"

#include "vtkDataSet.h"
#include "vtkSmartPointer.h"

#include <string>

namespace vesicle
{

/// Throws InputError "name: …" where points and extents don't fit together, an array has not a tuple for each
/// point or cell, or a place isn't finite. What cells and faces say isn't followed: check_cells().
vtkSmartPointer<vtkDataSet> to_data_set(const GridFile& grid, const std::string& name);

}
