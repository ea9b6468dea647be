#pragma once
// The one place where the numbers of a grid in which a field lives are checked before anything follows them,
// whether a file or a pipeline brings it.

#include <string>

class vtkDataSet;

namespace vesicle
{

/// Of images and rectilinear, structured and unstructured grids; VTK itself asks for none of it. Throws
/// InputError "name: …" with what is wrong and a remedy: places that aren't finite, or not as many as
/// there are points; cells and faces of polyhedra with points that there aren't, or of forms that VTK doesn't
/// interpolate in safely.
void check_grid(vtkDataSet* data, const std::string& name);

}
