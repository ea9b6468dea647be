#include "solver/mesh/io/ObjFile.h"
#include "solver/mesh/io/OffFile.h"

#include "solver/mesh/MeshIntegrals.h"
#include "tests/solver/mesh/io/SampleFiles.h"

#include <gmock/gmock.h>

namespace vesicle::test
{
namespace
{

using testing::HasSubstr;

double area_of(const std::string& text)
{
  return flat_area(mesh_of(read_obj(text, "mesh.obj")));
}

}

TEST(ObjFile, ReadsFacesWithTextureAndCountsBackwards)
{
  const SurfaceFile file =
    read_obj("# a square\nmtllib none.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\n"
             "vn 0 0 1\nf 1/1/1 2/1/1 3//1\nv 0 1 0\nf 1 -2 -1\n",
      "square.obj");
  EXPECT_EQ(file.points.rows(), 4);
  EXPECT_DOUBLE_EQ(flat_area(mesh_of(file)), 1);
}

TEST(ObjFile, LosesNeitherItsFirstPointNorLinesThatGoOn)
{
  const std::string plain = obj_sample(l_prism_points(), l_prism_faces());
  EXPECT_NEAR(area_of("\xef\xbb\xbf" + plain), 14, 1e-14);
  std::string continued;
  int blanks = 0;
  for (const char c : plain)
    continued += c == ' ' && ++blanks % 2 == 0 ? std::string(" \\\n ") : std::string(1, c);
  EXPECT_NEAR(area_of(continued), 14, 1e-14);
  std::string dos;
  for (const char c : continued)
    dos += c == '\n' ? std::string("\r\n") : std::string(1, c);
  EXPECT_NEAR(area_of(dos), 14, 1e-14);
  std::string mac = continued;
  std::replace(mac.begin(), mac.end(), '\n', '\r');
  EXPECT_NEAR(area_of(mac), 14, 1e-14);
}

TEST(ObjFile, ReadsWeightsColoursGroupsAndFacesBeforeTheirPoints)
{
  EXPECT_DOUBLE_EQ(
    area_of("o a\ng b\ns off\nf 1 2 3\nv 0 0 0 1\nv 1 0 0 0.5 0.5 0.5\nv 0 +1.0e0 0\nl 1 2\n"),
    0.5);
}

TEST(ObjFile, KeepsColoursThatAllPointsHave)
{
  const auto colours_of = [](const std::string& text)
  {
    const SurfaceFile file = read_obj(text, "mesh.obj");
    return file.point_data.empty() ? std::vector<float>()
                                   : std::get<std::vector<float>>(file.point_data[0].values);
  };
  const std::string face = "f 1 2 3\n";
  EXPECT_EQ(colours_of("v 0 0 0 1 .5 0\nv 1 0 0 1 0 1 .25\nv 0 1 0 0 0 1\n" + face),
    (std::vector<float>{ 1, .5f, 0, 0, 1, .25f, 0, 0, 1 }));
  EXPECT_TRUE(colours_of("v 0 0 0 1 .5 0\nv 1 0 0\nv 0 1 0 0 0 1\n" + face).empty());
  EXPECT_TRUE(colours_of("v 0 0 0 1\nv 1 0 0 1\nv 0 1 0 1\n" + face).empty());
}

TEST(ObjFile, SaysWhatIsWrong)
{
  EXPECT_THAT(message_of(read_obj, "v 0 0 0\nf 1 2 3\n"),
    HasSubstr("face 1 uses point 2, but the points are numbered 1 to 1"));
  EXPECT_THAT(message_of(read_obj, "v 0 0 0\nf 1 1 -2\n"), HasSubstr("mesh:2: "));
  EXPECT_THAT(message_of(read_obj, "v 0 0\n"), HasSubstr("mesh:1: "));
  EXPECT_THAT(message_of(read_obj, "v 0 0 0\nf 0 1 1\n"), HasSubstr("counted from 1"));
  EXPECT_THAT(message_of(read_obj, "v 0 0 0\nw 0 0 0\n"), HasSubstr("mesh:2: "));
  EXPECT_THAT(message_of(read_obj, "v 0 0,5 0\n"), HasSubstr("'0,5' stands where a coordinate"));
}

TEST(TextMeshes, ReadBackAsTheyWereToTheLastDigit)
{
  TriangleMesh mesh{ Points(4, 3), Triangles(4, 3) };
  mesh.points << 0, 0, 0, 1. / 3, 0, 0, 0, 1e-300, 0, 0, 0, -2.5e17;
  mesh.triangles << 0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2;
  for (const SurfaceFile& again : { read_off(off_text(mesh), "mesh.off"),
         read_obj(obj_text(mesh), "mesh.obj"), read_obj(obj_text(mesh, mesh.points), "mesh.obj") })
  {
    EXPECT_EQ(again.points, mesh.points);
    EXPECT_EQ(mesh_of(again).triangles, mesh.triangles);
  }
}

}
