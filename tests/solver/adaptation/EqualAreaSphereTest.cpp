// Spheres on which the patches of a surface have their areas.

#include "solver/adaptation/EqualAreaSphere.h"

#include "solver/Errors.h"
#include "solver/surface/StartShape.h"
#include "tests/solver/support/TestMeshes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace vesicle
{
namespace
{

struct Mapped
{
  SurfaceSpace space;
  Surface surface;
  Points on_sphere;

  explicit Mapped(const TriangleMesh& mesh)
    : space(SurfaceBasis::loop, mesh.triangles, static_cast<int>(mesh.points.rows())),
      surface(space, mesh.points), on_sphere(equal_area_sphere(surface))
  {
  }

  /// By which its patches are dilated, the surface's mean square.
  double dilation() const
  {
    const Surface sphere(space, on_sphere);
    const Eigen::ArrayXd ratio =
      sphere.points.area_weight.array() / surface.points.area_weight.array() - 1;
    return std::sqrt((ratio.square() * surface.points.area_weight.array()).sum() / surface.area);
  }
};

// Wherever it is and however it is turned: distances between vertices stay.
TEST(EqualAreaSphere, OfASphereIsItself)
{
  TriangleMesh mesh = test::smooth_sphere(320);
  mesh.points = (2 * mesh.points).rowwise() + Eigen::RowVector3d(1, 2, 3);
  const Mapped mapped(mesh);
  for (const auto t : mesh.triangles.rowwise())
    EXPECT_NEAR((mapped.on_sphere.row(t[1]) - mapped.on_sphere.row(t[0])).norm() /
        (mesh.points.row(t[1]) - mesh.points.row(t[0])).norm(),
      1, 2e-2);
}

// Of a spheroid with the half axis c along z and a around it: the area below a height z is known.
TEST(EqualAreaSphere, CirclesOfASpheroidGoWhereTheAreaAboveIsTheSame)
{
  const double a = 0.8, c = 1.6;
  // dA = 2π a √(1 − e² z²/c²) dz, e² = 1 − a²/c².
  const double e = std::sqrt(1 - a * a / (c * c));
  const auto area_to = [&](double z)
  {
    const double s = e * z / c;
    return std::numbers::pi * a * c / e * (s * std::sqrt(1 - s * s) + std::asin(s));
  };
  const double half = area_to(c), radius = std::sqrt(half / (2 * std::numbers::pi));
  std::array<double, 2> error{};
  for (int level = 0; level < 2; ++level)
  {
    const TriangleMesh mesh = test::mapped(test::smooth_sphere(level == 0 ? 320 : 1280),
      [&](const Vector3& d) -> Vector3 {
        return { a * d.x(), a * d.y(), c * d.z() };
      });
    const Mapped mapped(mesh);
    const double side = mapped.on_sphere.col(2).dot(mesh.points.col(2)) > 0 ? 1 : -1;
    for (Eigen::Index i = 0; i < mesh.points.rows(); ++i)
      error[level] = std::max(error[level],
        std::abs(side * mapped.on_sphere(i, 2) / radius - area_to(mesh.points(i, 2)) / half));
  }
  EXPECT_LT(error[1], 1e-3);
  EXPECT_GT(test::order(error[0], error[1]), 1.5) << error[0] << " " << error[1];
}

TEST(EqualAreaSphere, NoPatchOfARedCellIsDilated)
{
  ShapeRequest request;
  request.kind = ShapeRequest::Kind::discocyte;
  request.reduced_volume = 0.65;
  request.triangles = 1280;
  EXPECT_LT(Mapped(make_start_shape(request, SurfaceBasis::loop)).dilation(), 1e-2);
  // As seen from the centroid its rim is thin.
  request.triangles = 320;
  EXPECT_THROW(Mapped{ make_start_shape(request, SurfaceBasis::loop) }, InputError);
}

// Nor of a body without symmetry.
TEST(EqualAreaSphere, NoPatchOfAnUnevenBodyIsDilated)
{
  std::array<double, 2> dilation;
  for (int level = 0; level < 2; ++level)
    dilation[level] = Mapped(
      test::mapped(test::smooth_sphere(level == 0 ? 320 : 1280),
        [](const Vector3& d) -> Vector3 {
          return { 1.5 * d.x() + 0.2 * d.z(), 0.8 * d.y(), 0.8 * d.z() + 0.1 * d.x() * d.x() };
        })).dilation();
  EXPECT_LT(dilation[1], 5e-3);
  EXPECT_GT(test::order(dilation[0], dilation[1]), 1.5) << dilation[0] << " " << dilation[1];
}

// A bent rod hides parts of itself.
TEST(EqualAreaSphere, TakesWhatIsSeenFromTheCentroid)
{
  const TriangleMesh bent = test::mapped(test::smooth_sphere(1280),
    [](const Vector3& d) -> Vector3 {
      return { 2 * d.x(), 0.4 * d.y(), 0.4 * d.z() + 1.5 * d.x() * d.x() };
    });
  EXPECT_THROW(Mapped{ bent }, InputError);
}

}
}
