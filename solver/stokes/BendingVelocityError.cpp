#include "solver/stokes/BendingVelocityError.h"

#include "solver/membrane/HelfrichBending.h"
#include "solver/stokes/StokesOperator.h"

namespace vesicle
{

double bending_velocity_error(
  const TriangleMesh& mesh, const LevelSet& surface, const Curvature& curvature)
{
  const auto n = mesh.points.rows();
  Points force(n, 3);
  for (int i = 0; i < n; ++i)
  {
    const ExactCurvature exact = exact_curvature(surface, mesh.points.row(i));
    force.row(i) = exact.density() * exact.normal.transpose();
  }
  const Points found =
    (curvature.normal.array().colwise() * bending_density(curvature).array()).matrix();
  const LinearBasis basis(mesh.triangles, static_cast<int>(n));
  const LayerRules rules(basis, {});
  const StokesOperator layer({ { &rules, mesh.points, mesh.points } });
  const auto velocity = [&](const Points& density)
  { return layer.apply(std::array{ nodal_density(density) }); };
  return velocity(found - force).norm() / velocity(force).norm();
}

}
