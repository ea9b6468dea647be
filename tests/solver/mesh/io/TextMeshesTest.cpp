#include "solver/mesh/io/TextMeshes.h"

#include "solver/Errors.h"
#include "solver/mesh/MeshIntegrals.h"

#include <gtest/gtest.h>

namespace vesicle
{

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

TEST(TextMeshes, ReadBackAsTheyWereToTheLastDigit)
{
  TriangleMesh mesh{ Points(4, 3), Triangles(4, 3) };
  mesh.points << 0, 0, 0, 1. / 3, 0, 0, 0, 1e-300, 0, 0, 0, -2.5e17;
  mesh.triangles << 0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2;
  for (const TriangleMesh& again :
    { parse_off(off_text(mesh), "mesh.off"), parse_obj(obj_text(mesh), "mesh.obj") })
  {
    EXPECT_EQ(again.points, mesh.points);
    EXPECT_EQ(again.triangles, mesh.triangles);
  }
}

}
