// Centroids, which the camera follows; which surfaces hide their inner side.

#include "TestSurfaces.h"

#include "render/SurfaceMeasures.h"
#include "solver/Errors.h"

#include "vtkAppendPolyData.h"
#include "vtkReverseSense.h"

#include <gtest/gtest.h>

using namespace vesicle;
using namespace vesicle::test;

namespace
{

vtkSmartPointer<vtkPolyData> together(vtkPolyData* a, vtkPolyData* b)
{
  vtkNew<vtkAppendPolyData> both;
  both->AddInputData(a);
  both->AddInputData(b);
  both->Update();
  return both->GetOutput();
}

}

TEST(SurfaceCentroid, IsThatOfTheVolume)
{
  const Point3 center = surface_centroid(make_surface(50));
  EXPECT_NEAR(center[0], 50, 1e-10);
  EXPECT_NEAR(center[1], 0, 1e-10);
  EXPECT_NEAR(center[2], 100, 1e-10);
}

TEST(SurfaceCentroid, OfAnOpenSurfaceIsThatOfItsArea)
{
  vtkNew<vtkSphereSource> bowl; // the lower half: area centroid at −1/2
  bowl->SetRadius(1);
  bowl->SetStartPhi(90);
  bowl->SetThetaResolution(100);
  bowl->SetPhiResolution(100);
  bowl->Update();
  EXPECT_NEAR(surface_centroid(bowl->GetOutput())[2], -0.5, 1e-3);
}

TEST(SurfaceCentroid, NeedsTriangles)
{
  EXPECT_THROW(surface_centroid(vtkNew<vtkPolyData>()), InputError);
}

TEST(CentroidVelocity, IsTheTranslationOfATurningBody)
{
  const auto surface = make_surface(5); // turns about its centroid and rises with speed 1
  const Point3 u = centroid_velocity(surface, surface->GetPointData()->GetArray("Velocity"));
  EXPECT_NEAR(u[0], 0, 0.02);
  EXPECT_NEAR(u[1], 0, 0.02);
  EXPECT_NEAR(u[2], 1, 0.02); // the facets are flat
}

TEST(HidesItsInside, ABodyDoes)
{
  EXPECT_TRUE(hides_its_inside(make_surface()));
  EXPECT_TRUE(hides_its_inside(make_surface(50)));
}

TEST(HidesItsInside, WhatIsOpenOrInsideOutOrCrossedDoesNot)
{
  vtkNew<vtkSphereSource> bowl;
  bowl->SetStartPhi(90);
  bowl->Update();
  EXPECT_FALSE(hides_its_inside(bowl->GetOutput()));
  vtkNew<vtkReverseSense> inside_out;
  inside_out->SetInputData(make_surface());
  inside_out->Update();
  EXPECT_FALSE(hides_its_inside(inside_out->GetOutput()));
  EXPECT_TRUE(hides_its_inside(together(make_surface(), make_surface(10))));
  EXPECT_FALSE(hides_its_inside(together(make_surface(10), inside_out->GetOutput())));
  const auto pierced = make_surface(); // its tip is pulled through it
  vtkIdType tip = 0;
  for (vtkIdType i = 0; i < pierced->GetNumberOfPoints(); ++i)
  {
    tip = pierced->GetPoint(i)[0] > pierced->GetPoint(tip)[0] ? i : tip;
  }
  pierced->GetPoints()->SetPoint(tip, -3, 0, 0);
  EXPECT_FALSE(hides_its_inside(pierced));
  EXPECT_FALSE(hides_its_inside(vtkNew<vtkPolyData>()));
}
