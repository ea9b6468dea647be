// Models for other programs: glTF read back by VTK's own reader, USD by its lines.

#include "render/Model.h"

#include "TestSurfaces.h"

#include "solver/files/FileBytes.h"
#include "vtkfilters/Filters/MeshConversion.h"

#include "vtkCompositeDataIterator.h"
#include "vtkDataArray.h"
#include "vtkGLTFReader.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <sstream>

namespace vesicle::test
{
namespace
{

constexpr double single_precision = 1e-6;

Model model(double shift = 0)
{
  return model_of(triangulated(make_surface(shift), "test"), "Mean_Curvature",
    { ColorMap::sequential, { -1, 1 }, 0 });
}

/// The line that follows "    name = ", or the first of time samples.
std::string value_in(const std::string& text, const std::string& name)
{
  const auto at = text.find("    " + name + " = ");
  return at == std::string::npos ? "" : text.substr(at, text.find('\n', at) - at);
}

std::size_t count(const std::string& text, char c)
{
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), c));
}

}

TEST(Model, IsSeenFromItsCentroid)
{
  const Model near = model(), far = model(1000);
  EXPECT_NEAR((far.place - near.place - Vector3(1000, 0, 2000)).norm(), 0, 1e-9);
  EXPECT_NEAR((far.points - near.points).norm(), 0, 1e-9);
}

TEST(Model, ColoursAreThoseOfTheScaleInLinearLight)
{
  const Model m = model();
  EXPECT_GE(m.colors.minCoeff(), 0);
  EXPECT_LE(m.colors.maxCoeff(), 1);
  // sRGB's .5 is .2140 of the light.
  const ColorScale scale{ ColorMap::sequential, { 0, 1 }, 0 };
  const auto table = colors_of_range(scale, 256);
  const double c = table.back()[0];
  const auto surface = triangulated(make_surface(), "test");
  vtkDataArray* values = surface->GetPointData()->GetArray("Mean_Curvature");
  values->Fill(1);
  EXPECT_NEAR(model_of(surface, "Mean_Curvature", scale).colors(0, 0),
    std::pow((c + .055) / 1.055, 2.4), 1e-12);
}

TEST(Model, GltfIsReadByVtk)
{
  const TemporaryFolder folder;
  const Model m = model(3);
  replace_file(folder / "model.gltf", gltf_text(m, "ellipsoid"));
  vtkNew<vtkGLTFReader> reader;
  reader->SetFileName((folder / "model.gltf").c_str());
  reader->Update();
  auto block = vtk::TakeSmartPointer(reader->GetOutput()->NewIterator());
  block->InitTraversal();
  ASSERT_FALSE(block->IsDoneWithTraversal());
  auto* surface = vtkPolyData::SafeDownCast(block->GetCurrentDataObject());
  ASSERT_TRUE(surface);
  ASSERT_EQ(surface->GetNumberOfPoints(), m.points.rows());
  ASSERT_EQ(surface->GetNumberOfPolys(), m.triangles.rows());
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    const Vector3 at = m.points.row(i).transpose() + m.place;
    const Vector3 found(surface->GetPoint(i));
    EXPECT_NEAR((found - Vector3(at[0], at[2], -at[1])).norm(), 0, 10 * single_precision);
  }
  vtkDataArray* colors = surface->GetPointData()->GetArray("COLOR_0");
  ASSERT_TRUE(colors);
  EXPECT_NEAR(colors->GetComponent(5, 1), m.colors(5, 1), single_precision);
}

TEST(Model, UsdHasWhatChangesForEachFrame)
{
  const Model first = model(), second = model(1);
  const std::string text = usd_text({ first, second }, "2 shapes");
  EXPECT_EQ(text.rfind("#usda 1.0\n", 0), 0);
  EXPECT_NE(text.find("def Mesh \"_2_shapes\""), std::string::npos);
  EXPECT_NE(text.find("endTimeCode = 1\n"), std::string::npos);
  EXPECT_NE(text.find("xformOp:translate.timeSamples = {"), std::string::npos);
  const std::string indices = value_in(text, "int[] faceVertexIndices");
  EXPECT_EQ(count(indices, ','), 3 * static_cast<std::size_t>(first.triangles.rows()) - 1);
  const std::string counts = value_in(text, "int[] faceVertexCounts");
  EXPECT_EQ(count(counts, '3'), static_cast<std::size_t>(first.triangles.rows()));
  EXPECT_EQ(count(text, '('), count(text, ')'));
  EXPECT_EQ(count(text, '{'), count(text, '}'));
}

TEST(Model, UsdOfOneFrameHasNoTime)
{
  const std::string text = usd_text({ model() }, "one");
  EXPECT_EQ(text.find("timeSamples"), std::string::npos);
  EXPECT_EQ(text.find("TimeCode"), std::string::npos);
  const std::string points = value_in(text, "point3f[] points");
  EXPECT_EQ(count(points, '('), static_cast<std::size_t>(model().points.rows()));
}

}
