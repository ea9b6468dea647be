#pragma once
// A mesh's surface, flat or Loop's, as a discretization integrates over it.

#include "solver/dynamics/Discretization.h"

#include <memory>

namespace vesicle::test
{

struct SurfaceCase
{
  std::unique_ptr<Discretization> discretization;
  ShapeOperators shape;
  SurfacePoints surface;

  SurfaceCase(const TriangleMesh& mesh, Scene::Basis basis, const Model& model = {})
    : discretization(
        (basis == Scene::Basis::linear ? make_linear_discretization : make_loop_discretization)(
          model, mesh.triangles, static_cast<int>(mesh.points.rows()), 3)),
      shape(discretization->shape(mesh.points)),
      surface(evaluate(discretization->table(), shape.control))
  {
  }

  /// A nodal field's interpolant through the vertices' values, at the surface's rows.
  RowVectors at_rows(const Points& at_vertices) const
  {
    return interpolate(
      discretization->table(), rows_of_three(discretization->to_control(flat(at_vertices))));
  }
};

}
