// Outlines of bodies whose sections are known.

#include "render/CrossSection.h"

#include "TestSurfaces.h"

#include "solver/mesh/shapes/GeodesicSphere.h"
#include "vtkfilters/Filters/MeshConversion.h"

#include "vtkAppendPolyData.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vesicle::test
{
namespace
{

/// A sphere of 20,480 triangles, stretched to semi-axes a, b, c.
vtkSmartPointer<vtkPolyData> ellipsoid(double a, double b, double c, const Vector3& center)
{
  TriangleMesh mesh = geodesic_sphere(32);
  mesh.points *= Eigen::DiagonalMatrix<double, 3>(a, b, c);
  mesh.points.rowwise() += center.transpose();
  return to_polydata(mesh);
}

// The points of chords lie below the surface by h²/8 at most.
constexpr double chords = 1e-3;

}

TEST(CrossSection, OfAnEllipsoidIsAnEllipse)
{
  const auto surface = ellipsoid(2, 1, .5, { 3, 4, 5 });
  const auto lines = cut(surface, View::named("front"), { 0, 0, 0 });
  ASSERT_EQ(lines.size(), 1u);
  const auto& [x, z] = std::pair(lines[0].x, lines[0].y);
  EXPECT_GT(x.size(), 100u);
  for (std::size_t i = 0; i < x.size(); ++i)
    EXPECT_NEAR(std::hypot((x[i] - 3) / 2, (z[i] - 5) / .5), 1, chords);
  EXPECT_NEAR(x.front(), x.back(), 1e-12) << "closed";
  EXPECT_NEAR(z.front(), z.back(), 1e-12);
}

TEST(CrossSection, HasALineForEachBody)
{
  vtkNew<vtkAppendPolyData> both;
  both->AddInputData(ellipsoid(1, 1, 1, { 0, 0, 0 }));
  both->AddInputData(ellipsoid(1, 1, 1, { 3, 0, 0 }));
  both->Update();
  EXPECT_EQ(cut(both->GetOutput(), View::named("top"), { 0, 0, 0 }).size(), 2u);
}

TEST(CrossSection, ChartsLayTimesOverEachOther)
{
  const auto early = ellipsoid(1, 1, 1, { 0, 0, 0 }), late = ellipsoid(1.2, 1, .8, { 0, 0, 7 });
  const View side = View::named("side");
  const auto about = section_chart({ { 0, early }, { .5, late } }, side, true),
             fixed = section_chart({ { 0, early }, { .5, late } }, side, false);
  ASSERT_EQ(about.lines.size(), 2u);
  EXPECT_EQ(about.x_label, "y");
  EXPECT_EQ(about.y_label, "z");
  EXPECT_EQ(about.lines[1].label, "t = 0.5");
  EXPECT_NE(about.lines[0].color, about.lines[1].color);
  EXPECT_TRUE(about.equal_axes);
  EXPECT_NEAR(*std::max_element(about.lines[1].y.begin(), about.lines[1].y.end()), .8, chords);
  EXPECT_NEAR(*std::max_element(fixed.lines[1].y.begin(), fixed.lines[1].y.end()), 7.8, chords);
}

// A circle is as wide as high in the picture: its dark pixels tell.
TEST(CrossSection, UnitsAreEqualOnBothAxes)
{
  const TemporaryFolder folder;
  const auto sphere = ellipsoid(1, 1, 1, { 0, 0, 0 });
  ChartSpec chart = section_chart({ { 0, sphere } }, View::named("front"), true);
  chart.lines[0].color = { 255, 0, 0 };
  write_chart(folder / "circle.png", chart, { 900, 500 });
  const auto image = read_png(folder / "circle.png");
  std::array<int, 4> box{ 10000, -1, 10000, -1 };
  for (int y = 0; y < 500; ++y)
    for (int x = 0; x < 900; ++x)
    {
      const double red = image->GetScalarComponentAsDouble(x, y, 0, 0),
                   green = image->GetScalarComponentAsDouble(x, y, 0, 1);
      if (red < 240 || green > 80)
        continue;
      box = { std::min(box[0], x), std::max(box[1], x), std::min(box[2], y), std::max(box[3], y) };
    }
  EXPECT_GT(box[1] - box[0], 200);
  EXPECT_NEAR(box[1] - box[0], box[3] - box[2], 3);
}

}
