#pragma once

#include "solver/surface/Cotan.h"

namespace vesicle::test
{

/// A mesh with its cotan geometry and curvatures.
struct CotanCase
{
  TriangleMesh mesh;
  CotanGeometry geometry;
  Curvature curvature;
  explicit CotanCase(TriangleMesh m, NormalScheme scheme = NormalScheme::area_weighted)
    : mesh(std::move(m)), geometry(mesh.points, mesh.triangles),
      curvature(cotan_curvature(geometry, mesh.points, scheme))
  {
  }
};

}
