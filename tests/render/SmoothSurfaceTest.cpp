// The limit surface through the vertices.

#include "TestSurfaces.h"

#include "render/SmoothSurface.h"
#include "solver/mesh/shapes/Shapes.h"
#include "vtkfilters/Filters/MeshConversion.h"

#include "vtkFeatureEdges.h"

#include <gtest/gtest.h>

using namespace vesicle;
using namespace vesicle::test;

namespace
{

/// With the array Height, which is z.
vtkSmartPointer<vtkPolyData> sphere(int triangles)
{
  ShapeRequest request;
  request.kind = ShapeRequest::Kind::sphere;
  request.triangles = triangles;
  TriangleMesh mesh = make_shape(request);
  mesh.points.rowwise().normalize();
  auto surface = to_polydata(mesh);
  surface->GetPointData()->AddArray(to_array("Height", mesh.points.col(2)));
  return surface;
}

/// Largest distance from the unit sphere.
double error_of(vtkPolyData* surface)
{
  Point3 x;
  double largest = 0;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    surface->GetPoint(i, x.data());
    largest = std::max(largest, std::abs(std::hypot(x[0], x[1], x[2]) - 1));
  }
  return largest;
}

}

TEST(SmoothSurface, ComesCloserToASphereThanItsFacets)
{
  SmoothSurface smooth;
  const double coarse = error_of(smooth.refine(sphere(320), {}).surface);
  const double fine = error_of(smooth.refine(sphere(1280), {}).surface);
  // The middle of a facet of 320 is more than 1% of the radius inside.
  EXPECT_LT(coarse, 0.001);
  EXPECT_LT(fine, coarse / 4); // second order at least
}

TEST(SmoothSurface, PassesThroughTheVerticesAndKeepsTheirValues)
{
  const auto coarse = sphere(320);
  SmoothSurface smooth;
  const auto fine = smooth.refine(coarse, { "Height" }).surface;
  for (vtkIdType i = 0; i < coarse->GetNumberOfPoints(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_EQ(fine->GetPoint(i)[k], coarse->GetPoint(i)[k]);
    }
  }
  // What is linear in space stays so, everywhere.
  vtkDataArray* height = fine->GetPointData()->GetArray("Height");
  for (vtkIdType i = 0; i < fine->GetNumberOfPoints(); ++i)
  {
    EXPECT_NEAR(height->GetComponent(i, 0), fine->GetPoint(i)[2], 1e-12);
  }
}

TEST(SmoothSurface, IsClosedAndOutward)
{
  SmoothSurface smooth(20000);
  const SmoothMesh fine = smooth.refine(sphere(80), {});
  vtkNew<vtkFeatureEdges> open;
  open->SetInputData(fine.surface);
  open->FeatureEdgesOff();
  open->ManifoldEdgesOff();
  open->Update();
  EXPECT_EQ(open->GetOutput()->GetNumberOfCells(), 0);
  EXPECT_GE(fine.surface->GetNumberOfPolys(), 20000);
  EXPECT_EQ(fine.edges->GetNumberOfLines(), 120);
  vtkDataArray* normals = fine.surface->GetPointData()->GetNormals();
  for (vtkIdType i = 0; i < fine.surface->GetNumberOfPoints(); ++i)
  {
    Point3 x, n;
    fine.surface->GetPoint(i, x.data());
    normals->GetTuple(i, n.data());
    const double length = std::hypot(x[0], x[1], x[2]);
    EXPECT_NEAR(std::hypot(n[0], n[1], n[2]), 1, 1e-12);
    EXPECT_GT((x[0] * n[0] + x[1] * n[1] + x[2] * n[2]) / length, 0.99);
  }
}
