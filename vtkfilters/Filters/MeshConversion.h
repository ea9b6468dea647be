#pragma once
// The solver's meshes and fields as VTK data, and back.

#include "VesicleFiltersModule.h"

#include "solver/mesh/TriangleMesh.h"
#include "solver/state/FrameFile.h"

#include "vtkSmartPointer.h"

#include <string>

class vtkCellArray;
class vtkDataSet;
class vtkDoubleArray;
class vtkPoints;
class vtkPolyData;
class vtkUnstructuredGrid;

namespace vesicle
{

/// Points and triangles of a surface; cells other than triangles are left out.
VESICLEFILTERS_EXPORT TriangleMesh to_mesh(vtkPolyData* surface);

VESICLEFILTERS_EXPORT vtkSmartPointer<vtkPolyData> to_polydata(const TriangleMesh& mesh);
VESICLEFILTERS_EXPORT vtkSmartPointer<vtkPoints> to_vtk_points(
  const Points& points); ///< in double precision
/// The surface's own points in double precision, as what is computed from them is.
VESICLEFILTERS_EXPORT void use_double_points(vtkPolyData* surface);
VESICLEFILTERS_EXPORT vtkSmartPointer<vtkCellArray> to_cells(const Triangles& triangles);
/// One tuple a row.
VESICLEFILTERS_EXPORT vtkSmartPointer<vtkDoubleArray> to_array(
  const std::string& name, const Eigen::MatrixXd& values);

/// The same triangles and arrays as a frame for an HDF5 file, all numbers in double precision;
/// arrays that aren't numbers or have no name are left out.
VESICLEFILTERS_EXPORT Frame to_frame(vtkPolyData* surface, double time);

/// The same triangles and arrays as an unstructured grid, which more programs read. Field data that
/// aren't numbers are left out: some readers stop at them.
VESICLEFILTERS_EXPORT vtkSmartPointer<vtkUnstructuredGrid> to_unstructured_grid(
  vtkPolyData* surface);

/// The polygons of a grid on its own points, in its own order, with its arrays; vertices and lines
/// are left out. Throws InputError "name: …" for any other cell.
VESICLEFILTERS_EXPORT vtkSmartPointer<vtkPolyData> polygons_of(
  vtkDataSet* grid, const std::string& name);

/// Polygons and strips cut into triangles, vertices and lines left out; the arrays pass through.
VESICLEFILTERS_EXPORT vtkSmartPointer<vtkPolyData> triangulated(vtkPolyData* surface);

/// Triangles as triangulated() makes them and the points that they use, with all arrays.
VESICLEFILTERS_EXPORT vtkSmartPointer<vtkPolyData> membrane_of(vtkPolyData* surface);

}
