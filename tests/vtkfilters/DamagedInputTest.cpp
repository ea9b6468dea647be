// Every filter answers a surface whose numbers can't be followed with an error and empty output.

#include "vtkfilters/Filters/MeshConversion.h"
#include "vtkfilters/Filters/SeriesWriter.h"
#include "vtkfilters/Filters/VtkMessages.h"

#include "solver/Errors.h"
#include "solver/mesh/shapes/GeodesicSphere.h"
#include "tests/support/TemporaryFolder.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"
#include "vtkVesicleCurvatureFilter.h"
#include "vtkVesicleForceFilter.h"
#include "vtkVesicleMeshWriter.h"
#include "vtkVesicleProbeFilter.h"
#include "vtkVesicleStepper.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

namespace vesicle::test
{
namespace
{

struct Damage
{
  std::string name;
  std::function<void(vtkPolyData*)> apply;
  std::string message;
};

void set_corner(vtkPolyData* surface, vtkIdType corner, vtkIdType point)
{
  surface->GetPolys()->GetConnectivityArray()->SetComponent(corner, 0, static_cast<double>(point));
}

void set_offset(vtkPolyData* surface, vtkIdType cell, vtkIdType offset)
{
  surface->GetPolys()->GetOffsetsArray()->SetComponent(cell, 0, static_cast<double>(offset));
}

void add_cells(vtkPolyData* surface, void (vtkPolyData::*set)(vtkCellArray*))
{
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({ 0, 1, 2, 400000000 });
  (surface->*set)(cells);
}

std::vector<Damage> damages()
{
  return {
    { "Huge", [](vtkPolyData* s) { set_corner(s, 5, 900000000); }, "face 1 uses point 900000000" },
    { "Negative", [](vtkPolyData* s) { set_corner(s, 0, -7); }, "face 0 uses point -7" },
    { "OnePast", [](vtkPolyData* s) { set_corner(s, 3, s->GetNumberOfPoints()); },
      "face 1 uses point 162" },
    { "DescendingOffsets", [](vtkPolyData* s) { set_offset(s, 4, 3); },
      "offset 4 of the polygons" },
    { "OffsetBeyond", [](vtkPolyData* s) { set_offset(s, 7, 1000000); }, "offset 7" },
    { "OffsetNegative", [](vtkPolyData* s) { set_offset(s, 0, -5); }, "offset 0" },
    { "Strip", [](vtkPolyData* s) { add_cells(s, &vtkPolyData::SetStrips); },
      "uses point 400000000" },
    { "NotANumber",
      [](vtkPolyData* s)
      { s->GetPoints()->SetPoint(9, 0, std::numeric_limits<double>::quiet_NaN(), 0); },
      "point 9 is" },
    { "Infinite",
      [](vtkPolyData* s)
      { s->GetPoints()->SetPoint(9, std::numeric_limits<double>::infinity(), 0, 0); },
      "point 9 is" },
    { "TooFar", [](vtkPolyData* s) { s->GetPoints()->SetPoint(9, 0, 1e200, 0); }, "point 9 is" },
    { "NoOffsets", [](vtkPolyData* s) { s->GetPolys()->GetOffsetsArray()->Resize(0); },
      "of the polygons are listed, but no offsets" },
    { "NoPoints", [](vtkPolyData* s) { s->SetPoints(vtkNew<vtkPoints>()); },
      "there are no points" },
    { "ShortArray",
      [](vtkPolyData* s)
      {
        vtkNew<vtkDoubleArray> values;
        values->SetName("short");
        values->SetNumberOfTuples(3);
        s->GetPointData()->AddArray(values);
      },
      "the array short has 3 values for 162 points" },
    { "Narrow",
      [](vtkPolyData* s)
      {
        s->GetPolys()->ConvertTo32BitStorage();
        set_corner(s, 5, 900000000);
      },
      "face 1 uses point 900000000" },
  };
}

class DamagedInput : public testing::TestWithParam<Damage>
{
protected:
  DamagedInput()
  {
    surface_ = to_polydata(geodesic_sphere(4));
    GetParam().apply(surface_);
  }

  void expect_refused(vtkAlgorithm* filter)
  {
    const VtkMessages messages;
    filter->Update();
    EXPECT_NE(messages.first_error().find(GetParam().message), std::string::npos)
      << messages.first_error();
    if (auto* output = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0)))
    {
      EXPECT_EQ(output->GetNumberOfPoints(), 0);
      EXPECT_EQ(output->GetNumberOfCells(), 0);
    }
  }

  vtkSmartPointer<vtkPolyData> surface_;
};

}

TEST_P(DamagedInput, IsRefusedByTheCurvatureFilter)
{
  vtkNew<vtkVesicleCurvatureFilter> filter;
  filter->SetInputData(surface_);
  expect_refused(filter);
}

TEST_P(DamagedInput, IsRefusedByTheForceFilter)
{
  vtkNew<vtkVesicleForceFilter> filter;
  filter->SetInputData(surface_);
  expect_refused(filter);
}

TEST_P(DamagedInput, IsRefusedByTheStepper)
{
  vtkNew<vtkVesicleStepper> stepper;
  stepper->SetInputData(surface_);
  expect_refused(stepper);
}

TEST_P(DamagedInput, IsRefusedByTheProbeFilterAsItsSource)
{
  vtkNew<vtkPolyData> where;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0, 0, 0);
  where->SetPoints(points);
  vtkNew<vtkVesicleProbeFilter> probe;
  probe->SetInputData(where);
  probe->SetSourceData(surface_);
  expect_refused(probe);
}

TEST_P(DamagedInput, IsRefusedByTheWriters)
{
  const TemporaryFolder folder;
  for (const char* name :
    { "mesh.vtu", "mesh.vtp", "mesh.vtk", "mesh.stl", "mesh.ply", "mesh.obj", "mesh.off" })
  {
    const VtkMessages messages;
    vtkNew<vtkVesicleMeshWriter> writer;
    writer->SetInputData(surface_);
    writer->SetFileName((folder / name).c_str());
    writer->Write();
    EXPECT_NE(messages.first_error().find(GetParam().message), std::string::npos)
      << messages.first_error();
    EXPECT_FALSE(std::filesystem::exists(folder / name));
  }
  SeriesWriter series(folder.path(), "series");
  EXPECT_THROW(series.append(surface_, 0), InputError);
}

TEST(SurplusValues, AreLeftOut)
{
  const auto surface = to_polydata(geodesic_sphere(4));
  vtkNew<vtkDoubleArray> of_points, of_cells;
  for (vtkDoubleArray* array : { of_points.Get(), of_cells.Get() })
  {
    array->SetName("long");
    for (int i = 0; i < 1000; ++i)
      array->InsertNextValue(i);
  }
  surface->GetPointData()->SetScalars(of_points);
  surface->GetCellData()->AddArray(of_cells);
  const auto triangles = triangulated(surface);
  EXPECT_EQ(of_points->GetNumberOfTuples(), 1000);
  ASSERT_NE(triangles->GetPointData()->GetScalars(), nullptr);
  EXPECT_EQ(triangles->GetPointData()->GetScalars()->GetNumberOfTuples(), 162);
  EXPECT_EQ(triangles->GetPointData()->GetScalars()->GetComponent(161, 0), 161);
  EXPECT_EQ(triangles->GetCellData()->GetArray("long")->GetNumberOfTuples(), 320);
}

INSTANTIATE_TEST_SUITE_P(Kinds, DamagedInput, testing::ValuesIn(damages()),
  [](const auto& damage) { return damage.param.name; });

}
