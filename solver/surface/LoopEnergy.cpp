#include "solver/surface/LoopEnergy.h"

#include "solver/surface/Collocation.h"
#include "solver/surface/LoopBasis.h"
#include "solver/surface/SurfaceIntegrals.h"

#include <cmath>

namespace vesicle
{

double LoopEnergy::disagreement() const
{
  return std::abs(coarse / fine - 1);
}

LoopEnergy loop_energy(const TriangleMesh& mesh)
{
  const LoopBasis basis(mesh.triangles, static_cast<int>(mesh.points.rows()));
  const Points control = Collocation(basis).fit(mesh.points);
  const auto energy = [&](int points, int graded)
  {
    const BasisTable table = tabulate_rule(basis, triangle_rule(points), graded);
    const SurfacePoints surface = evaluate(table, control);
    return 2 * surface.area_weight.dot(mean_curvature(table, surface, control).cwiseAbs2());
  };
  return { energy(3, 0), energy(12, 3) };
}

}
