#pragma once
// The solver's meshes and fields as VTK data, and back.

#include "VesicleFiltersModule.h"

#include "solver/mesh/TriangleMesh.h"
#include "solver/mesh/io/SurfaceFile.h"
#include "solver/state/FrameFile.h"

#include "vtkSmartPointer.h"

#include <string>

class vtkCellArray;
class vtkCompositeDataSet;
class vtkDataObject;
class vtkDoubleArray;
class vtkPoints;
class vtkPolyData;
class vtkUnstructuredGrid;

namespace vesicle
{

/// Points and triangles of a surface as triangulated() makes it; other cells are left out.
VESICLEFILTERS_EXPORT TriangleMesh to_mesh(vtkPolyData* surface);

VESICLEFILTERS_EXPORT vtkSmartPointer<vtkPolyData> to_polydata(const TriangleMesh& mesh);
VESICLEFILTERS_EXPORT vtkSmartPointer<vtkPoints> to_vtk_points(
  const Points& points); ///< in double precision
/// The surface's own points in double precision, as what is computed from them is.
VESICLEFILTERS_EXPORT void use_double_points(vtkPolyData* surface);
VESICLEFILTERS_EXPORT vtkSmartPointer<vtkCellArray> to_cells(const Triangles& triangles);
/// One tuple a row, with unit and names of components (ArrayLabels.h).
VESICLEFILTERS_EXPORT vtkSmartPointer<vtkDoubleArray> to_array(
  const std::string& name, const Eigen::MatrixXd& values);

/// The same triangles and arrays as a frame for an HDF5 file, all numbers in double precision;
/// arrays that aren't numbers or have no name are left out.
VESICLEFILTERS_EXPORT Frame to_frame(vtkPolyData* surface, double time);

/// The same triangles and arrays as an unstructured grid, which more programs read.
VESICLEFILTERS_EXPORT vtkSmartPointer<vtkUnstructuredGrid> to_unstructured_grid(
  vtkPolyData* surface);

// The three ways in, each checked before anything follows a number of it: offsets and corners of
// cells, finite coordinates, a value of each array for each point and cell (what it has beyond is
// left out). Polygons and strips are cut into triangles as triangulate() of the solver does, vertices
// and lines left out; arrays pass through, those of cells with their polygons. Throw InputError "name: …" with the face and the
// index.

VESICLEFILTERS_EXPORT vtkSmartPointer<vtkPolyData> triangulated(
  vtkPolyData* surface, const std::string& name = "input");

/// Of a vtkPolyData or of a vtkUnstructuredGrid on its own points, or of blocks of them (joined());
/// an InputError for other data and for cells that aren't flat polygons.
VESICLEFILTERS_EXPORT vtkSmartPointer<vtkPolyData> triangulated(
  vtkDataObject* surface, const std::string& name);

VESICLEFILTERS_EXPORT vtkSmartPointer<vtkPolyData> triangulated(
  const SurfaceFile& file, const std::string& name);

/// A triangulated surface with all its arrays that have numbers or text.
VESICLEFILTERS_EXPORT SurfaceFile to_surface_file(vtkPolyData* triangles);

/// A triangulated surface without what other pieces of it have, too, or what is hidden: cells that
/// vtkGhostType marks as DUPLICATECELL or HIDDENCELL, or with a point that is a HIDDENPOINT. The
/// points stay.
VESICLEFILTERS_EXPORT vtkSmartPointer<vtkPolyData> without_ghosts(vtkPolyData* triangles);

/// A triangulated surface whose points nearer than `distance` (> 0) are one, with the values of the
/// first; triangles that lose a corner by that are left out.
VESICLEFILTERS_EXPORT vtkSmartPointer<vtkPolyData> merged(vtkPolyData* triangles, double distance);

/// The surfaces of all blocks, without ghosts, as one: what is a piece of a surface in another block
/// goes on there, as points at the same place become one. It has the point arrays that all blocks
/// have, and the field data of the first.
VESICLEFILTERS_EXPORT vtkSmartPointer<vtkPolyData> joined(
  vtkCompositeDataSet* blocks, const std::string& name);

/// Triangles as triangulated() makes them, without ghosts, and the points that they use, with all
/// arrays.
VESICLEFILTERS_EXPORT vtkSmartPointer<vtkPolyData> membrane_of(
  vtkDataObject* surface, const std::string& name = "input");

}
