// The mesh's own motion: along the surface, without area or volume, never up in energy by more than
// half of what the fluid takes.

#include "solver/dynamics/TangentialMotion.h"

#include "solver/dynamics/SystemShape.h"
#include "solver/membrane/HelfrichBending.h"
#include "tests/solver/support/TestMeshes.h"

#include <gtest/gtest.h>

namespace vesicle
{
namespace
{

class Sliding : public testing::TestWithParam<double> // τ
{
};

TEST_P(Sliding, IsNeutralAndNeverClimbs)
{
  const double tau = GetParam();
  for (const bool bends : { true, false })
  {
    const TriangleMesh mesh = test::mapped(test::smooth_sphere(320), test::ellipsoid_2_1_1);
    System system;
    system.vesicles.push_back(
      make_vesicle(SurfaceBasis::loop, mesh.triangles, static_cast<int>(mesh.points.rows()), 3));
    Vesicle& vesicle = system.vesicles.front();
    if (bends)
      vesicle.terms.push_back(make_bending(*vesicle.space, 0));
    const SystemShape shape(system, { mesh.points });
    const VesicleLoads& loads = *shape.vesicles[0].loads;
    const Surface& surface = loads.surface();
    // A strong wish against the mesh's order.
    Points wanted(mesh.points.rows(), 3);
    for (Eigen::Index i = 0; i < wanted.rows(); ++i)
    {
      const Eigen::RowVector3d n = surface.normals.row(i), w(std::sin(3. * i), std::cos(5. * i), 1);
      wanted.row(i) = 10 * (w - w.dot(n) * n);
    }
    const Eigen::VectorXd still = Eigen::VectorXd::Zero(3 * wanted.rows());
    const TangentialMotion sliding(loads, tau, 0.02);
    for (const double released : { 0., 5. })
    {
      const Eigen::VectorXd t = sliding.velocities(flat(wanted), still, released);
      const Eigen::VectorXd c = surface.to_control(t);
      EXPECT_LT(
        surface.normals.cwiseProduct(rows_of_three(t)).rowwise().sum().cwiseAbs().maxCoeff(),
        1e-12 * t.norm());
      EXPECT_LT(std::abs(loads.area_gradient().dot(c)), 1e-10 * t.norm());
      EXPECT_LT(std::abs(loads.volume_gradient().dot(c)), 1e-10 * t.norm());
      EXPECT_LE(loads.gradient().dot(c), released / 2 + 1e-9 * loads.gradient().norm() * c.norm());
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Steps, Sliding, testing::Values(0., 1e-6, 1e-2, 1.),
  [](const auto& step) { return "number" + std::to_string(step.index); });

}
}
