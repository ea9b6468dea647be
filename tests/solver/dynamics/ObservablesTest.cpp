#include "solver/dynamics/Observables.h"
#include "solver/dynamics/LumpedForces.h"
#include "solver/linear/SparseCholesky.h"
#include "solver/membrane/HelfrichBending.h"
#include "solver/mesh/shapes/GeodesicSphere.h"
#include "solver/mesh/shapes/SphericalHarmonics.h"
#include "tests/solver/dynamics/SurfaceCase.h"
#include "tests/solver/support/TestMeshes.h"

#include <gtest/gtest.h>

#include <numbers>

namespace vesicle
{
namespace
{

using test::mapped;
using test::SurfaceCase;

TriangleMesh turned_ellipsoid(double degrees)
{
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(-degrees * std::numbers::pi / 180, Vector3::UnitY()).toRotationMatrix();
  return mapped(geodesic_sphere(8),
    [&](const Vector3& d) -> Vector3
    { return turn * Vector3(1.5 * d.x(), 1.1 * d.y(), 0.8 * d.z()); });
}

InertiaEllipsoid ellipsoid_of(const TriangleMesh& mesh, SurfaceBasis basis = SurfaceBasis::linear)
{
  const SurfaceCase c(mesh, basis);
  return inertia_ellipsoid(c.surface, c.shape.center);
}

TEST(Observables, SemiAxesOfAnEllipsoid)
{
  const InertiaEllipsoid e = ellipsoid_of(turned_ellipsoid(30));
  // The flat mesh is inscribed: each axis is short by about h²/16 of it.
  EXPECT_NEAR(e.semi_axes[0], 1.5, 0.008);
  EXPECT_NEAR(e.semi_axes[1], 1.1, 0.006);
  EXPECT_NEAR(e.semi_axes[2], 0.8, 0.005);
}

TEST(Observables, SemiAxesOfALoopSurfaceConvergeWithItsOrder)
{
  const auto error = [](int triangles)
  {
    const TriangleMesh mesh = mapped(test::smooth_sphere(triangles),
      [](const Vector3& d) -> Vector3 {
        return { 1.5 * d.x(), 1.1 * d.y(), 0.8 * d.z() };
      });
    return std::abs(ellipsoid_of(mesh, SurfaceBasis::loop).semi_axes[0] - 1.5);
  };
  const double coarse = error(320), fine = error(1280);
  EXPECT_LT(fine, 1e-4);
  EXPECT_GT(test::order(coarse, fine), 3) << coarse << ", " << fine;
}

TEST(Observables, InclinationIsCountedFromXTowardsZInHalfOpenRange)
{
  for (double degrees : { -89., -45., 0., 30., 89. })
  {
    const InertiaEllipsoid e = ellipsoid_of(turned_ellipsoid(degrees));
    ASSERT_TRUE(e.inclination_deg);
    EXPECT_NEAR(*e.inclination_deg, degrees, 1e-6);
    EXPECT_NEAR(*e.tilt_deg, 90 - std::abs(degrees), 1e-6);
  }
}

TEST(Observables, ASphereHasNoDirection)
{
  const InertiaEllipsoid e = ellipsoid_of(geodesic_sphere(4));
  EXPECT_FALSE(e.inclination_deg);
  EXPECT_FALSE(e.tilt_deg);
}

// A rigid rotation of a sphere about y takes 2π/ω; seen from a moving frame it does too.
TEST(Observables, TankTreadingFrequencyOfARotation)
{
  const Vector3 frame(0.3, 0, -2);
  const TriangleMesh sphere = geodesic_sphere(8);
  Points u(sphere.points.rows(), 3);
  for (int i = 0; i < u.rows(); ++i)
    u.row(i) = (frame + Vector3(0, 0.7, 0).cross(Vector3(sphere.points.row(i)))).transpose();
  EXPECT_NEAR(tank_treading_frequency(sphere, u, Vector3::Zero(), frame), 0.7, 0.005);
  EXPECT_NEAR(tank_treading_frequency(sphere, -u, Vector3::Zero(), -frame), 0.7, 0.005);
}

// An ellipsoid's surface going around as (a z/c, 0, −c x/a) ω: every point takes 2π/ω.
TEST(Observables, TankTreadingFrequencyOfAnEllipsoid)
{
  const double a = 1.5, c = 0.7, omega = 0.4;
  const auto error = [&](int triangles, SurfaceBasis basis)
  {
    const TriangleMesh mesh = mapped(test::smooth_sphere(triangles),
      [&](const Vector3& d) -> Vector3 {
        return { a * d.x(), 1.1 * d.y(), c * d.z() };
      });
    Points u = Points::Zero(mesh.points.rows(), 3);
    u.col(0) = omega * a / c * mesh.points.col(2);
    u.col(2) = -omega * c / a * mesh.points.col(0);
    const SurfaceCase surface(mesh, basis);
    const FlatSample sample = FlatPieces(surface.space).around(0, surface.shape, u);
    return std::abs(
      tank_treading_frequency(sample.mesh, sample.field, Vector3::Zero(), Vector3::Zero()) / omega -
      1);
  };
  for (const auto& [basis, tolerance] :
    { std::pair(SurfaceBasis::linear, 5e-3), std::pair(SurfaceBasis::loop, 3e-4) })
  {
    const double coarse = error(320, basis), fine = error(1280, basis);
    EXPECT_LT(fine, tolerance);
    EXPECT_GT(test::order(coarse, fine), 1.7) << coarse << ", " << fine;
  }
}

TEST(Observables, NoFrequencyWhereTheFlowDoesNotGoAround)
{
  const TriangleMesh sphere = geodesic_sphere(6);
  EXPECT_EQ(tank_treading_frequency(
              sphere, Points::Zero(sphere.points.rows(), 3), Vector3::Zero(), Vector3::Zero()),
    0);
  Points strain = sphere.points;
  strain.col(2) *= -1;
  EXPECT_EQ(tank_treading_frequency(sphere, strain, Vector3::Zero(), Vector3::Zero()), 0);
}

class Harmonics : public testing::TestWithParam<SurfaceBasis>
{
protected:
  static constexpr int degree = 8;

  Eigen::VectorXd amplitudes(const TriangleMesh& mesh) const
  {
    const SurfaceCase c(mesh, GetParam());
    return harmonic_amplitudes(c.surface, Vector3::Zero(), degree).value();
  }
  static Eigen::VectorXd powers(const Eigen::VectorXd& amplitudes)
  {
    Eigen::VectorXd result(degree + 1);
    for (int l = 0; l <= degree; ++l)
      result[l] = amplitudes.segment(harmonic_index(l, -l), 2 * l + 1).squaredNorm();
    return result;
  }
};

// r = 1 + Σ a_lm Y_lm about the origin.
double radius(const Vector3& d)
{
  return 1 + 0.1 * real_spherical_harmonic(2, 1, d) - 0.05 * real_spherical_harmonic(3, -2, d) +
    0.03 * real_spherical_harmonic(6, 0, d);
}

TriangleMesh lumpy(int triangles)
{
  return mapped(
    test::smooth_sphere(triangles), [](const Vector3& d) -> Vector3 { return radius(d) * d; });
}

TEST_P(Harmonics, ComeBackWithTheOrderOfTheSurface)
{
  Eigen::VectorXd exact = Eigen::VectorXd::Zero(harmonic_count(degree));
  exact[harmonic_index(0, 0)] = std::sqrt(4 * std::numbers::pi);
  exact[harmonic_index(2, 1)] = 0.1;
  exact[harmonic_index(3, -2)] = -0.05;
  exact[harmonic_index(6, 0)] = 0.03;
  const auto error = [&](int triangles)
  { return (amplitudes(lumpy(triangles)) - exact).cwiseAbs().maxCoeff(); };
  const double coarse = error(1280), fine = error(5120);
  const bool flat = GetParam() == SurfaceBasis::linear;
  EXPECT_LT(fine, flat ? 1e-2 : 1e-4);
  EXPECT_GT(test::order(coarse, fine), flat ? 1.9 : 3) << coarse << ", " << fine;
}

TEST_P(Harmonics, ARotationMovesNoPowerBetweenDegrees)
{
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(1.1, Vector3(1, -2, 0.5).normalized()).toRotationMatrix();
  const Eigen::VectorXd before = amplitudes(lumpy(320)),
                        after = amplitudes(
                          mapped(lumpy(320), [&](const Vector3&x) -> Vector3 { return turn * x; }));
  EXPECT_GT((after - before).norm(), 0.01);
  EXPECT_LT((powers(after) - powers(before)).cwiseAbs().maxCoeff(), 1e-12);
}

TEST_P(Harmonics, ScaleWithTheShapeAndLeaveItsPlaceOut)
{
  const TriangleMesh mesh = lumpy(320);
  TriangleMesh other = mesh;
  other.points = 3 * mesh.points;
  other.points.rowwise() += Eigen::RowVector3d(10, -20, 30);
  const SurfaceCase c(other, GetParam());
  EXPECT_LT(
    (harmonic_amplitudes(c.surface, Vector3(10, -20, 30), degree).value() - 3 * amplitudes(mesh))
      .cwiseAbs()
      .maxCoeff(),
    1e-12);
}

TEST_P(Harmonics, NoneWhereTheShapeIsNotStarShaped)
{
  const TriangleMesh banana = mapped(test::smooth_sphere(320),
    [](const Vector3& d) -> Vector3 {
      return { d.x() + 2 * d.z() * d.z(), d.y(), 3 * d.z() };
    });
  const SurfaceCase c(banana, GetParam());
  EXPECT_FALSE(harmonic_amplitudes(c.surface, c.shape.center, degree));
}

class Stresslet : public testing::TestWithParam<SurfaceBasis>
{
protected:
  const Eigen::VectorXd no_tension;
  const RowVectors no_force;
};

Eigen::Matrix3d strain()
{
  Eigen::Matrix3d E;
  E << 0.3, 0.7, -0.2, 0.7, -0.8, 0.4, -0.2, 0.4, 0.5;
  return E;
}

// A rigid sphere of radius a in u∞ = E·x: the traction on it is 5 μ E·n, S = (20/3) π μ a³ E.
TEST_P(Stresslet, OfARigidSphereInStrain)
{
  const double a = 2, exact = 20. / 3 * std::numbers::pi * a * a * a;
  const auto error = [&](int triangles)
  {
    const TriangleMesh unit = test::smooth_sphere(triangles);
    const SurfaceCase c({ a * unit.points, unit.triangles }, GetParam());
    const RowVectors force = c.at_rows(-5 * unit.points * strain());
    const Eigen::Matrix3d S = stresslet(c.surface, c.shape.center, force, no_tension);
    EXPECT_LT(std::abs(S.trace()), 1e-12);
    EXPECT_EQ(S, S.transpose());
    return (S / exact - strain()).norm();
  };
  const double coarse = error(320), fine = error(1280);
  const bool flat = GetParam() == SurfaceBasis::linear;
  EXPECT_LT(fine, flat ? 2e-2 : 2e-5);
  EXPECT_GT(test::order(coarse, fine), flat ? 1.9 : 3.5) << coarse << ", " << fine;
}

TEST_P(Stresslet, APressureHasNone)
{
  const TriangleMesh mesh = mapped(test::smooth_sphere(320), test::perturbed_sphere);
  const SurfaceCase c(mesh, GetParam());
  const RowVectors normal = c.surface.cross.rowwise().normalized();
  EXPECT_LT(stresslet(c.surface, c.shape.center, normal, no_tension).norm(),
    GetParam() == SurfaceBasis::linear ? 1e-12 : 1e-6);
}

// On the unit sphere with γ = g·x + x·A·x: the force ∇_s γ − 2 γ n, and the tension's virtual work.
TEST_P(Stresslet, OfATensionIsThatOfItsForce)
{
  const Eigen::Matrix3d A = strain() + 0.6 * Eigen::Matrix3d::Identity();
  const Vector3 g(0.2, -0.5, 1);
  const auto difference = [&](int triangles)
  {
    const SurfaceCase c(test::smooth_sphere(triangles), GetParam());
    Eigen::VectorXd gamma(c.surface.position.rows());
    RowVectors force(gamma.size(), 3);
    for (int q = 0; q < gamma.size(); ++q)
    {
      const Vector3 n = c.surface.position.row(q).normalized();
      const Vector3 gradient = g + 2 * A * n;
      gamma[q] = g.dot(n) + n.dot(A * n);
      force.row(q) = gradient - n.dot(gradient) * n - 2 * gamma[q] * n;
    }
    const Eigen::Matrix3d by_work = stresslet(c.surface, c.shape.center, no_force, gamma);
    EXPECT_GT(by_work.norm(), 1);
    return (by_work - stresslet(c.surface, c.shape.center, force, no_tension)).norm();
  };
  const double coarse = difference(320), fine = difference(1280);
  const bool flat = GetParam() == SurfaceBasis::linear;
  EXPECT_LT(fine, flat ? 3e-2 : 1e-4);
  EXPECT_GT(test::order(coarse, fine), flat ? 1.9 : 3.5) << coarse << ", " << fine;
}

// The density at the vertices: of material motion on smooth surfaces, whose load is the gradient.
template<class Case>
Points bending_at_vertices(const Case& c, const MembraneTerm& bending)
{
  if (!c.space.smooth())
    return LumpedForces(c.shape, nullptr).at_vertices(bending.force(c.shape).density);
  const SymmetricMatrix mass(mass_matrix(c.space.table(), c.shape.points));
  const Eigen::MatrixXd load = -rows_of_three(bending.variation(c.shape).gradient);
  return rows_of_three(c.shape.collocation().to_vertices(
    flat(Points(Eigen::MatrixXd(SparseCholesky(mass).solve(load))))));
}

// The membrane's power on the fluid comes from its energy: S:E = −∮ f·E x dS = dE_b/dε where the
// shape is strained by ε E.
TEST_P(Stresslet, OfBendingIsTheEnergysDerivativeByStrain)
{
  const auto error = [&](int triangles)
  {
    const TriangleMesh mesh = mapped(test::smooth_sphere(triangles),
      [](const Vector3& d) -> Vector3 {
        return { 1.4 * d.x() + 0.3 * d.z(), 1.1 * d.y(), 0.8 * d.z() };
      });
    const SurfaceCase c(mesh, GetParam());
    const auto bending = make_bending(c.space, 0);
    const RowVectors force = c.at_rows(bending_at_vertices(c, *bending));
    const auto energy = [&](double epsilon)
    {
      return bending->energy(
        Surface(c.space, mesh.points * (Eigen::Matrix3d::Identity() + epsilon * strain())));
    };
    const double epsilon = 1e-4, slope = (energy(epsilon) - energy(-epsilon)) / (2 * epsilon);
    const Eigen::Matrix3d S = stresslet(c.surface, c.shape.center, force, no_tension);
    return std::abs((S * strain()).trace() / slope - 1);
  };
  // With linear elements 1.6e-3 and 3.6e-4; the load of a smooth surface is the energy's derivative.
  const double coarse = error(1280), fine = error(5120);
  if (GetParam() == SurfaceBasis::loop)
  {
    EXPECT_LT(fine, 1e-6);
    return;
  }
  EXPECT_LT(fine, 5e-4);
  EXPECT_GT(test::order(coarse, fine), 1.5) << coarse << ", " << fine;
}

INSTANTIATE_TEST_SUITE_P(
  Bases, Harmonics, testing::Values(SurfaceBasis::linear, SurfaceBasis::loop));
INSTANTIATE_TEST_SUITE_P(
  Bases, Stresslet, testing::Values(SurfaceBasis::linear, SurfaceBasis::loop));

}
}
