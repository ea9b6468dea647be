#include "tests/fuzz/Surfaces.h"

#include "tests/fuzz/Fault.h"

#include "vtkfilters/Filters/MeshConversion.h"

#include "vtkAbstractArray.h"
#include "vtkCellData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

namespace vesicle::fuzz
{
namespace
{

void require_values(vtkFieldData* arrays, vtkIdType count)
{
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
    require(arrays->GetAbstractArray(i)->GetNumberOfTuples() == count,
      "an array is too short or too long");
}

}

void require_sound(vtkPolyData* surface)
{
  const TriangleMesh mesh = to_mesh(surface);
  require(mesh.points.allFinite(), "a point isn't finite");
  for (const int corner : mesh.triangles.reshaped())
    require(corner >= 0 && corner < mesh.points.rows(), "a corner is no point");
  require(surface->GetNumberOfCells() == mesh.triangles.rows(), "there are cells but triangles");
  require_values(surface->GetPointData(), mesh.points.rows());
  require_values(surface->GetCellData(), mesh.triangles.rows());
}

}
