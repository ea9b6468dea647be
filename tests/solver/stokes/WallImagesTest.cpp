// Images in a wall against Blake's formula, no slip, symmetry, multipoles in closed form and rigid
// spheres.

#include "solver/stokes/WallImages.h"

#include "solver/stokes/DoubleLayer.h"
#include "solver/stokes/LayerSum.h"
#include "solver/stokes/TreeSum.h"
#include "solver/stokes/TwoFluidFlow.h"
#include "solver/stokes/WallImage.h"
#include "tests/solver/stokes/InstructionSets.h"
#include "tests/solver/stokes/LoopBody.h"
#include "tests/solver/support/TestMeshes.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <cmath>
#include <functional>
#include <random>

namespace vesicle
{
namespace
{

using test::Field;
using Body = test::LoopBody;

const Eigen::Matrix3d mirror = Vector3(1, 1, -1).asDiagonal();
const Wall ground{ Vector3::Zero(), Vector3::UnitZ() };

/// A point and another one above the wall.
const Vector3 here(0.3, -0.2, 0.4), there(-0.5, 0.6, 0.9), push(0.4, -1.1, 0.7);

Vector3 image_of_force(const Vector3& x, const Vector3& y, const Vector3& f)
{
  return force_image(x, mirror * y) * (mirror * f);
}

Vector3 image_of_stresslet(const Vector3& x, const Vector3& y, const Vector3& u, const Vector3& n)
{
  return stresslet_image(x, mirror * y, mirror * n) * (mirror * u);
}

Vector3 force_alone(const Vector3& x, const Vector3& y, const Vector3& f)
{
  const Vector3 X = y - x;
  return f / X.norm() + X.dot(f) / std::pow(X.norm(), 3) * X;
}

Vector3 stresslet_alone(const Vector3& x, const Vector3& y, const Vector3& u, const Vector3& n)
{
  const Vector3 X = y - x;
  return X.dot(u) * X.dot(n) / std::pow(X.norm(), 5) * X;
}

/// As Blake has it: R = x − y*, D = diag(1, 1, −1).
Vector3 blake(const Vector3& x, const Vector3& y, const Vector3& f)
{
  const Vector3 R = x - mirror * y;
  const double r = R.norm(), h = y.z(), r3 = std::pow(r, 3), r5 = std::pow(r, 5);
  Eigen::Matrix3d G;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
    {
      const double ij = i == j, iz = i == 2, jz = j == 2;
      G(i, j) = -(ij / r + R[i] * R[j] / r3) +
        2 * h * mirror(j, j) *
          (h * (ij / r3 - 3 * R[i] * R[j] / r5) + iz * R[j] / r3 - (ij * R.z() + R[i] * jz) / r3 +
            3 * R[i] * R.z() * R[j] / r5);
    }
  return G * f;
}

/// ∂v_i/∂x_j by differences.
Eigen::Matrix3d gradient(const Field& v, const Vector3& x, double step = 1e-3)
{
  Eigen::Matrix3d result;
  for (int j = 0; j < 3; ++j)
  {
    const Vector3 d = step * Vector3::Unit(j);
    result.col(j) = (8 * (v(x + d) - v(x - d)) - (v(x + 2 * d) - v(x - 2 * d))) / (12 * step);
  }
  return result;
}

Vector3 laplacian(const Field& v, const Vector3& x, double step)
{
  Vector3 sum = Vector3::Zero();
  for (int j = 0; j < 3; ++j)
  {
    const Vector3 d = step * Vector3::Unit(j);
    sum +=
      (16 * (v(x + d) + v(x - d)) - (v(x + 2 * d) + v(x - 2 * d)) - 30 * v(x)) / (12 * step * step);
  }
  return sum;
}

TEST(WallImage, OfAForceIsBlakes)
{
  EXPECT_LT((image_of_force(here, there, push) - blake(here, there, push)).norm(), 1e-14);
}

TEST(WallImage, LeavesNoSlipAtTheWall)
{
  const Vector3 foot(0.3, -0.2, 0), n(0.2, 0.9, -0.5);
  EXPECT_LT((image_of_force(foot, there, push) + force_alone(foot, there, push)).norm(), 1e-14);
  EXPECT_LT(
    (image_of_stresslet(foot, there, push, n) + stresslet_alone(foot, there, push, n)).norm(),
    1e-14);
}

TEST(WallImage, OfAForceIsSymmetric)
{
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      EXPECT_NEAR(image_of_force(here, there, Vector3::Unit(j))[i],
        image_of_force(there, here, Vector3::Unit(i))[j], 1e-15);
}

// ∇·u = 0, and the curl of ∇²u, which is that of ∇p/μ, is zero.
TEST(WallImage, IsAStokesFlow)
{
  const Vector3 n(0.2, 0.9, -0.5);
  const Field fields[] = { [](const Vector3& x) { return image_of_force(x, there, push); },
    [&](const Vector3& x) { return image_of_stresslet(x, there, push, n); } };
  for (const Field& field : fields)
  {
    EXPECT_NEAR(gradient(field, here).trace(), 0, 1e-9);
    const Eigen::Matrix3d of_pressure =
      gradient([&](const Vector3& x) { return laplacian(field, x, 0.01); }, here, 0.02);
    EXPECT_LT((of_pressure - of_pressure.transpose()).norm(), 1e-4 * of_pressure.norm());
  }
}

// T = −p δ + ∇v + ∇vᵀ of a force's flow v, contracted with a traceless u n: −6 times the stresslet's.
TEST(WallImage, OfAStressletIsTheStressOfAForces)
{
  const Vector3 u(0.4, -1.1, 0), n(0.55, 0.2, -0.9); // u·n = 0
  for (int j = 0; j < 3; ++j)
  {
    const Eigen::Matrix3d slope =
      gradient([&](const Vector3& y) { return image_of_force(y, here, Vector3::Unit(j)); }, there);
    EXPECT_NEAR(
      u.dot((slope + slope.transpose()) * n), -6 * image_of_stresslet(here, there, u, n)[j], 1e-9);
  }
}

RowVectors random_rows(int rows, unsigned seed)
{
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  return RowVectors::NullaryExpr(rows, 3, [&] { return normal(random); });
}

/// Over the wall, as far from the origin as wanted.
Points over_wall(int rows, unsigned seed, double aside)
{
  Points x = random_rows(rows, seed);
  x.col(2) = x.col(2).cwiseAbs().array() + 0.05;
  x.col(0).array() += aside;
  return x;
}

struct Sources
{
  RowVectors position, strength, normal; ///< mirrored
  explicit Sources(int rows)
    : position(over_wall(rows, 1, 100)), strength(random_rows(rows, 2)),
      normal(random_rows(rows, 3))
  {
    position.col(2) *= -1;
  }
  Points formula(const Points& at, bool stresslets) const
  {
    Points sum = Points::Zero(at.rows(), 3);
    for (Eigen::Index i = 0; i < at.rows(); ++i)
      for (Eigen::Index q = 0; q < position.rows(); ++q)
      {
        const Vector3 x = at.row(i).transpose(), y = position.row(q).transpose(),
                      n = normal.row(q).transpose();
        sum.row(i) += ((stresslets ? stresslet_image(x, y, n) : force_image(x, y)) *
          strength.row(q).transpose())
                        .transpose();
      }
    return sum;
  }
  Eigen::MatrixXd strengths(bool stresslets) const
  {
    if (stresslets)
      return symmetric_products(strength, normal);
    return strength;
  }
};

template<PointKind kind>
void expect_sums_give_the_formula()
{
  const bool stresslets = kind == PointKind::stresslet_image;
  const Sources sources(1500);
  for (const int targets : { 1, 16, 37, 642 })
  {
    const Points at = over_wall(targets, 4, 100), exact = sources.formula(at, stresslets);
    Points full = Points::Zero(targets, 3), single = full, tree = full;
    const DirectPointSum<kind> sum(sources.position, at);
    sum.add(sources.strengths(stresslets), 0, full);
    sum.add(sources.strengths(stresslets), single_precision_error, single);
    TreePointSum<kind>({ sources.position, at }, 1e-7).add(sources.strengths(stresslets), 0, tree);
    EXPECT_LT((full - exact).norm(), 1e-13 * exact.norm()) << targets;
    EXPECT_LT((single - exact).norm(), single_precision_error * exact.norm()) << targets;
    EXPECT_LT((tree - exact).norm(), 1e-6 * exact.norm()) << targets;
  }
}

TEST(WallImage, SumsGiveTheFormula)
{
  expect_sums_give_the_formula<PointKind::force_image>();
  expect_sums_give_the_formula<PointKind::stresslet_image>();
}

template<class Real, PointKind kind>
void expect_loop_gives_the_formula(const StokesletLoops& loops, double tolerance)
{
  const bool stresslets = kind == PointKind::stresslet_image;
  Sources sources(33);
  sources.position.col(0).array() -= 100;
  const Points at = over_wall(sum_lanes, 5, 0);
  const Points velocity =
    test::velocities_by<Real, kind>(loops, sources.position, sources.strengths(stresslets), at);
  const Points exact = sources.formula(at, stresslets);
  EXPECT_LT((velocity - exact).norm(), tolerance * exact.norm());
}

TEST(WallImage, LoopsOfEachInstructionSetGiveTheFormula)
{
  for (const StokesletLoops* loops : test::all_loops())
  {
    expect_loop_gives_the_formula<double, PointKind::force_image>(*loops, 1e-13);
    expect_loop_gives_the_formula<float, PointKind::force_image>(*loops, single_precision_error);
    expect_loop_gives_the_formula<double, PointKind::stresslet_image>(*loops, 1e-13);
    expect_loop_gives_the_formula<float, PointKind::stresslet_image>(
      *loops, single_precision_error);
  }
}

/// A unit sphere, turned so that no vertex is lowest, its lowest point `gap` above z = 0.
TriangleMesh sphere_over_wall(int triangles, double gap)
{
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.4, Vector3(1, 2, 3).normalized()).matrix();
  TriangleMesh mesh = test::mapped(
    test::smooth_sphere(triangles), [&](const Vector3& d) -> Vector3 { return turn * d; });
  mesh.points.col(2).array() += 1 + gap;
  return mesh;
}

template<PointKind kind>
std::unique_ptr<const PointSum> direct(const PointPlaces& places)
{
  return std::make_unique<DirectPointSum<kind>>(places.sources, places.targets);
}

/// The images of S f or K u at the body's own vertices.
Eigen::VectorXd images(
  const Body& body, const Field& density, PointKind kind, const Wall& wall = ground)
{
  const WallImages made(StokesOperator({ body.surface() }), wall, kind, { 1 },
    kind == PointKind::force ? direct<PointKind::force_image> : direct<PointKind::stresslet_image>);
  Eigen::VectorXd velocity = Eigen::VectorXd::Zero(3 * body.mesh.points.rows());
  made.add({ body.collocation.to_control(body.sampled(density)) }, 0, velocity);
  return velocity;
}

double largest(const Eigen::VectorXd& velocity)
{
  return rows_of_three(velocity).rowwise().norm().maxCoeff();
}

// Under the load e·(x − c) n a unit sphere's flow is that of (1 + ∇²/10) of a force e 8π/6 in its
// centre c, so its images are (1 + ∇²/10)/6 of those, with the derivatives by c.
TEST(WallImages, OfALoadedSphereAreThoseOfItsMultipolesDownToATenthOfAnEdge)
{
  const Vector3 e(0.6, 0, 0.8);
  for (const int triangles : { 320, 1280 })
  {
    const double edge = std::sqrt(16 * M_PI / std::sqrt(3) / triangles);
    for (const double edges : { 3., 1., 0.3, 0.1 })
    {
      const Body body(sphere_over_wall(triangles, edges * edge));
      const Vector3 c(0, 0, 1 + edges * edge);
      const Field load = [&](const Vector3& x) -> Vector3 { return e.dot(x - c) * (x - c); };
      const Field exact = [&](const Vector3& x) -> Vector3
      {
        const Field of_centre = [&](const Vector3& y) { return image_of_force(x, y, e); };
        return (of_centre(c) + laplacian(of_centre, c, 0.02) / 10) / 6;
      };
      const Field alone = [&](const Vector3& x) -> Vector3 { // on the sphere
        const Vector3 along = e.dot(x - c) * (x - c);
        return (e + along) / 6 + (e - 3 * along) / 30;
      };
      const Eigen::VectorXd f = body.collocation.to_control(body.sampled(load));
      const double own =
        largest(LayerSum(StokesOperator({ body.surface() })).apply({ f }) - body.sampled(alone));
      EXPECT_LT(own, 2e-4);
      EXPECT_LT(largest(images(body, load, PointKind::force) - body.sampled(exact)), own)
        << triangles << ", " << edges;
    }
  }
}

// A Stokes flow inside a closed surface makes nothing outside of it: K v + S (σ·n)/μ = 0, images too.
TEST(WallImages, OfAStrainsDoubleLayerAreThoseOfItsStress)
{
  Eigen::Matrix3d E;
  E << 1, 0.3, -0.5, 0.3, -0.4, 0.2, -0.5, 0.2, -0.6;
  for (const int triangles : { 320, 1280 })
  {
    const double edge = std::sqrt(16 * M_PI / std::sqrt(3) / triangles);
    for (const double edges : { 3., 1., 0.3, 0.1 })
    {
      const Body body(sphere_over_wall(triangles, edges * edge));
      const Vector3 c(0, 0, 1 + edges * edge);
      const Field strain = [&](const Vector3& x) -> Vector3 { return E * (x - c); };
      const Eigen::VectorXd v = body.sampled(strain),
                            twofold = images(body, strain, PointKind::stresslet),
                            single = 2 * images(body, strain, PointKind::force);
      // On a sphere alone K v = v/10.
      const double own = largest(DoubleLayer(StokesOperator({ body.surface() }), { 1 })
                                   .apply({ body.collocation.to_control(v) }, v) -
        v / 10);
      EXPECT_LT(largest(twofold + single), own) << triangles << ", " << edges;
    }
  }
}

TEST(WallImages, OfARigidMotionsDoubleLayerAreNothing)
{
  const Body body(sphere_over_wall(320, 0.1));
  const Field motion = [](const Vector3& x) -> Vector3
  { return Vector3(1, 2, -1) + Vector3(0.5, -1, 2).cross(x); };
  EXPECT_LT(largest(images(body, motion, PointKind::stresslet)), 1e-14);
}

// A wall anywhere is the wall z = 0 moved there with the surface.
TEST(WallImages, OfAWallAnywhereTurnWithIt)
{
  const Body body(sphere_over_wall(320, 0.05));
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(2, Vector3(1, -1, 0.5).normalized()).matrix();
  const Vector3 shift(3, -2, 5);
  const Field load = [](const Vector3& x) -> Vector3 { return { x.z(), x.x() * x.y(), 1 }; };
  const Body moved(
    test::mapped(body.mesh, [&](const Vector3& x) -> Vector3 { return turn * x + shift; }));
  const Field moved_load = [&](const Vector3& x) -> Vector3
  { return turn * load(turn.transpose() * (x - shift)); };
  for (const PointKind kind : { PointKind::force, PointKind::stresslet })
  {
    const Points at_ground = rows_of_three(images(body, load, kind)),
                 elsewhere = rows_of_three(
                   images(moved, moved_load, kind, { shift + turn.col(0), turn.col(2) }));
    EXPECT_LT((elsewhere - at_ground * turn.transpose()).norm(), 1e-11 * at_ground.norm());
  }
}

// S with its images is symmetric and positive, the power of forces on the fluid: near the wall as far
// from it.
TEST(WallImages, LeaveTheLayerPositive)
{
  const Body body(sphere_over_wall(80, 0.05));
  const StokesOperator layer({ body.surface() });
  const WallImages made(layer, ground, PointKind::force, { 1 }, direct<PointKind::force_image>);
  const DenseMatrix alone = layer.matrix(0);
  Eigen::MatrixXd with = alone;
  for (Eigen::Index k = 0; k < with.cols(); ++k)
  {
    Eigen::VectorXd column = Eigen::VectorXd::Zero(with.rows());
    made.add({ Eigen::VectorXd::Unit(with.cols(), k) }, 0, column);
    with.col(k) += column;
  }
  // Of smooth densities; collocation isn't Galerkin's.
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 20; ++trial)
  {
    Eigen::Matrix3d A;
    Vector3 b;
    for (double& entry : A.reshaped())
      entry = normal(random);
    for (double& entry : b)
      entry = normal(random);
    const Eigen::VectorXd f = body.sampled([&](const Vector3&x) -> Vector3 { return A * x + b; }),
                          control = body.collocation.to_control(f);
    const double free_power = f.dot(alone * control), power = f.dot(with * control);
    EXPECT_GT(power, 0);
    EXPECT_LT(power, free_power);
  }
}

TEST(WallImages, DoNotDependOnTheNumberOfThreads)
{
  const Body body(sphere_over_wall(320, 0.1));
  for (const PointKind kind : { PointKind::force, PointKind::stresslet })
  {
    Eigen::VectorXd made[2];
    for (const int threads : { 1, 2 })
    {
      const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
      made[threads - 1] = images(
        body,
        [](const Vector3& x) -> Vector3 {
          return { x.z(), x.x(), 1 };
        },
        kind);
    }
    EXPECT_EQ(made[0], made[1]);
  }
}

// What a probe finds at the vertices is what the layers have there, and nothing at the wall.
TEST(WallFlow, IsThatOfTheLayersAndNothingAtTheWall)
{
  const Body body(sphere_over_wall(320, 0.1));
  const Field load = [](const Vector3&x) -> Vector3 {
    return { x.z(), 0.3, x.x() };
  },
              motion = [](const Vector3&x) -> Vector3 {
                return { x.x() * x.z(), x.z(), x.y() };
              };
  const Points f = rows_of_three(body.sampled(load)), u = rows_of_three(body.sampled(motion));
  const WallFlow flow(ground, body.mesh, SurfaceBasis::loop, f, u);
  const Points& x = body.mesh.points;
  for (const bool twofold : { false, true })
  {
    const Points layers = rows_of_three(images(body, twofold ? motion : load,
                   twofold ? PointKind::stresslet : PointKind::force)),
                 found = flow.at(x, twofold ? 0 : 1, twofold ? 1 : 0);
    EXPECT_LT((found - layers).norm(), 2e-3 * layers.norm()) << twofold;
  }
  Points feet = x;
  feet.col(2).setZero();
  for (const double ratio : { 1., 5. })
  {
    const TwoFluidFlow both(body.mesh, SurfaceBasis::loop, f, u, 2, ratio, ground);
    const Points none = Points::Zero(feet.rows(), 3);
    const double speed = both.at(x, none).velocity.rowwise().norm().maxCoeff();
    EXPECT_LT(both.at(feet, none).velocity.rowwise().norm().maxCoeff(), 1e-5 * speed) << ratio;
    Points behind = feet;
    behind.col(2).setConstant(-0.5);
    EXPECT_TRUE(both.at(behind, Points::Ones(feet.rows(), 3)).velocity.isZero()) << ratio;
  }
}

}
}
