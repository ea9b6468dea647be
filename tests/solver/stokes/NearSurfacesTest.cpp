// Two surfaces near each other: what either's layers do at the other's vertices.

#include "solver/stokes/DoubleLayer.h"
#include "solver/stokes/StokesOperator.h"
#include "solver/stokes/TreeSum.h"
#include "tests/solver/stokes/LoopBody.h"
#include "tests/solver/support/TestMeshes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vesicle
{
namespace
{

using test::Field;
using Sheet = test::LoopBody;

TriangleMesh moved(TriangleMesh mesh, const Vector3& by)
{
  mesh.points.rowwise() += by.transpose();
  return mesh;
}

/// Outside a unit sphere at the origin under the load z n (no membrane, one viscosity): with the
/// harmonics a = e_z/r + x z/r³, u = a/6 + ∇²a/60.
Vector3 beside_blob(const Vector3& x)
{
  const double r = x.norm(), r3 = r * r * r;
  const Vector3 e = Vector3::UnitZ(), n = x / r;
  return (e / r + x * x.z() / r3) / 6 + (e - 3 * n * n.z()) * 2 / r3 / 60;
}

Vector3 blob_load(const Vector3& x)
{
  return x.z() * x;
}

Vector3 rigid_motion(const Vector3& x)
{
  return Vector3(1, 2, -1) + Vector3(0.5, -1, 2).cross(x);
}

/// A unit sphere over another one, `gap` away along z, turned: no vertex is over a vertex.
TriangleMesh sphere_above(int triangles, double gap)
{
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.4, Vector3(1, 2, 3).normalized()).matrix();
  return moved(test::mapped(test::smooth_sphere(triangles),
                 [&](const Vector3& d) -> Vector3 { return turn * d; }),
    { 0, 0, 2 + gap });
}

double largest(const Eigen::VectorXd& velocity)
{
  return rows_of_three(velocity).rowwise().norm().maxCoeff();
}

double rms(const Eigen::VectorXd& velocity)
{
  return velocity.norm() / std::sqrt(static_cast<double>(velocity.size()) / 3);
}

/// Velocities that densities on the first of two surfaces make at the second one's vertices.
Eigen::VectorXd single_layer(const Sheet& from, const Sheet& to, const Field& density)
{
  const StokesOperator layer({ from.surface(), to.surface() });
  const Eigen::VectorXd f = from.collocation.to_control(from.sampled(density)),
                        none = Eigen::VectorXd::Zero(3 * to.mesh.points.rows());
  return LayerSum(layer).apply({ f, none }).tail(none.size());
}

Eigen::VectorXd double_layer(const Sheet& from, const Sheet& to, const Field& velocity)
{
  const StokesOperator layer({ from.surface(), to.surface() });
  const Eigen::VectorXd u = from.sampled(velocity),
                        none = Eigen::VectorXd::Zero(3 * to.mesh.points.rows());
  Eigen::VectorXd both(u.size() + none.size());
  both << u, none;
  return DoubleLayer(layer, { 1, 1 })
    .apply({ from.collocation.to_control(u), none }, both)
    .tail(none.size());
}

TEST(NearSurfaces, TheBlobsFieldHasItsExactValues)
{
  EXPECT_NEAR(beside_blob({ 0, 0, 2.5 }).z(), 0.12906667, 1e-8);
  EXPECT_LT(
    (beside_blob({ 0.3, 0.2, 1.4 }) - Vector3(0.01651652, 0.01101101, 0.20339497)).norm(), 2e-8);
  // By hand: r² = 1.25, n = (1.1, 0, 0.2)/r.
  EXPECT_LT((beside_blob({ 1.1, 0, 0.2 }) - Vector3(0.01364300, 0, 0.17540313)).norm(), 2e-8);
}

// Down to a hundredth of an edge the error beside a surface is below that on it, whatever the gap.
TEST(NearSurfaces, TheSingleLayersErrorStaysBelowItsOwn)
{
  for (const int triangles : { 320, 1280 })
  {
    const Sheet lower(test::smooth_sphere(triangles));
    const Eigen::VectorXd f = lower.collocation.to_control(lower.sampled(blob_load));
    const Eigen::VectorXd own =
      LayerSum(StokesOperator({ lower.surface() })).apply({ f }) - lower.sampled(beside_blob);
    for (const double gap : { 1., 0.1, 0.01, 0.001 })
    {
      const Sheet upper(sphere_above(triangles, gap));
      const Eigen::VectorXd error =
        single_layer(lower, upper, blob_load) - upper.sampled(beside_blob);
      EXPECT_LT(largest(error), largest(own)) << triangles << ", " << gap;
      EXPECT_LT(rms(error), rms(own)) << triangles << ", " << gap;
    }
  }
}

// Outside a surface its rigid motions have no double layer. Measured: 2.5e-5 of the motion at most.
TEST(NearSurfaces, ARigidMotionHasNoDoubleLayerOutside)
{
  const Sheet lower(test::smooth_sphere(320));
  const double size = rms(lower.sampled(rigid_motion));
  for (const double gap : { 1., 0.1, 0.01, 0.001 })
    EXPECT_LT(
      largest(double_layer(lower, Sheet(sphere_above(320, gap)), rigid_motion)), 5e-5 * size)
      << gap;
}

/// Long and flat, through the same points of the unit sphere whatever its triangles.
TriangleMesh ellipsoid(int triangles)
{
  return test::mapped(test::smooth_sphere(triangles),
    [](const Vector3& d) -> Vector3 {
      return { 1.5 * d.x(), 0.9 * d.y(), 0.7 * d.z() };
    });
}

// A finer mesh with finer rules for truth; no closed form.
TEST(NearSurfaces, LayersOfAnEllipsoidBesideItTendToThoseOfAFinerOne)
{
  const Field density = [](const Vector3& x) -> Vector3 {
    return { x.z(), 1 + x.x() * x.y(), x.x() };
  };
  const Sheet truth(ellipsoid(5120), 12);
  for (const double gap : { 0.3, 0.02 })
  {
    const Sheet beside(moved(test::smooth_sphere(80), { 0.3, 0.2, 1.7 + gap - 0.02 }));
    for (const bool twofold : { false, true })
    {
      const auto layer = twofold ? double_layer : single_layer;
      const Eigen::VectorXd exact = layer(truth, beside, density);
      const double coarse = largest(layer(Sheet(ellipsoid(320)), beside, density) - exact),
                   fine = largest(layer(Sheet(ellipsoid(1280)), beside, density) - exact);
      // 1.5 and more were measured.
      EXPECT_GT(test::order(coarse, fine), 1)
        << gap << ", " << twofold << ": " << coarse << ' ' << fine;
      EXPECT_LT(fine, 2e-4 * largest(exact)) << gap << ", " << twofold;
    }
  }
}

// The dense matrix, all pairs and clusters are one operator, also where surfaces are near.
TEST(NearSurfaces, MatrixSumAndTreeAgree)
{
  const Sheet lower(test::smooth_sphere(320)), upper(sphere_above(80, 0.02));
  const StokesOperator layer({ lower.surface(), upper.surface() });
  std::vector<Eigen::VectorXd> densities;
  Eigen::VectorXd u = Eigen::VectorXd::Zero(3 * layer.vertices());
  for (int source = 0; source < 2; ++source)
  {
    const DenseMatrix S = layer.matrix(source);
    densities.emplace_back(Eigen::VectorXd::LinSpaced(S.cols(), 0, 40).array().sin());
    u += S * densities.back();
  }
  EXPECT_LT((LayerSum(layer).apply(densities) - u).norm(), 1e-13 * u.norm());
  const LayerSum by_tree(
    layer, [](const PointPlaces& places) { return std::make_unique<TreeSum>(places, 1e-7); });
  EXPECT_LT((by_tree.apply(densities) - u).norm(), 1e-7 * u.norm());
}

// Flat triangles too: their panels are exact, and the rules for the vertices hold at any distance.
TEST(NearSurfaces, FlatTrianglesHaveRulesBesideThem)
{
  const TriangleMesh mesh = test::smooth_sphere(320), other = sphere_above(80, 0.02);
  const LinearBasis of_mesh(mesh.triangles, static_cast<int>(mesh.points.rows())),
    of_other(other.triangles, static_cast<int>(other.points.rows()));
  const Points f = rows_of_three(Sheet(mesh).sampled(blob_load));
  const auto beside = [&](int points)
  {
    const LayerRules rules(of_mesh, { .regular = points }), others(of_other, { .regular = points });
    const StokesOperator layer(
      { { &rules, mesh.points, mesh.points }, { &others, other.points, other.points } });
    return Eigen::VectorXd(LayerSum(layer)
                             .apply({ flat(f), Eigen::VectorXd::Zero(3 * other.points.rows()) })
                             .tail(3 * other.points.rows()));
  };
  const Eigen::VectorXd fine = beside(12);
  EXPECT_LT(largest(beside(3) - fine), 2e-5 * largest(fine));
}

}
}
