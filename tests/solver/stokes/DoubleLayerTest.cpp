// The double layer on Loop's limit surface against exact values (numerics of two fluids: the vector
// harmonics are its eigenvectors on the sphere, rigid motions on any surface).

#include "solver/stokes/DoubleLayer.h"

#include "solver/mesh/shapes/ShapeRequest.h"
#include "solver/mesh/shapes/Shapes.h"
#include "solver/stokes/TreeSum.h"
#include "tests/solver/stokes/LoopBody.h"
#include "tests/solver/support/TestMeshes.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

namespace vesicle
{
namespace
{

using test::Field;
using Body = test::LoopBody;

std::unique_ptr<const PointSum> tree_sum(const PointPlaces& places)
{
  return std::make_unique<TreePointSum<PointKind::stresslet>>(places, 1e-6);
}

Eigen::VectorXd double_layer(
  const Body& body, const Field& field, const MakePointSum& make_sum = DoubleLayer::direct_sum)
{
  const Eigen::VectorXd u = body.sampled(field);
  return DoubleLayer(StokesOperator({ body.surface() }), { 1 }, make_sum)
    .apply({ body.collocation.to_control(u) }, u);
}

/// Root mean square of K u − factor u, over that of u.
double eigen_error(const Body& body, const Field& field, double factor)
{
  const Eigen::VectorXd u = body.sampled(field);
  return (double_layer(body, field) - factor * u).norm() / u.norm();
}

struct Mode
{
  const char* name;
  Field field;
  double eigenvalue;
};

Vector3 gradient_xy(const Vector3& x)
{
  return { x.y(), x.x(), 0 };
}

// −3/(2(2l+1)(2l+3)) of V_l, 3/(2(2l+1)(2l−1)) of W_l, 3/(2(2l+1)) of toroidal ones.
const Mode modes[] = {
  { "normal", [](const Vector3& x) { return x; }, -1. / 2 },
  { "strain", [](const Vector3& x) { return Vector3(x.x(), 2 * x.y(), -3 * x.z()); }, 1. / 10 },
  { "W2", gradient_xy, 1. / 10 },
  { "V2", [](const Vector3& x) -> Vector3 { return gradient_xy(x) - 5 * x.x() * x.y() * x; },
    -3. / 70 },
  { "toroidal", [](const Vector3& x) -> Vector3 { return x.cross(gradient_xy(x)); }, 3. / 10 },
};

TEST(DoubleLayer, SphereEigenvaluesWithOrderOverTwoAndAHalf)
{
  const Body coarse(test::smooth_sphere(320)), fine(test::smooth_sphere(1280));
  for (const Mode& mode : modes)
  {
    const double e0 = eigen_error(coarse, mode.field, mode.eigenvalue),
                 e1 = eigen_error(fine, mode.field, mode.eigenvalue);
    EXPECT_GT(test::order(e0, e1), 2.5) << mode.name << ": " << e0 << ", " << e1;
    EXPECT_LT(e1, 2e-4) << mode.name;
  }
}

// To rounding: of ω × X, taken from the vertex, X·(ω × X) is zero.
TEST(DoubleLayer, KeepsHalfOfARigidMotion)
{
  ShapeRequest request;
  request.kind = ShapeRequest::Kind::ellipsoid;
  request.semi_axes = { 2, 1, 0.7 };
  request.triangles = 320;
  const Body body(make_shape(request));
  const Field motion = [](const Vector3& x) -> Vector3
  { return Vector3(1, 2, -1) + Vector3(0.5, -1, 2).cross(x); };
  EXPECT_LT(eigen_error(body, motion, 0.5), 1e-14);
}

// A rigid motion of one surface is u inside it and nothing outside.
TEST(DoubleLayer, OfARigidMotionIsItselfInsideAndNothingOutside)
{
  const Body shell(test::smooth_sphere(1280));
  const Field motion = [](const Vector3& x) -> Vector3
  { return Vector3(1, 2, -1) + Vector3(0.5, -1, 2).cross(x); };
  for (const bool inside : { false, true })
  {
    TriangleMesh other = test::smooth_sphere(320);
    other.points *= inside ? 0.5 : 1;
    other.points.col(0).array() += inside ? 0 : 3;
    const Body speck(std::move(other));
    const Eigen::VectorXd u = shell.sampled(motion), zero = 0 * speck.sampled(motion);
    Eigen::VectorXd both(u.size() + zero.size());
    both << u, zero;
    const Eigen::VectorXd made =
      DoubleLayer(StokesOperator({ shell.surface(), speck.surface() }), { 1, 1 })
        .apply({ shell.collocation.to_control(u), zero }, both);
    const Eigen::VectorXd there = made.tail(zero.size()),
                          exact = inside ? speck.sampled(motion) : zero;
    EXPECT_LT((there - exact).norm() / speck.sampled(motion).norm(), 2e-5) << inside;
  }
}

TEST(DoubleLayer, ByATreeIsTheSameToItsTolerance)
{
  const Body body(test::smooth_sphere(1280));
  const Eigen::VectorXd direct = double_layer(body, modes[3].field),
                        tree = double_layer(body, modes[3].field, tree_sum);
  EXPECT_LT((tree - direct).norm() / direct.norm(), 1e-5);
}

TEST(DoubleLayer, InSinglePrecisionIsTheSameToItsError)
{
  const Body body(test::smooth_sphere(320));
  const Eigen::VectorXd u = body.sampled(modes[2].field);
  const DoubleLayer layer(StokesOperator({ body.surface() }), { 1 });
  const std::vector<Eigen::VectorXd> control{ body.collocation.to_control(u) };
  const Eigen::VectorXd full = layer.apply(control, u),
                        single = layer.apply(control, u, single_precision_error);
  EXPECT_NE(full, single);
  EXPECT_LT((single - full).norm() / full.norm(), single_precision_error);
}

TEST(DoubleLayer, DoesNotDependOnTheNumberOfThreads)
{
  const Body body(test::smooth_sphere(320));
  Eigen::VectorXd made[2];
  for (const int threads : { 1, 2 })
  {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    made[threads - 1] = double_layer(body, modes[3].field);
  }
  EXPECT_EQ(made[0], made[1]);
}

}
}
