#pragma once
// Arrays of files as VTK's.

#include "solver/mesh/io/SurfaceFile.h"

#include "vtkAbstractArray.h"
#include "vtkSmartPointer.h"

#include <vector>

class vtkDataSetAttributes;

namespace vesicle
{

vtkSmartPointer<vtkAbstractArray> to_vtk(const DataArray& array);

/// Adds them, in the roles that the file gives them and VTK takes without a complaint.
void add_arrays(const std::vector<DataArray>& arrays, vtkDataSetAttributes* to);

}
