// Not covered: pointwise convergence of Δ_s H, which the cotan scheme doesn't have at vertices of
// valence other than six or on irregular meshes; weak convergence is tested with the bending force.
#include "solver/mesh/shapes/GeodesicSphere.h"
#include "solver/surface/Cotan.h"
#include "tests/solver/support/CotanCase.h"
#include "tests/solver/support/TestMeshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vesicle
{
namespace
{

using test::jittered_sphere;
using test::mapped;

struct Case : test::CotanCase
{
  using CotanCase::CotanCase;
  // Area-weighted L2 mean of a nodal error.
  double norm(const Eigen::VectorXd& f) const
  {
    return std::sqrt(geometry.vertex_area.dot(f.cwiseAbs2()) / geometry.vertex_area.sum());
  }
};

TEST(Cotan, LaplacianHasConstantsInItsNullSpaceAndIsSymmetric)
{
  const Case c(mapped(jittered_sphere(4, 0.25), test::ellipsoid_2_1_1));
  const auto n = c.mesh.points.rows();
  EXPECT_LT((c.geometry.laplacian * Eigen::VectorXd::Ones(n)).cwiseAbs().maxCoeff(), 1e-11);
  const Eigen::MatrixXd stiffness =
    c.geometry.vertex_area.asDiagonal() * Eigen::MatrixXd(c.geometry.laplacian);
  EXPECT_LT((stiffness - stiffness.transpose()).cwiseAbs().maxCoeff(), 1e-13);
}

TEST(Cotan, UnitSphereHasUnitCurvatures)
{
  for (NormalScheme scheme : { NormalScheme::area_weighted, NormalScheme::curvature })
  {
    const Case c(geodesic_sphere(8), scheme);
    EXPECT_NEAR(c.norm(c.curvature.mean), 1, 0.01);
    EXPECT_GT(c.curvature.mean.minCoeff(), 0) << "H = +1/R with n outward";
    EXPECT_GT((c.curvature.normal.cwiseProduct(c.mesh.points)).rowwise().sum().minCoeff(), 0.99);
  }
}

TEST(Cotan, GaussBonnet)
{
  const Case sphere(mapped(jittered_sphere(4, 0.25), test::paper_surface));
  EXPECT_NEAR(sphere.geometry.vertex_area.dot(sphere.curvature.gauss), 4 * std::numbers::pi, 1e-11);
  const Case torus(test::clifford_torus(24, 16));
  EXPECT_NEAR(torus.geometry.vertex_area.dot(torus.curvature.gauss), 0, 1e-11);
}

// Against data/reference/surfaces: on surfaces of revolution curvature depends on one coordinate.
TEST(Cotan, MeanCurvatureConvergesToTheReference)
{
  const auto reference = test::read_reference("surfaces/ellipsoid_prolate_2_1_1.csv");
  std::vector<double> along;
  for (double x : reference.at("x"))
    along.push_back(std::abs(x));
  double error[2];
  for (int level = 0; level < 2; ++level)
  {
    const Case c(mapped(geodesic_sphere(level == 0 ? 6 : 12), test::ellipsoid_2_1_1));
    Eigen::VectorXd difference(c.mesh.points.rows());
    for (int i = 0; i < difference.size(); ++i)
      difference[i] = c.curvature.mean[i] -
        test::interpolate(along, reference.at("H"), std::abs(c.mesh.points(i, 0)));
    error[level] = c.norm(difference);
  }
  EXPECT_LT(error[1], 0.02);
  EXPECT_GT(test::order(error[0], error[1]), 1) << error[0] << " " << error[1];
}

TEST(Cotan, DimplesKeepOutwardNormals)
{
  // A disc with a deep dimple on either side: H < 0 at the poles.
  const auto dimple = [](const Vector3& d) -> Vector3
  {
    const double rho2 = d.x() * d.x() + d.y() * d.y();
    return { 1.4 * d.x(), 1.4 * d.y(), d.z() * (0.2 + 0.8 * rho2) };
  };
  for (NormalScheme scheme : { NormalScheme::area_weighted, NormalScheme::curvature })
  {
    const Case c(mapped(geodesic_sphere(10), dimple), scheme);
    EXPECT_LT(c.curvature.mean.minCoeff(), -0.1);
    const Eigen::VectorXd outward =
      c.curvature.normal.cwiseProduct(c.geometry.vertex_normal).rowwise().sum();
    EXPECT_GT(outward.minCoeff(), 0);
  }
}

TEST(Cotan, SurfaceDivergenceOfALinearFieldOnTheSphere)
{
  // u = x: ∇_s·u = 2 on any surface, exactly on flat triangles.
  const Case c(jittered_sphere(4, 0.25));
  const BasisTable table = tabulate_rule(
    LinearBasis(c.mesh.triangles, static_cast<int>(c.mesh.points.rows())), triangle_rule(3));
  const SparseMatrix B = area_rate_matrix(table, evaluate(table, c.mesh.points));
  const Eigen::VectorXd x =
    Eigen::Map<const Eigen::VectorXd>(c.mesh.points.data(), c.mesh.points.size());
  const Eigen::VectorXd divergence = surface_divergence_matrix(c.geometry, B) * x;
  EXPECT_LT((divergence.array() - 2).abs().maxCoeff(), 1e-12);
}

TEST(Cotan, TensionForceOfAUniformTensionIsTheCurvatureForce)
{
  // γ = 1: F = −2 H n = L x exactly; γ = z on the unit sphere: F = e_z − z n − 2 z n.
  const Case c(geodesic_sphere(8));
  const SparseMatrix F =
    tension_force_matrix(c.geometry, c.mesh.points, c.mesh.triangles, c.geometry.vertex_normal);
  const auto n = c.mesh.points.rows();
  const Points vector = c.geometry.laplacian * c.mesh.points;
  EXPECT_LT((F * Eigen::VectorXd::Ones(n) - Eigen::Map<const Eigen::VectorXd>(vector.data(), 3 * n))
              .cwiseAbs()
              .maxCoeff(),
    1e-12);
  const Eigen::VectorXd force = F * c.mesh.points.col(2);
  double error = 0, size = 0;
  for (int i = 0; i < n; ++i)
  {
    const Vector3 x = c.mesh.points.row(i), exact = Vector3::UnitZ() - 3 * x.z() * x;
    error += (force.segment<3>(3 * i) - exact).squaredNorm();
    size += exact.squaredNorm();
  }
  EXPECT_LT(std::sqrt(error / size), 0.02);
}

}
}
