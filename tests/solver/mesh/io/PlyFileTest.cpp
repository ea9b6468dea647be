#include "solver/mesh/io/PlyFile.h"

#include "solver/mesh/MeshIntegrals.h"
#include "tests/solver/mesh/io/SampleFiles.h"

#include <gmock/gmock.h>

namespace vesicle::test
{
namespace
{

using testing::HasSubstr;

std::string ply(const std::string& rest)
{
  return "ply\nformat ascii 1.0\n" + rest;
}

}

TEST(PlyFile, KeepsDoublePrecisionInEveryForm)
{
  Points points = l_prism_points();
  points.array() += 1e6 + 1. / 3;
  for (const std::string& bytes : { ply_sample(points, l_prism_faces(), "double"),
         binary_ply_sample(points, l_prism_faces(), std::endian::little, true),
         binary_ply_sample(points, l_prism_faces(), std::endian::big, true) })
  {
    const SurfaceFile file = read_ply(bytes, "far.ply");
    EXPECT_EQ(file.points, points);
    EXPECT_FALSE(file.single_precision);
  }
  EXPECT_TRUE(
    read_ply(binary_ply_sample(points, l_prism_faces(), std::endian::big, false), "near.ply")
      .single_precision);
}

TEST(PlyFile, TakesElementsAndPropertiesInAnyOrderAndOfAnyType)
{
  const SurfaceFile file = read_ply(
    ply("obj_info by hand\nelement face 1\nproperty list char float weights\nproperty uchar kind\n"
        "property list uint16 uint8 vertex_index\nelement material 1\nproperty float shine\n"
        "element nothing 1000000000000\nelement vertex 3\nproperty short y\nproperty float64 p_0\n"
        "property float64 p_1\nproperty float x\nproperty int z\nproperty uchar red\n"
        "property uchar green\nproperty uchar blue\nproperty list uchar int more\nend_header\n"
        "2 0.5 0.25 7 3 0 1 2\n0.5\n\n"
        "0 1 2 0 0 1 2 3 0\n0 3 4 1 0 4 5 6 1 9\n1 5 6 0 0 7 8 9 2 8 9\n"),
    "mixed.ply");
  EXPECT_DOUBLE_EQ(flat_area(mesh_of(file)), 0.5);
  ASSERT_EQ(file.cell_data.size(), 1U);
  EXPECT_EQ(file.cell_data[0].name, "kind");
  EXPECT_EQ(
    std::get<std::vector<std::uint8_t>>(file.cell_data[0].values), std::vector<std::uint8_t>{ 7 });
  ASSERT_EQ(file.point_data.size(), 2U);
  EXPECT_EQ(file.point_data[0].name, "p");
  EXPECT_EQ(std::get<std::vector<double>>(file.point_data[0].values),
    (std::vector<double>{ 1, 2, 3, 4, 5, 6 }));
  EXPECT_EQ(file.point_data[1].name, "RGB");
  EXPECT_EQ(file.point_data[1].components, 3);
}

TEST(PlyFile, ReadsStripsAndOtherEndsOfLines)
{
  std::string text = ply("element vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
                         "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
                         "0 0 0\n1 0 0\n0 1 0\n1 1 0\n5 0 1 2 3 -1\n");
  EXPECT_DOUBLE_EQ(flat_area(mesh_of(read_ply(text, "strip.ply"))), 1);
  std::replace(text.begin(), text.end(), '\n', '\r');
  EXPECT_DOUBLE_EQ(flat_area(mesh_of(read_ply(text, "strip.ply"))), 1);
}

TEST(PlyFile, SaysWhatIsWrong)
{
  const std::string head = "element vertex 3\nproperty float x\nproperty float y\n"
                           "property float z\nelement face 1\n"
                           "property list uchar int vertex_indices\nend_header\n";
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n";
  EXPECT_EQ(message_of(read_ply, ply(head + points + "3 0 1 2\n")), "no InputError");
  EXPECT_THAT(message_of(read_ply, ply(head + points + "3 0 1 3\n")),
    HasSubstr("face 0 uses point 3, but the points are numbered 0 to 2"));
  EXPECT_THAT(message_of(read_ply, ply(head + points + "3 0 1 -1\n")), HasSubstr("uses point -1"));
  EXPECT_THAT(message_of(read_ply, ply(head + points + "2 0 1\n")), HasSubstr("has 2 corners"));
  EXPECT_THAT(message_of(read_ply, ply(head + points + "3 0 1 2\n3 0 1 2\n")),
    HasSubstr("more than the header announces"));
  EXPECT_THAT(message_of(read_ply, ply(head + points)), HasSubstr("ends too early"));
  EXPECT_THAT(message_of(read_ply, ply("element vertex 900000000\nproperty float x\nend_header\n")),
    HasSubstr("ends too early"));
  EXPECT_THAT(message_of(read_ply, ply("element vertex 1\nproperty half x\nend_header\n")),
    HasSubstr("mesh:4: a type is needed"));
  EXPECT_THAT(message_of(read_ply, "solid\n"), HasSubstr("is not a PLY file"));
  EXPECT_THAT(message_of(read_ply, ply("end_header\n")), HasSubstr("no element 'vertex'"));
}

}
