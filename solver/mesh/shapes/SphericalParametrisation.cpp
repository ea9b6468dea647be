#include "solver/mesh/shapes/SphericalParametrisation.h"

namespace vesicle
{

TriangleMesh mapped(TriangleMesh mesh, const SphericalParametrisation& surface)
{
  for (int i = 0; i < mesh.points.rows(); ++i)
    mesh.points.row(i) = surface(mesh.points.row(i).transpose()).transpose();
  return mesh;
}

}
