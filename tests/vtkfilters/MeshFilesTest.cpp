#include "vtkfilters/Filters/MeshFiles.h"

#include "TemporaryFolder.h"

#include "vtkfilters/Filters/MeshConversion.h"

#include "solver/Errors.h"
#include "solver/mesh/io/TextMeshes.h"
#include "solver/mesh/shapes/Shapes.h"
#include "tests/solver/support/FullDisk.h"

#include "vtkPolyData.h"

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
  return ending == ".stl" || ending == ".ply";
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

TEST(Off, ReadsCommentsPolygonsAndColours)
{
  const TriangleMesh mesh =
    parse_off("# a square\nOFF\n4 1 4\n0 0 0\n1 0 0 # corner\n1 1 0\n0 1 0\n"
              "4 0 1 2 3 255 0 0\n",
      "square.off");
  EXPECT_EQ(mesh.triangles.rows(), 2);
  EXPECT_DOUBLE_EQ(flat_area(mesh), 1);
}

TEST(Obj, ReadsFacesWithTextureAndCountsBackwards)
{
  const TriangleMesh mesh =
    parse_obj("# a square\nmtllib none.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\n"
              "vn 0 0 1\nf 1/1/1 2/1/1 3//1\nv 0 1 0\nf 1 -2 -1\n",
      "square.obj");
  EXPECT_EQ(mesh.points.rows(), 4);
  EXPECT_DOUBLE_EQ(flat_area(mesh), 1);
  EXPECT_THROW(parse_obj("v 0 0 0\nf 1 2 3\n", "bad.obj"), InputError);
}

TEST(Off, ErrorsNameTheLine)
{
  try
  {
    parse_off("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n", "bad.off");
    FAIL();
  }
  catch (const InputError& error)
  {
    EXPECT_NE(std::string(error.what()).find("bad.off:6: there is no point 7"), std::string::npos)
      << error.what();
  }
}

}
