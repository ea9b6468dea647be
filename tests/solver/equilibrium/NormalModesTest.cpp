#include "solver/equilibrium/NormalModes.h"

#include "solver/membrane/AreaDifference.h"
#include "solver/membrane/HelfrichBending.h"
#include "solver/mesh/shapes/SphericalHarmonics.h"
#include "tests/solver/support/TestMeshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vesicle
{
namespace
{

using std::numbers::pi;

// Of a sphere of radius 1 under tension σ and the pressure 2σ that balances it, a displacement
// u Y_lm has the second variation (l − 1)(l + 2) [l (l + 1) + σ] u² (Helfrich, J. Physique 47 (1986)
// 321; c0 = 0).
TEST(SecondVariation, OfASphereIsThatOfItsHarmonics)
{
  const TriangleMesh mesh = test::smooth_sphere(1280);
  const SurfaceSpace space(
    SurfaceBasis::loop, mesh.triangles, static_cast<int>(mesh.points.rows()));
  MembraneTerms terms;
  terms.push_back(make_bending(space, 0));
  const EnergyProblem problem{ space, terms, 4 * pi, 4 * pi / 3 };
  const EnergyPoint sphere(
    problem, rows_of_three(space.collocation().to_control(flat(mesh.points))));
  const double tension = -3;
  const Eigen::SparseMatrix<double> H = normal_part(
    sphere.lagrangian_hessian(SecondVariation(space.table()), { tension, 2 * tension }));
  for (const int l : { 0, 1, 2, 3, 4 })
  {
    Eigen::VectorXd u(mesh.points.rows());
    for (int i = 0; i < u.size(); ++i)
      u[i] =
        real_spherical_harmonic(l, std::min(l, 2), mesh.points.row(i).transpose().normalized());
    const Eigen::VectorXd at_control = space.collocation().fit(u);
    const double second = at_control.dot(H.selfadjointView<Eigen::Lower>() * at_control);
    const double exact = (l - 1) * (l + 2) * (l * (l + 1) + tension);
    // h² of the mesh: 1.2% where l = 4
    EXPECT_NEAR(second, exact, 0.02 * std::max(1., std::abs(exact))) << l;
  }
}

// All that goes into the Lagrangian, against differences of its gradient.
TEST(SecondVariation, IsTheDerivativeOfTheGradient)
{
  TriangleMesh mesh = test::smooth_sphere(320);
  mesh.points = (mesh.points * Eigen::Vector3d(1.3, 1.1, 0.8).asDiagonal()).eval();
  const SurfaceSpace space(
    SurfaceBasis::loop, mesh.triangles, static_cast<int>(mesh.points.rows()));
  MembraneTerms terms;
  terms.push_back(make_bending(space, 0.7));
  const EnergyProblem problem{ space, terms, 1, 1 };
  const Multipliers multipliers{ -2, 3 };
  const EnergyPoint at(problem, rows_of_three(space.collocation().to_control(flat(mesh.points))));
  Eigen::VectorXd y(3 * mesh.points.rows());
  for (Eigen::Index i = 0; i < y.size(); ++i)
    y[i] = std::sin(0.9 * static_cast<double>(i));
  const double h = 1e-6;
  const auto gradient = [&](double step) -> Eigen::VectorXd
  {
    EnergyPoint moved(problem, at.moved(step * y));
    moved.frames = at.frames;
    // Gradients in the frames of the first point.
    const BasisTable& table = space.table();
    CurvatureDensity density = moved.membrane.density;
    density.value.array() += multipliers.tension;
    return moved.in_frames(curvature_gradient(table, moved.surface, density) -
      multipliers.pressure * volume_gradient(table, moved.surface.points));
  };
  const Eigen::VectorXd change = (gradient(h) - gradient(-h)) / (2 * h);
  const Eigen::SparseMatrix<double> H =
    at.lagrangian_hessian(SecondVariation(space.table()), multipliers);
  const Eigen::VectorXd product = H.selfadjointView<Eigen::Lower>() * y;
  EXPECT_LT((change - product).norm(), 1e-6 * product.norm());
}

// The energy that is searched is the one that runs report, and its gradient too.
TEST(CurvatureEnergy, IsTheTerms)
{
  TriangleMesh mesh = test::smooth_sphere(320);
  mesh.points = (mesh.points * Eigen::Vector3d(1.3, 1.1, 0.8).asDiagonal()).eval();
  const SurfaceSpace space(
    SurfaceBasis::loop, mesh.triangles, static_cast<int>(mesh.points.rows()));
  const Surface surface(space, mesh.points);
  std::vector<std::unique_ptr<const MembraneTerm>> all;
  all.push_back(make_bending(space, 0));
  all.push_back(make_bending(space, -1.2));
  all.push_back(std::make_unique<AreaDifference>(1.4, 1.2));
  for (const auto& term : all)
  {
    const CurvedPoints points(space.table(), surface.control);
    CurvatureEnergy sum(space.table().rows());
    term->add_curvature_energy(points, sum);
    EXPECT_NEAR(sum.energy, term->energy(surface), 1e-12 * sum.energy);
    const Eigen::VectorXd gradient = curvature_gradient(space.table(), points, sum.density),
                          exact = term->variation(surface).gradient;
    EXPECT_LT((gradient - exact).norm(), 1e-11 * exact.norm());
  }
}

}
}
