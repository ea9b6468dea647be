#include "vtkVesicleSource.h"

#include "vtkfilters/Filters/MeshConversion.h"
#include "vtkfilters/Filters/VtkMessages.h"
#include "solver/mesh/MeshIntegrals.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkVesicleStepper.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>

namespace vesicle::test
{

namespace
{

double number(vtkPolyData* surface, const char* name)
{
  vtkDataArray* array = surface->GetFieldData()->GetArray(name);
  EXPECT_NE(array, nullptr) << name;
  return array ? array->GetComponent(0, 0) : NAN;
}

struct Asked
{
  const char* shape;
  double reduced_volume;
  int triangles;
};

}

// The dynamics measure the surface that they move, by quadrature on it.
TEST(Source, TheStepperHasTheReducedVolumeAskedFor)
{
  for (const auto& [basis, preset] :
    { std::pair(vtkVesicleSource::Loop, vtkVesicleStepper::Balanced),
      std::pair(vtkVesicleSource::Linear, vtkVesicleStepper::Fast) })
  {
    for (const auto& [shape, v, triangles] :
      { Asked{ "prolate", 0.8, 80 }, Asked{ "prolate", 0.8, 320 }, Asked{ "prolate", 0.95, 500 },
        Asked{ "oblate", 0.8, 120 }, Asked{ "oblate", 0.65, 320 }, Asked{ "discocyte", 0.65, 320 },
        Asked{ "ellipsoid", 0.9, 240 } })
    {
      vtkNew<vtkVesicleSource> source;
      source->SetShapeByName(shape);
      source->SetBasis(basis);
      source->SetReducedVolume(v);
      source->SetTriangles(triangles);
      source->SetSemiAxes(1, 2, 3);
      source->SetRadius(2);
      vtkNew<vtkVesicleStepper> stepper;
      stepper->SetInputConnection(source->GetOutputPort());
      stepper->SetPreset(preset);
      stepper->Update();
      SCOPED_TRACE(testing::Message() << shape << ' ' << triangles << " basis " << basis);
      for (vtkPolyData* output : { source->GetOutput(), stepper->GetOutput() })
      {
        EXPECT_NEAR(number(output, "Reduced_Volume"), v, 1e-6);
        EXPECT_EQ(number(output, "Surface_Basis"), basis);
      }
      EXPECT_NEAR(number(stepper->GetOutput(), "Volume"), 4 * std::numbers::pi / 3 * 8, 1e-6);
    }
  }
}

TEST(Source, FlatTrianglesHaveTheVolumeAndReducedVolumeAskedFor)
{
  vtkNew<vtkVesicleSource> source;
  source->SetBasis(vtkVesicleSource::Linear);
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
