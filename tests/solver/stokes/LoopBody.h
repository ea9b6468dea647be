#pragma once

#include "solver/stokes/LayerRules.h"
#include "solver/stokes/StokesOperator.h"
#include "solver/surface/Collocation.h"
#include "solver/surface/LoopBasis.h"

#include <functional>

namespace vesicle::test
{

using Field = std::function<Vector3(const Vector3&)>;

/// One smooth surface through a mesh's vertices, as layers want it.
struct LoopBody
{
  TriangleMesh mesh;
  LoopBasis basis;
  Collocation collocation;
  LayerRules rules;

  /// `points`: of the regular rule, a triangle.
  explicit LoopBody(TriangleMesh m, int points = 3)
    : mesh(std::move(m)), basis(mesh.triangles, static_cast<int>(mesh.points.rows())),
      collocation(basis), rules(basis, layer_quadrature(basis, points))
  {
  }
  LayerSurface surface() const { return { &rules, mesh.points, collocation.fit(mesh.points) }; }
  Eigen::VectorXd sampled(const Field& field) const
  {
    Eigen::VectorXd values(3 * mesh.points.rows());
    for (int i = 0; i < mesh.points.rows(); ++i)
      values.segment<3>(3 * i) = field(mesh.points.row(i).transpose());
    return values;
  }
};

}
