#include "vtkfilters/Filters/SeriesWriter.h"

#include "vtkfilters/Filters/MeshConversion.h"
#include "vtkfilters/Filters/VtkMessages.h"

#include "solver/Errors.h"
#include "solver/files/FileBytes.h"
#include "solver/mesh/shapes/GeodesicSphere.h"
#include "tests/solver/support/FullDisk.h"
#include "tests/support/TemporaryFolder.h"

#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVesicleSeriesWriter.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLUnstructuredGridReader.h"
#include "vtkXMLUtilities.h"

#include <gtest/gtest.h>

namespace vesicle::test
{
namespace
{

vtkSmartPointer<vtkPolyData> surface()
{
  const TriangleMesh mesh = geodesic_sphere(2);
  auto result = to_polydata(mesh);
  result->GetPointData()->AddArray(to_array("Height", mesh.points.col(2)));
  vtkNew<vtkStringArray> text;
  text->SetName("text");
  text->InsertNextValue("some readers stop here");
  result->GetFieldData()->AddArray(text);
  return result;
}

vtkSmartPointer<vtkUnstructuredGrid> read_grid(const std::filesystem::path& file)
{
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  return reader->GetOutput();
}

void expect_series(const std::filesystem::path& file, const std::vector<double>& times)
{
  const auto frames = read_series(file);
  ASSERT_EQ(frames.size(), times.size()) << file;
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    EXPECT_EQ(frames[i].time, times[i]);
    EXPECT_EQ(read_grid(frames[i].file)->GetNumberOfCells(), 80);
  }
}

/// Times, and that the files named hold what is said of them.
void expect_xdmf(const std::filesystem::path& file, const std::vector<double>& times)
{
  const auto root =
    vtk::TakeSmartPointer(vtkXMLUtilities::ReadElementFromString(read_file(file).c_str()));
  ASSERT_TRUE(root);
  auto* collection = root->FindNestedElementWithName("Domain")->FindNestedElementWithName("Grid");
  ASSERT_EQ(collection->GetNumberOfNestedElements(), static_cast<int>(times.size()));
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    auto* grid = collection->GetNestedElement(static_cast<int>(i));
    double time = -1;
    grid->FindNestedElementWithName("Time")->GetScalarAttribute("Value", time);
    EXPECT_EQ(time, times[i]);
    const std::string points = grid->FindNestedElementWithName("Geometry")
                                 ->FindNestedElementWithName("DataItem")
                                 ->GetCharacterData();
    const auto frame = file.parent_path() / points.substr(0, points.find(':'));
    EXPECT_EQ(read_frame_layout(frame).points, 42) << frame;
  }
}

}

TEST(SeriesWriter, IsValidAfterEveryFrame)
{
  const TemporaryFolder folder;
  SeriesWriter series(folder.path(), "a & b");
  std::vector<double> times;
  for (const double time : { 0.0, 0.1, 1.0 / 3 })
  {
    series.append(surface(), time);
    times.push_back(time);
    expect_series(series.pvd_file(), times);
    expect_series(series.series_file(), times);
    expect_xdmf(series.xdmf_file(), times);
  }
}

TEST(SeriesWriter, AFullDiskLeavesTheSeriesAsItWas)
{
  const TemporaryFolder folder;
  SeriesWriter series(folder.path(), "run");
  series.append(surface(), 0);
  for (const rlim_t bytes : { 2000, 6000 }) // less than the frame's files take, and than one does
  {
    {
      const FullDisk full(bytes);
      EXPECT_THROW(series.append(surface(), 1), IoError);
    }
    expect_series(series.series_file(), { 0 });
    expect_xdmf(series.xdmf_file(), { 0 });
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path()))
    {
      EXPECT_EQ(entry.path().string().find(".part"), std::string::npos) << entry.path();
    }
  }
  series.append(surface(), 1);
  expect_xdmf(series.xdmf_file(), { 0, 1 });
}

TEST(SeriesWriter, FramesAreGridsInDoublePrecisionThatKnowTheirTime)
{
  const TemporaryFolder folder;
  SeriesWriter series(folder.path(), "run");
  series.append(surface(), 0.1);
  const auto grid = read_grid(folder / "frames/run_000000.vtu");
  EXPECT_EQ(grid->GetPoints()->GetDataType(), VTK_DOUBLE);
  EXPECT_EQ(grid->GetCellType(0), VTK_TRIANGLE);
  EXPECT_TRUE(grid->GetPointData()->HasArray("Height"));
  ASSERT_TRUE(grid->GetFieldData()->HasArray("TimeValue"));
  EXPECT_EQ(grid->GetFieldData()->GetArray("TimeValue")->GetComponent(0, 0), 0.1);
  EXPECT_FALSE(grid->GetFieldData()->HasArray("text"));
}

TEST(SeriesWriter, KeepsAndGoesOn)
{
  const TemporaryFolder folder;
  SeriesWriter first(folder.path(), "run");
  for (const double time : { 0.0, 0.1, 0.2, 0.25 })
  {
    first.append(surface(), time);
  }
  SeriesWriter second(folder.path(), "run");
  second.keep({ 0.0, 0.1 }, surface());
  expect_series(second.pvd_file(), { 0.0, 0.1 });
  expect_xdmf(second.xdmf_file(), { 0.0, 0.1 });
  for (const char* name : { "run_000002.vtu", "run_000003.vtu", "run_000002.h5", "run_000003.h5" })
  {
    EXPECT_FALSE(std::filesystem::exists(folder / "frames" / name));
  }
  second.append(surface(), 0.3);
  expect_series(second.series_file(), { 0.0, 0.1, 0.3 });
  expect_xdmf(second.xdmf_file(), { 0.0, 0.1, 0.3 });
}

TEST(SeriesWriter, MissingFramesAreNoticed)
{
  const TemporaryFolder folder;
  SeriesWriter series(folder.path(), "run");
  series.append(surface(), 0);
  SeriesWriter again(folder.path(), "run");
  again.require_frames(1);
  EXPECT_THROW(again.require_frames(2), InputError);
  EXPECT_THROW(again.keep({ 0, 1 }, surface()), InputError);
  std::filesystem::remove(folder / "frames/run_000000.h5");
  EXPECT_THROW(again.keep({ 0 }, surface()), InputError);
}

TEST(SeriesWriter, NowhereToWriteIsAnIoError)
{
  const TemporaryFolder folder;
  replace_file(folder / "file", "in the way");
  SeriesWriter series(folder / "file", "run");
  EXPECT_THROW(series.append(surface(), 0), IoError);
}

TEST(SeriesWriter, AsAnAlgorithmWritesAFrameEachTime)
{
  const TemporaryFolder folder;
  vtkNew<vtkVesicleSeriesWriter> writer;
  const auto frame = surface();
  writer->SetInputData(frame);
  const VtkMessages messages;
  writer->Write();
  EXPECT_EQ(writer->GetErrorCode(), vtkErrorCode::NoFileNameError);
  writer->SetFileName((folder / "new/run.pvd").c_str());
  writer->Write();
  EXPECT_EQ(writer->GetErrorCode(), vtkErrorCode::CannotOpenFileError) << "no time";
  for (const double time : { 0.5, 1.5 })
  {
    frame->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
    writer->Write();
    EXPECT_EQ(writer->GetErrorCode(), vtkErrorCode::NoError);
  }
  expect_series(folder / "new/run.pvd", { 0.5, 1.5 });
  expect_series(folder / "new/run.vtu.series", { 0.5, 1.5 });

  vtkNew<vtkDoubleArray> value;
  value->SetName("TimeValue");
  value->InsertNextValue(2.5);
  frame->GetFieldData()->AddArray(value);
  writer->Write();
  expect_series(folder / "new/run.pvd", { 0.5, 1.5, 2.5 });
  writer->SetFileName((folder / "other.pvd").c_str());
  writer->Write();
  expect_series(folder / "other.pvd", { 2.5 });
}

}
