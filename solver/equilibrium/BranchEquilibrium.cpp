#include "solver/equilibrium/BranchEquilibrium.h"

#include "solver/equilibrium/MeridianMesh.h"
#include "solver/membrane/HelfrichBending.h"

#include <cmath>
#include <numbers>

namespace vesicle
{

BranchEquilibrium branch_equilibrium(
  const BranchRequest& request, const EquilibriumObserver& observer)
{
  using std::numbers::pi;
  const AxisymmetricShape shape = axisymmetric_equilibrium(request.branch, request.reduced_volume);
  TriangleMesh mesh = meridian_mesh(shape.meridian, request.branch, request.triangles);
  const SurfaceSpace space(
    SurfaceBasis::loop, mesh.triangles, static_cast<int>(mesh.points.rows()));
  MembraneTerms terms;
  terms.push_back(make_bending(space, 0));
  const EnergyProblem problem{ space, terms, 4 * pi * std::pow(request.reduced_volume, -2. / 3),
    4 * pi / 3 };
  Equilibrium equilibrium = equilibrium_near(problem, mesh.points, observer);
  if (request.follow && !equilibrium.stable())
    equilibrium =
      equilibrium_below(problem, pushed_along_lowest_mode(problem, equilibrium), observer);
  mesh.points = equilibrium.vertices;
  return { std::move(mesh), std::move(equilibrium), shape.energy };
}

}
