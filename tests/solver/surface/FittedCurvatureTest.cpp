// Meshes of segmented images: tests/vtkfilters/CurvatureFilterTest.cpp.
#include "solver/surface/FittedCurvature.h"
#include "solver/Errors.h"
#include "solver/membrane/HelfrichBending.h"
#include "solver/mesh/shapes/GeodesicSphere.h"
#include "solver/stokes/BendingVelocityError.h"
#include "solver/surface/ExactCurvature.h"
#include "solver/state/Table.h"
#include "tests/solver/support/TestMeshes.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace vesicle
{
namespace
{

using test::jittered_sphere;
using test::mapped;

/// The geodesic sphere with a point in every triangle: valences 3 and 12 (10 at the twelve
/// corners).
TriangleMesh stellated_sphere(int n)
{
  const TriangleMesh old = jittered_sphere(n, 0.2);
  const auto points = old.points.rows(), count = old.triangles.rows();
  TriangleMesh mesh{ Points(points + count, 3), Triangles(3 * count, 3) };
  mesh.points.topRows(points) = old.points;
  for (int e = 0; e < count; ++e)
  {
    const auto t = old.triangles.row(e);
    const int middle = static_cast<int>(points) + e;
    mesh.points.row(middle) =
      (old.points.row(t[0]) + old.points.row(t[1]) + old.points.row(t[2])).normalized();
    mesh.triangles.row(3 * e) << t[0], t[1], middle;
    mesh.triangles.row(3 * e + 1) << t[1], t[2], middle;
    mesh.triangles.row(3 * e + 2) << t[2], t[0], middle;
  }
  return mesh;
}

struct Exact
{
  Vector3 normal;
  double mean, gauss, laplacian_mean;
  double density() const { return 2 * laplacian_mean + 4 * mean * (mean * mean - gauss); }
};

/// The spheroid x = a s, ρ = b √(1 − s²) with q = a² − (a² − b²) s²: the principal curvatures are
/// a b q^{−3/2} along the meridian and (a/b) q^{−1/2} around, and Δ_s f = q^{−1/2} d/ds[(1 − s²)
/// q^{−1/2} df/ds] for f(s).
Exact spheroid(const Vector3& x)
{
  const double a = 2, b = 1, c = a * a - b * b, s = x[0] / a, q = a * a - c * s * s;
  const double along = a * b * std::pow(q, -1.5), around = a / b / std::sqrt(q);
  // (1 − s²) q^{−1/2} dH/ds = c (s − s³) p, p = 3ab/(2q³) + a/(2b q²), dq/ds = −2cs.
  const double p = 1.5 * a * b / std::pow(q, 3) + 0.5 * a / b / (q * q);
  const double p_s = 2 * c * s * (4.5 * a * b / std::pow(q, 4) + a / b / std::pow(q, 3));
  const Vector3 normal(x[0] / (a * a), x[1] / (b * b), x[2] / (b * b));
  return { normal.normalized(), 0.5 * (along + around), along * around,
    c * ((1 - 3 * s * s) * p + (s - s * s * s) * p_s) / std::sqrt(q) };
}

void record(const std::string& name, double value)
{
  testing::Test::RecordProperty(name, std::to_string(value));
}

double velocity_error(const TriangleMesh& sphere)
{
  const TriangleMesh mesh = mapped(sphere, test::ellipsoid_2_1_1);
  return bending_velocity_error(
    mesh, ellipsoid_2_1_1_level_set(), fitted_curvature(mesh).curvature);
}

TEST(FittedCurvature, VelocityErrorOnTheEllipsoid)
{
  const auto check = [](const char* name, const TriangleMesh& sphere, double limit)
  {
    const double error = velocity_error(sphere);
    record(name, error);
    EXPECT_LT(error, limit) << name;
  };
  check("regular_320", geodesic_sphere(4), 0.08);
  check("regular_1280", geodesic_sphere(8), 6e-3);
  check("regular_5120", geodesic_sphere(16), 1e-3);
  check("delaunay_320", delaunay_sphere(jittered_sphere(4, 0.3)), 0.2);
  check("delaunay_1280", delaunay_sphere(jittered_sphere(8, 0.3)), 0.03);
  check("delaunay_5120", delaunay_sphere(jittered_sphere(16, 0.3)), 6e-3);
  check("jittered_1280", jittered_sphere(8, 0.3), 0.03);
  check("jittered_5120", jittered_sphere(16, 0.3), 6e-3);
  check("valence_3_and_12_1500", stellated_sphere(5), 0.03);
  check("valence_3_and_12_4860", stellated_sphere(9), 6e-3);
}

/// Root mean square errors over the vertices (border: those alone), relative to the exact values'.
struct Errors
{
  double mean = 0, laplacian = 0;
};
Errors errors_on(const TriangleMesh& mesh, const FittedCurvature& fit, bool border,
  const std::function<Exact(const Vector3&)>& surface)
{
  Errors error, size;
  for (int i = 0; i < mesh.points.rows(); ++i)
  {
    if (fit.degree[i] == 0 || (fit.border[i] != 0) != border)
    {
      continue;
    }
    const Exact exact = surface(mesh.points.row(i));
    error.mean += std::pow(fit.curvature.mean[i] - exact.mean, 2);
    error.laplacian += std::pow(fit.curvature.laplacian_mean[i] - exact.laplacian_mean, 2);
    size.mean += std::pow(exact.mean, 2);
    size.laplacian += std::pow(exact.laplacian_mean, 2);
  }
  return { std::sqrt(error.mean / size.mean), std::sqrt(error.laplacian / size.laplacian) };
}

TEST(FittedCurvature, ConvergesPointwiseOnIrregularMeshes)
{
  // The cotan scheme's Δ_s H does not converge here.
  Errors error[2];
  for (int level = 0; level < 2; ++level)
  {
    const TriangleMesh mesh =
      mapped(jittered_sphere(level == 0 ? 8 : 16, 0.3), test::ellipsoid_2_1_1);
    const FittedCurvature fit = fitted_curvature(mesh);
    EXPECT_EQ(fit.degree.minCoeff(), 4);
    EXPECT_EQ(std::count(fit.border.begin(), fit.border.end(), 0), mesh.points.rows());
    error[level] = errors_on(mesh, fit, false, spheroid);
  }
  record("H_1280", error[0].mean);
  record("H_5120", error[1].mean);
  record("LapH_1280", error[0].laplacian);
  record("LapH_5120", error[1].laplacian);
  EXPECT_LT(error[1].mean, 5e-4);
  EXPECT_LT(error[1].laplacian, 0.05);
  EXPECT_GT(test::order(error[0].mean, error[1].mean), 2.5);
  EXPECT_GT(test::order(error[0].laplacian, error[1].laplacian), 1);
}

TEST(FittedCurvature, CliffordTorusIsInEquilibrium)
{
  // ρ = √2 + cos v: H = (1 + cos v/ρ)/2, K = cos v/ρ and 2 Δ_s H + 4H(H² − K) = 0.
  const auto torus = [](const Vector3& x) -> Exact
  {
    const double rho = std::hypot(x[0], x[1]), gauss = (rho - std::numbers::sqrt2) / rho;
    const double mean = 0.5 * (1 + gauss);
    return { {}, mean, gauss, -2 * mean * (mean * mean - gauss) };
  };
  double force[2];
  for (int level = 0; level < 2; ++level)
  {
    const TriangleMesh mesh = test::clifford_torus(48 << level, 32 << level);
    const FittedCurvature fit = fitted_curvature(mesh);
    const Errors error = errors_on(mesh, fit, false, torus);
    record("H_" + std::to_string(mesh.triangles.rows()), error.mean);
    record("LapH_" + std::to_string(mesh.triangles.rows()), error.laplacian);
    EXPECT_LT(error.mean, level == 0 ? 2e-3 : 3e-4);
    EXPECT_LT(error.laplacian, level == 0 ? 0.05 : 0.01);
    force[level] = bending_density(fit.curvature).norm() / std::sqrt(1. * mesh.points.rows());
  }
  EXPECT_LT(force[1], 0.02);
  EXPECT_GT(test::order(force[0], force[1]), 1.5);
}

TEST(FittedCurvature, SphereOfAnyRadius)
{
  const double radius = 3e-6;
  TriangleMesh mesh = geodesic_sphere(8);
  mesh.points = (radius * mesh.points).rowwise() + Eigen::RowVector3d(1e-3, 0, -1e-3);
  const Curvature c = fitted_curvature(mesh).curvature;
  EXPECT_LT((radius * c.mean.array() - 1).abs().maxCoeff(), 1e-3) << "H = +1/R with n outward";
  EXPECT_LT((radius * radius * c.gauss.array() - 1).abs().maxCoeff(), 2e-3);
  EXPECT_LT(std::pow(radius, 3) * c.laplacian_mean.cwiseAbs().maxCoeff(), 0.02);
}

/// A disc of rings around the origin, unevenly spread but even under (x, y) → (−x, −y), so that the
/// normal at the origin is e_z for an even height.
TriangleMesh uneven_disc(const std::function<double(double, double)>& height)
{
  constexpr int half = 4, around = 2 * half, rings = 4;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> shift(-0.3, 0.3);
  TriangleMesh mesh{ Points::Zero(1 + rings * around, 3), Triangles(around * (2 * rings - 1), 3) };
  const auto index = [](int ring, int j) { return 1 + ring * around + j % around; };
  for (int ring = 0; ring < rings; ++ring)
    for (int j = 0; j < half; ++j)
    {
      const double r = 0.2 * (ring + 1 + shift(random));
      const double angle = std::numbers::pi / half * (j + shift(random));
      const double x = r * std::cos(angle), y = r * std::sin(angle);
      mesh.points.row(index(ring, j)) << x, y, height(x, y);
      mesh.points.row(index(ring, j + half)) << -x, -y, height(-x, -y);
    }
  int t = 0;
  for (int j = 0; j < around; ++j)
  {
    mesh.triangles.row(t++) << 0, index(0, j), index(0, j + 1);
    for (int ring = 1; ring < rings; ++ring)
    {
      mesh.triangles.row(t++) << index(ring - 1, j), index(ring, j), index(ring, j + 1);
      mesh.triangles.row(t++) << index(ring - 1, j), index(ring, j + 1), index(ring - 1, j + 1);
    }
  }
  return mesh;
}

TEST(FittedCurvature, ReproducesAQuarticHeight)
{
  const TriangleMesh mesh = uneven_disc(
    [](double x, double y)
    {
      return -0.7 * x * x + 0.4 * x * y + 0.2 * y * y + 0.5 * x * x * x * x - 0.3 * x * x * x * y +
        0.8 * x * x * y * y + 0.1 * x * y * y * y - 0.6 * y * y * y * y;
    });
  const FittedCurvature fit = fitted_curvature(mesh);
  EXPECT_EQ(fit.degree[0], 4);
  EXPECT_FALSE(fit.border[0]);
  EXPECT_NEAR(fit.curvature.mean[0], 0.5, 1e-10); // −½ (z_xx + z_yy)
  EXPECT_NEAR(fit.curvature.gauss[0], -1.4 * 0.4 - 0.16, 1e-10);
  EXPECT_LT(fit.residual[0], 1e-10);
}

TEST(FittedCurvature, FlatPlate)
{
  const TriangleMesh mesh = uneven_disc([](double, double) { return 0; });
  const FittedCurvature fit = fitted_curvature(mesh);
  EXPECT_LT(fit.curvature.mean.cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT(fit.curvature.gauss.cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT(fit.curvature.laplacian_mean.cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_GT(fit.curvature.normal.col(2).minCoeff(), 1 - 1e-12);
  EXPECT_EQ(std::count(fit.border.begin(), fit.border.end(), 1), 8) << "the last ring";
}

// The surface of the paper's 4.1 (smooth variant): nodes on its section z = 0, where the map keeps
// them, against the reference there.
Errors paper_section_errors(const TriangleMesh& sphere)
{
  const auto reference = test::read_reference("surfaces/paper41_smooth_z0.csv");
  const double step = reference.at("theta")[1];
  const TriangleMesh mesh = mapped(sphere, test::paper_surface);
  const Curvature c = fitted_curvature(mesh).curvature;
  Errors error, size;
  for (int i = 0; i < mesh.points.rows(); ++i)
  {
    if (std::abs(mesh.points(i, 2)) > 1e-12)
    {
      continue;
    }
    double angle = std::atan2(mesh.points(i, 1), mesh.points(i, 0));
    angle += angle < 0 ? 2 * std::numbers::pi : 0;
    const double mean = periodic_cubic(reference.at("H"), step, angle);
    const double laplacian = periodic_cubic(reference.at("LapH"), step, angle);
    error.mean += std::pow(c.mean[i] - mean, 2);
    error.laplacian += std::pow(c.laplacian_mean[i] - laplacian, 2);
    size.mean += mean * mean;
    size.laplacian += laplacian * laplacian;
  }
  return { std::sqrt(error.mean / size.mean), std::sqrt(error.laplacian / size.laplacian) };
}

TEST(FittedCurvature, PaperSurfaceSection)
{
  const Errors coarse = paper_section_errors(geodesic_sphere(16));
  const Errors fine = paper_section_errors(geodesic_sphere(32));
  record("H_5120", coarse.mean);
  record("H_20480", fine.mean);
  record("LapH_5120", coarse.laplacian);
  record("LapH_20480", fine.laplacian);
  EXPECT_GT(test::order(coarse.mean, fine.mean), 2.5);
  EXPECT_GT(test::order(coarse.laplacian, fine.laplacian), 1.5);
  EXPECT_LT(fine.mean, 4e-4);
  EXPECT_LT(fine.laplacian, 0.01);
}

TEST(FittedCurvature, InvariantUnderMotionScalingAndRenumbering)
{
  const TriangleMesh mesh = mapped(jittered_sphere(5, 0.3), test::paper_surface);
  const Curvature c = fitted_curvature(mesh).curvature;
  auto [moved, order] = test::renumbered(mesh);
  const double scale = 2e-6;
  const Eigen::Matrix3d rotation =
    Eigen::AngleAxisd(1.1, Vector3(1, 2, -3).normalized()).toRotationMatrix();
  moved.points =
    (scale * moved.points * rotation.transpose()).rowwise() + Eigen::RowVector3d(3e-6, -2e-6, 5e-6);
  const Curvature m = fitted_curvature(moved).curvature;
  for (int i = 0; i < mesh.points.rows(); ++i)
  {
    const int j = order[i];
    EXPECT_NEAR(scale * m.mean[i], c.mean[j], 1e-8);
    EXPECT_NEAR(scale * scale * m.gauss[i], c.gauss[j], 1e-8);
    EXPECT_NEAR(std::pow(scale, 3) * m.laplacian_mean[i], c.laplacian_mean[j], 1e-6);
    EXPECT_LT(
      (rotation.transpose() * m.normal.row(i).transpose() - c.normal.row(j).transpose()).norm(),
      1e-9);
  }
}

TEST(FittedCurvature, DoesNotDependOnTheNumberOfThreads)
{
  const TriangleMesh mesh = mapped(jittered_sphere(5, 0.3), test::ellipsoid_2_1_1);
  const FittedCurvature many = fitted_curvature(mesh);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const FittedCurvature single = fitted_curvature(mesh);
  EXPECT_EQ(many.curvature.mean, single.curvature.mean);
  EXPECT_EQ(many.curvature.gauss, single.curvature.gauss);
  EXPECT_EQ(many.curvature.normal, single.curvature.normal);
  EXPECT_EQ(many.curvature.laplacian_mean, single.curvature.laplacian_mean);
  EXPECT_EQ(many.residual, single.residual);
}

TEST(FittedCurvature, TellsItsProgressAndCanBeEnded)
{
  const TriangleMesh mesh = geodesic_sphere(50); // some blocks of vertices
  const Connectivity connectivity(mesh.triangles, static_cast<int>(mesh.points.rows()));
  std::vector<double> shares;
  fitted_curvature(mesh, connectivity, {}, [&](double share) { shares.push_back(share); });
  EXPECT_GT(shares.size(), 4U);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_EQ(shares.back(), 1);
  const auto stop = [](double) { throw std::runtime_error("stop"); };
  EXPECT_THROW(fitted_curvature(mesh, connectivity, {}, stop), std::runtime_error);
}

FittedCurvature fitted_at(const TriangleMesh& mesh, double radius)
{
  return fitted_curvature(
    mesh, { mesh.triangles, static_cast<int>(mesh.points.rows()) }, { radius, true });
}

// Smooth: what is left is the bias, of second order in the radius but on spheres and cylinders.
TEST(FittedCurvature, AtALengthScale)
{
  const auto bias = [](double radius)
  {
    const TriangleMesh mesh = mapped(jittered_sphere(32, 0.3), test::ellipsoid_2_1_1);
    const FittedCurvature fit = fitted_at(mesh, radius);
    EXPECT_EQ(fit.degree, Eigen::VectorXi::Constant(mesh.points.rows(), 2));
    return errors_on(mesh, fit, false, spheroid);
  };
  const Errors wide = bias(0.4), narrow = bias(0.2);
  record("H_0.4", wide.mean);
  record("H_0.2", narrow.mean);
  record("LapH_0.2", narrow.laplacian);
  EXPECT_LT(narrow.mean, 0.03);
  EXPECT_GT(test::order(wide.mean, narrow.mean), 1.5);
  EXPECT_GT(test::order(wide.laplacian, narrow.laplacian), 1);
  const FittedCurvature sphere = fitted_at(geodesic_sphere(32), 0.5);
  EXPECT_LT((sphere.curvature.mean.array() - 1).abs().maxCoeff(), 1e-3);
}

TEST(FittedCurvature, AtALengthScaleIsInvariantUnderMotionAndScaling)
{
  const TriangleMesh mesh = mapped(jittered_sphere(12, 0.3), test::paper_surface);
  const FittedCurvature fit = fitted_at(mesh, 0.5);
  const double scale = 2e-6;
  const Eigen::Matrix3d rotation =
    Eigen::AngleAxisd(1.1, Vector3(1, 2, -3).normalized()).toRotationMatrix();
  TriangleMesh moved = mesh;
  moved.points =
    (scale * mesh.points * rotation.transpose()).rowwise() + Eigen::RowVector3d(3e-6, -2e-6, 5e-6);
  const FittedCurvature m = fitted_at(moved, scale * 0.5);
  EXPECT_LT((scale * m.curvature.mean - fit.curvature.mean).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT((scale * m.mean_error - fit.mean_error).cwiseAbs().maxCoeff(), 1e-9);
  for (int i = 0; i < mesh.points.rows(); ++i)
  {
    const Vector3 turned = rotation * fit.direction.row(i).transpose();
    EXPECT_LT(m.direction.row(i).transpose().cross(turned).norm(), 1e-6);
  }
}

TEST(FittedCurvature, AtALengthScaleDoesNotDependOnTheNumberOfThreads)
{
  const TriangleMesh mesh = mapped(jittered_sphere(12, 0.3), test::paper_surface);
  const FittedCurvature many = fitted_at(mesh, 0.3);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const FittedCurvature single = fitted_at(mesh, 0.3);
  EXPECT_EQ(many.curvature.mean, single.curvature.mean);
  EXPECT_EQ(many.curvature.gauss, single.curvature.gauss);
  EXPECT_EQ(many.curvature.laplacian_mean, single.curvature.laplacian_mean);
  EXPECT_EQ(many.direction, single.direction);
  EXPECT_EQ(many.mean_error, single.mean_error);
}

// A disc of thickness 0.1 and rim radius 1: the other side is within the radius and doesn't count.
TEST(FittedCurvature, AtALengthScaleSidesOfAThinSheetAreApart)
{
  const TriangleMesh mesh = mapped(geodesic_sphere(32),
    [](const Vector3& x) -> Vector3 {
      return { x[0], x[1], 0.05 * x[2] };
    });
  const FittedCurvature fit = fitted_at(mesh, 0.3);
  for (int i = 0; i < mesh.points.rows(); ++i)
  {
    if (mesh.points.row(i).head<2>().norm() < 0.5)
    {
      // The ellipsoid's H is 0.05 on the axis and 0.1 at 0.5.
      EXPECT_GT(fit.curvature.mean[i], 0.04);
      EXPECT_LT(fit.curvature.mean[i], 0.15);
      EXPECT_GT(fit.curvature.normal(i, 2) * mesh.points(i, 2), 0);
    }
  }
}

TEST(FittedCurvature, BelowTheMeshsLengthScaleTheNearestStandIn)
{
  const TriangleMesh mesh = mapped(jittered_sphere(5, 0.3), test::ellipsoid_2_1_1);
  const FittedCurvature nearest = fitted_curvature(mesh), fit = fitted_at(mesh, 0.05);
  EXPECT_EQ(fit.degree, nearest.degree);
  EXPECT_EQ(fit.curvature.mean, nearest.curvature.mean);
  EXPECT_EQ(fit.curvature.laplacian_mean, nearest.curvature.laplacian_mean);
}

TEST(FittedCurvature, ARadiusAsLargeAsTheMeshIsAnError)
{
  EXPECT_THROW(fitted_at(geodesic_sphere(4), 2), InputError);
}

bool all_finite(const FittedCurvature& fit)
{
  const Curvature& c = fit.curvature;
  return c.normal.allFinite() && c.mean.allFinite() && c.gauss.allFinite() &&
    c.laplacian_mean.allFinite() && fit.residual.allFinite();
}

/// The triangles whose corners all satisfy z + 0.3 x > −0.2; the other points stay, unused.
TriangleMesh opened(const TriangleMesh& mesh)
{
  std::vector<int> kept;
  const auto inside = [&](int i) { return mesh.points(i, 2) + 0.3 * mesh.points(i, 0) > -0.2; };
  for (int t = 0; t < mesh.triangles.rows(); ++t)
  {
    const auto corners = mesh.triangles.row(t);
    if (std::all_of(corners.begin(), corners.end(), inside))
    {
      kept.push_back(t);
    }
  }
  return { mesh.points, mesh.triangles(kept, Eigen::all) };
}

TEST(FittedCurvature, OpenBorder)
{
  Errors inner[2], border[2];
  for (int level = 0; level < 2; ++level)
  {
    const TriangleMesh mesh =
      opened(mapped(geodesic_sphere(level == 0 ? 8 : 16), test::ellipsoid_2_1_1));
    const FittedCurvature fit = fitted_curvature(mesh);
    EXPECT_TRUE(all_finite(fit));
    for (int i = 0; i < mesh.points.rows(); ++i)
    {
      const bool used = (mesh.triangles.array() == i).any();
      EXPECT_EQ(fit.degree[i] > 0, used);
      EXPECT_TRUE(used ||
        (!fit.border[i] && fit.curvature.mean[i] == 0 && fit.curvature.normal.row(i).isZero(0)));
    }
    inner[level] = errors_on(mesh, fit, false, spheroid);
    border[level] = errors_on(mesh, fit, true, spheroid);
  }
  record("H_inside", inner[1].mean);
  record("H_border", border[1].mean);
  record("LapH_inside", inner[1].laplacian);
  record("LapH_border", border[1].laplacian);
  EXPECT_LT(inner[1].mean, 1e-3);
  EXPECT_LT(inner[1].laplacian, 0.05);
  EXPECT_LT(border[1].mean, 5e-3);
  EXPECT_LT(border[1].laplacian, 2); // no figure to use, but bounded
  EXPECT_GT(test::order(border[0].mean, border[1].mean), 1.5);
}

/// Tetrahedron, octahedron, icosahedron on the unit sphere.
TriangleMesh tetrahedron()
{
  TriangleMesh mesh{ Points(4, 3), Triangles(4, 3) };
  mesh.points << 1, 1, 1, -1, -1, 1, -1, 1, -1, 1, -1, -1;
  mesh.points /= std::sqrt(3.);
  mesh.triangles << 0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3;
  return mesh;
}

TriangleMesh octahedron()
{
  TriangleMesh mesh{ Points(6, 3), Triangles(8, 3) };
  mesh.points << 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1;
  mesh.triangles << 0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5;
  return mesh;
}

TEST(FittedCurvature, TinyMeshesOfTheSphere)
{
  const auto check = [](const TriangleMesh& mesh, int degree)
  {
    const FittedCurvature fit = fitted_curvature(mesh);
    EXPECT_EQ(fit.degree.minCoeff(), degree);
    EXPECT_EQ(fit.degree.maxCoeff(), degree);
    EXPECT_LT((fit.curvature.mean.array() - 1).abs().maxCoeff(), 1e-12);
    EXPECT_LT((fit.curvature.gauss.array() - 1).abs().maxCoeff(), 1e-12);
    EXPECT_LT(fit.curvature.laplacian_mean.cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_LT((fit.curvature.normal - mesh.points).cwiseAbs().maxCoeff(), 1e-12);
  };
  check(tetrahedron(), 1);
  check(octahedron(), 1);
  check(geodesic_sphere(1), 2);
}

TEST(FittedCurvature, DefectsGiveFiniteValues)
{
  TriangleMesh mesh = geodesic_sphere(3);
  mesh.points.row(5) = mesh.points.row(mesh.triangles(0, 0)); // coincident points
  const auto count = mesh.triangles.rows(), points = mesh.points.rows();
  mesh.points.conservativeResize(points + 4, 3);
  mesh.points.bottomRows(4) << 2, 0, 0, 3, 0, 0, 4, 0, 0, 9, 9, 9;
  mesh.triangles.conservativeResize(count + 4, 3);
  const int p = static_cast<int>(points);
  mesh.triangles.bottomRows(4) << 0, 1, p, // a fin on an edge or diagonal
    p, p + 1, p + 2,                       // no area
    3, 3, 4,                               // one corner twice
    p + 2, p + 1, p;
  const FittedCurvature fit = fitted_curvature(mesh);
  EXPECT_TRUE(all_finite(fit));
  EXPECT_EQ(fit.degree[p + 3], 0) << "without triangles";
  EXPECT_EQ(fit.degree[p + 1], 0) << "triangles without area";
  EXPECT_TRUE(all_finite(fitted_curvature({ Points::Zero(3, 3), Triangles::Zero(1, 3) })));
  EXPECT_TRUE(all_finite(fitted_curvature({ Points(0, 3), Triangles(0, 3) })));
  TriangleMesh two_sided = tetrahedron(); // a triangle and its reverse: the normals cancel
  two_sided.triangles.resize(2, 3);
  two_sided.triangles << 0, 1, 2, 2, 1, 0;
  const FittedCurvature flat = fitted_curvature(two_sided);
  EXPECT_TRUE(all_finite(flat));
  EXPECT_EQ(flat.degree.maxCoeff(), 0);
}

TEST(FittedCurvature, FoldAlongOneEdge)
{
  TriangleMesh mesh{ Points(4, 3), Triangles(2, 3) };
  mesh.points << 0, 0, 0, 1, 0, 0, 0.5, 1, 0.7, 0.5, -1, 0.7;
  mesh.triangles << 0, 1, 2, 1, 0, 3;
  const FittedCurvature fit = fitted_curvature(mesh);
  EXPECT_TRUE(all_finite(fit));
  EXPECT_LT(fit.curvature.mean.cwiseAbs().maxCoeff(), 10);
  EXPECT_LT(fit.curvature.mean[0], 0) << "a valley";
}

TEST(FittedCurvature, SingleTriangleIsFlat)
{
  TriangleMesh mesh{ Points(3, 3), Triangles(1, 3) };
  mesh.points << 0, 0, 1, 1, 0, 1, 0, 1, 1;
  mesh.triangles << 0, 1, 2;
  const FittedCurvature fit = fitted_curvature(mesh);
  EXPECT_TRUE(all_finite(fit));
  EXPECT_EQ(fit.degree, Eigen::VectorXi::Ones(3));
  EXPECT_LT(fit.curvature.mean.cwiseAbs().maxCoeff(), 1e-15);
  EXPECT_EQ(fit.border, std::vector<char>(3, 1));
}

}
}
