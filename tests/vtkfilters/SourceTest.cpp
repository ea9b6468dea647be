#include "vtkVesicleSource.h"

#include "vtkfilters/Filters/MeshConversion.h"
#include "vtkfilters/Filters/VtkMessages.h"

#include "vtkNew.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vesicle::test
{

TEST(Source, HasTheVolumeAndReducedVolumeAskedFor)
{
  vtkNew<vtkVesicleSource> source;
  source->SetShapeByName("prolate");
  source->SetReducedVolume(0.9);
  source->SetRadius(2);
  source->SetCenter(1, 2, 3);
  source->SetTriangles(320);
  source->Update();
  const TriangleMesh mesh = to_mesh(source->GetOutput());
  EXPECT_EQ(mesh.triangles.rows(), 320);
  EXPECT_EQ(source->GetOutput()->GetPoints()->GetDataType(), VTK_DOUBLE);
  const double volume = flat_volume(mesh);
  EXPECT_NEAR(volume, 4 * std::numbers::pi / 3 * 8, 1e-6);
  EXPECT_NEAR(reduced_volume(flat_area(mesh), volume), 0.9, 1e-6);
  EXPECT_NEAR((volume_centroid(mesh) - Vector3(1, 2, 3)).norm(), 0, 1e-6);
}

TEST(Source, AxisTurnsTheLongAxis)
{
  vtkNew<vtkVesicleSource> source;
  source->SetShape(vtkVesicleSource::Prolate);
  source->SetReducedVolume(0.8);
  source->SetTriangles(320);
  source->SetAxis(3, 0, 0);
  source->Update();
  double bounds[6];
  source->GetOutput()->GetBounds(bounds);
  EXPECT_GT(bounds[1], 1.3 * bounds[3]);
  EXPECT_NEAR(bounds[3], bounds[5], 0.1);
}

TEST(Source, PerturbedNeedsItsModes)
{
  vtkNew<vtkVesicleSource> source;
  source->SetShapeByName("perturbed");
  source->SetTriangles(320);
  source->AddMode(2, 0, 0.1);
  EXPECT_EQ(source->GetNumberOfModes(), 1);
  source->Update();
  EXPECT_EQ(source->GetOutput()->GetNumberOfPolys(), 320);
}

TEST(Source, ImpossibleRequestsAreErrors)
{
  const VtkMessages messages;
  vtkNew<vtkVesicleSource> source;
  source->SetShapeByName("cube");
  EXPECT_NE(messages.first_error().find("discocyte"), std::string::npos);
  EXPECT_EQ(source->GetShape(), vtkVesicleSource::Sphere);
  source->SetRadius(-1);
  source->Update();
  EXPECT_EQ(source->GetOutput()->GetNumberOfPolys(), 0);
}

}
