#pragma once
// A mesh's surface, flat or Loop's, as the dynamics integrate over it.

#include "solver/surface/FlatPieces.h"

#include <memory>

namespace vesicle::test
{

struct SurfaceCase
{
  SurfaceSpace space;
  Surface shape;
  const SurfacePoints& surface = shape.points;

  SurfaceCase(const TriangleMesh& mesh, SurfaceBasis basis)
    : space(basis, mesh.triangles, static_cast<int>(mesh.points.rows())), shape(space, mesh.points)
  {
  }

  /// A nodal field's interpolant through the vertices' values, at the surface's rows.
  RowVectors at_rows(const Points& at_vertices) const
  {
    return interpolate(space.table(), rows_of_three(shape.to_control(flat(at_vertices))));
  }
};

}
