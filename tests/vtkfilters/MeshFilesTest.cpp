#include "vtkfilters/Filters/MeshFiles.h"

#include "vtkfilters/Filters/MeshConversion.h"

#include "solver/Errors.h"
#include "solver/mesh/MeshIntegrals.h"
#include "solver/mesh/Topology.h"
#include "solver/mesh/shapes/GeodesicSphere.h"
#include "tests/solver/support/FullDisk.h"
#include "tests/support/TemporaryFolder.h"

#include "vtkBitArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <fstream>

namespace vesicle::test
{
namespace
{

class MeshFiles : public testing::TestWithParam<const char*>
{
};

std::string message_of_reading(const std::filesystem::path& file)
{
  try
  {
    read_mesh(file);
  }
  catch (const InputError& error)
  {
    return error.what();
  }
  return "no InputError";
}

bool holds_single_precision(const std::string& ending)
{
  return ending == ".stl";
}

}

TEST_P(MeshFiles, ComeBackAsTheyWere)
{
  const TemporaryFolder folder;
  const TriangleMesh mesh = geodesic_sphere(3);
  const auto file = folder / (std::string("mesh") + GetParam());
  write_mesh(to_polydata(mesh), file);
  const TriangleMesh back = to_mesh(read_mesh(file));
  ASSERT_EQ(back.points.rows(), mesh.points.rows());
  ASSERT_EQ(back.triangles.rows(), mesh.triangles.rows());
  const double tolerance = holds_single_precision(GetParam()) ? 1e-6 : 0;
  EXPECT_NEAR(flat_volume(back), flat_volume(mesh), tolerance + 1e-15);
  if (tolerance == 0)
  {
    EXPECT_EQ(back.points, mesh.points);
    EXPECT_EQ(back.triangles, mesh.triangles);
  }
  EXPECT_TRUE(topology(back).closed);
}

TEST_P(MeshFiles, AFullDiskIsAnIoErrorAndLeavesNothing)
{
  const TemporaryFolder folder;
  const FullDisk full(500);
  EXPECT_THROW(
    write_mesh(to_polydata(geodesic_sphere(8)), folder / (std::string("mesh") + GetParam())),
    IoError);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

INSTANTIATE_TEST_SUITE_P(
  Endings, MeshFiles, testing::Values(".vtu", ".vtp", ".vtk", ".stl", ".ply", ".obj", ".off"));

TEST_P(MeshFiles, KeepBitsOfSeveralComponentsAndArraysWithoutValues)
{
  if (!keeps_field_data(std::string("mesh") + GetParam()))
  {
    GTEST_SKIP() << "no field data";
  }
  const TemporaryFolder folder;
  const auto file = folder / (std::string("mesh") + GetParam());
  const auto surface = to_polydata(geodesic_sphere(2));
  const vtkIdType points = surface->GetNumberOfPoints();
  vtkNew<vtkBitArray> bits, none;
  bits->SetName("bits");
  bits->SetNumberOfComponents(3);
  bits->SetNumberOfTuples(points);
  for (vtkIdType i = 0; i < 3 * points; ++i)
  {
    bits->SetValue(i, i % 5 == 0);
  }
  surface->GetPointData()->SetVectors(bits);
  none->SetName("none");
  surface->GetFieldData()->AddArray(none);
  write_mesh(surface, file);
  EXPECT_EQ(surface->GetFieldData()->GetArray("none"), none) << "written, not changed";
  const auto again = read_mesh(file);
  vtkDataArray* back = again->GetPointData()->GetVectors();
  ASSERT_NE(back, nullptr);
  ASSERT_EQ(back->GetNumberOfTuples(), points);
  for (vtkIdType i = 0; i < 3 * points; ++i)
  {
    EXPECT_EQ(back->GetComponent(i / 3, static_cast<int>(i % 3)), i % 5 == 0) << i;
  }
}

TEST(MeshFilesLosses, AreSaid)
{
  const TemporaryFolder folder;
  TriangleMesh mesh = geodesic_sphere(2);
  const auto surface = to_polydata(mesh);
  const auto written = [&](const char* name) { return write_mesh(surface, folder / name); };
  for (const char* name :
    { "mesh.vtu", "mesh.vtp", "mesh.vtk", "mesh.stl", "mesh.ply", "mesh.obj" })
  {
    EXPECT_EQ(written(name), "") << name;
  }
  surface->GetPointData()->SetNormals(to_array("Normals", mesh.points));
  surface->GetPointData()->AddArray(
    to_array("Mean Curvature", Eigen::VectorXd(mesh.points.col(0))));
  surface->GetPointData()->AddArray(to_array("Force", mesh.points));
  surface->GetCellData()->AddArray(
    to_array("Side", Eigen::VectorXd::LinSpaced(mesh.triangles.rows(), 0, 1)));
  vtkNew<vtkStringArray> words;
  words->SetName("Words");
  words->InsertNextValue("vesicle");
  surface->GetFieldData()->AddArray(words);
  EXPECT_NE(written("mesh.stl").find("can't hold Normals, Mean Curvature, Force, Side, Words;"),
    std::string::npos)
    << written("mesh.stl");
  EXPECT_NE(written("mesh.off").find("Force"), std::string::npos);
  EXPECT_NE(
    written("mesh.obj").find("can't hold Mean Curvature, Force, Side, Words;"), std::string::npos);
  EXPECT_NE(written("mesh.ply").find("can't hold Words; .vtu"), std::string::npos);
  for (const char* name : { "mesh.vtu", "mesh.vtp", "mesh.vtk" })
  {
    EXPECT_EQ(written(name), "");
    const auto again = read_mesh(folder / name);
    auto* text = vtkStringArray::SafeDownCast(again->GetFieldData()->GetAbstractArray("Words"));
    ASSERT_NE(text, nullptr) << name;
    EXPECT_EQ(text->GetValue(0), "vesicle");
  }
  const auto back = read_mesh(folder / "mesh.ply");
  ASSERT_NE(back->GetPointData()->GetArray("Mean_Curvature"), nullptr);
  EXPECT_EQ(
    back->GetPointData()->GetArray("Mean_Curvature")->GetComponent(7, 0), mesh.points(7, 0));
  ASSERT_NE(back->GetPointData()->GetArray("Force"), nullptr);
  EXPECT_EQ(back->GetPointData()->GetArray("Force")->GetComponent(7, 2), mesh.points(7, 2));
  ASSERT_NE(back->GetPointData()->GetNormals(), nullptr);
  ASSERT_NE(back->GetCellData()->GetArray("Side"), nullptr);
  EXPECT_EQ(back->GetCellData()->GetArray("Side")->GetComponent(mesh.triangles.rows() - 1, 0), 1);
}

TEST(MeshFilesLosses, AreNotTheColoursOfObjPoints)
{
  const TemporaryFolder folder;
  const auto surface = to_polydata(geodesic_sphere(2));
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetName("RGB");
  colours->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
    colours->InsertNextTuple3(static_cast<double>(i), 51, 255);
  surface->GetPointData()->AddArray(colours);
  EXPECT_EQ(write_mesh(surface, folder / "mesh.obj"), "");
  const auto back = read_mesh(folder / "mesh.obj");
  vtkDataArray* array = back->GetPointData()->GetArray("RGB");
  ASSERT_NE(array, nullptr);
  for (vtkIdType i = 0; i < back->GetNumberOfPoints(); ++i)
  {
    EXPECT_FLOAT_EQ(array->GetComponent(i, 0), i / 255.0f);
    EXPECT_FLOAT_EQ(array->GetComponent(i, 1), 0.2f);
    EXPECT_FLOAT_EQ(array->GetComponent(i, 2), 1.0f);
  }
}

TEST(MeshFilesLosses, CoordinatesBeyondSinglePrecisionAreNoStl)
{
  const TemporaryFolder folder;
  TriangleMesh mesh = geodesic_sphere(2);
  mesh.points *= 1e40;
  EXPECT_THROW(write_mesh(to_polydata(mesh), folder / "large.stl"), InputError);
  EXPECT_FALSE(std::filesystem::exists(folder / "large.stl"));
  EXPECT_EQ(write_mesh(to_polydata(mesh), folder / "large.ply"), "");
  EXPECT_EQ(to_mesh(read_mesh(folder / "large.ply")).points, mesh.points);
}

TEST(MeshFilesLosses, OfShapeFarFromTheOriginAreSaid)
{
  const TemporaryFolder folder;
  TriangleMesh mesh = geodesic_sphere(2);
  mesh.points.array() += 1e6;
  EXPECT_NE(
    write_mesh(to_polydata(mesh), folder / "far.stl").find("single precision"), std::string::npos);
  EXPECT_EQ(write_mesh(to_polydata(mesh), folder / "far.ply"), "");
  EXPECT_EQ(to_mesh(read_mesh(folder / "far.ply")).points, mesh.points);
}

TEST(MeshFilesErrors, SayWhatIsWrong)
{
  const TemporaryFolder folder;
  EXPECT_NE(message_of_reading(folder / "mesh.xyz").find(".vtu .vtp"), std::string::npos);
  EXPECT_NE(message_of_reading(folder / "none.vtu").find("no such file"), std::string::npos);
  std::ofstream(folder / "broken.vtu") << "<VTKFile type=\"Unstr";
  EXPECT_NE(message_of_reading(folder / "broken.vtu").find("broken.vtu"), std::string::npos);
  std::ofstream(folder / "empty.stl") << "";
  EXPECT_NE(message_of_reading(folder / "empty.stl").find("empty.stl"), std::string::npos);
}

TEST(MeshFilesErrors, WritingNowhereIsAnIoError)
{
  const TemporaryFolder folder;
  const auto surface = to_polydata(geodesic_sphere(1));
  for (const char* name : { "none/mesh.vtu", "none/mesh.stl", "none/mesh.off" })
  {
    EXPECT_THROW(write_mesh(surface, folder / name), IoError) << name;
  }
}

}
