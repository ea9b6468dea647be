#include "solver/surface/LoopEnergy.h"

#include "solver/mesh/MeshIntegrals.h"
#include "solver/surface/SurfaceIntegrals.h"
#include "solver/surface/SurfaceMeasures.h"

#include <cmath>

namespace vesicle
{

double LoopEnergy::disagreement() const
{
  return std::abs(coarse / fine - 1);
}

LoopEnergyRules::LoopEnergyRules(const Triangles& triangles, int points, int few)
  : basis_(triangles, points), collocation_(basis_),
    coarse_(tabulate_rule(basis_, triangle_rule(few))),
    fine_(tabulate_rule(basis_, triangle_rule(12), 3))
{
}

// Of every triangle.
static Eigen::VectorXd energies(const BasisTable& table, const Points& control, Eigen::Index count)
{
  const SurfacePoints surface = evaluate(table, control);
  const Eigen::VectorXd H = mean_curvature(table, surface, control);
  Eigen::VectorXd energy = Eigen::VectorXd::Zero(count);
  for (int q = 0; q < table.rows(); ++q)
    energy[table.element[q]] += 2 * surface.area_weight[q] * H[q] * H[q];
  return energy;
}

LoopEnergy LoopEnergyRules::energy(const Points& points) const
{
  const Triangles& triangles = basis_.elements();
  const Points control = collocation_.fit(points);
  const Eigen::VectorXd coarse = energies(coarse_, control, triangles.rows()),
                        fine = energies(fine_, control, triangles.rows());
  Eigen::Index worst = 0;
  (coarse - fine).cwiseAbs().maxCoeff(&worst);
  Vector3 middle = Vector3::Zero();
  for (int k = 0; k < 3; ++k)
    middle += points.row(triangles(worst, k)).transpose() / 3;
  return { coarse.sum(), fine.sum(), middle };
}

LoopEnergy loop_energy(const TriangleMesh& mesh)
{
  return LoopEnergyRules(mesh.triangles, static_cast<int>(mesh.points.rows())).energy(mesh.points);
}

double loop_error(const TriangleMesh& mesh, double bending_energy, double reduced_volume)
{
  const LoopEnergy energy = loop_energy(mesh);
  const SurfaceMeasures m = surface_measures(SurfaceBasis::loop, mesh);
  return std::abs(energy.fine / bending_energy - 1) + energy.disagreement() +
    std::abs(vesicle::reduced_volume(m.area, m.volume) / reduced_volume - 1);
}

}
