#include "solver/mesh/io/GmshFile.h"

#include "solver/mesh/MeshIntegrals.h"
#include "solver/mesh/Topology.h"
#include "solver/mesh/shapes/GeodesicSphere.h"
#include "tests/solver/mesh/io/SampleFiles.h"

#include <gmock/gmock.h>

namespace vesicle::test
{
namespace
{

using testing::HasSubstr;

std::string elements_of(const std::string& nodes, const std::string& elements)
{
  return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" + nodes + "$EndNodes\n$Elements\n" +
    elements + "$EndElements\n";
}

const std::string square = "4\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n";

}

TEST(GmshFile, LeavesOutNodesThatNoTriangleUses)
{
  const Points points = l_prism_points();
  const Faces triangle{ { 2, 5, 7 } };
  const SurfaceFile file = read_gmsh(gmsh_sample(points, triangle, { true, false }), "mesh.msh");
  ASSERT_EQ(file.points.rows(), 3);
  EXPECT_EQ(file.points.row(0), points.row(2));
  EXPECT_EQ(file.points.row(2), points.row(7));
  EXPECT_EQ(file.polygons.cell, std::vector<std::int64_t>{ 2 }) << "behind a point and a line";
}

TEST(GmshFile, ReadsQuadrilaterals)
{
  EXPECT_DOUBLE_EQ(
    flat_area(mesh_of(read_gmsh(elements_of(square, "1\n1 3 2 1 1 1 2 3 4\n"), "mesh"))), 1);
}

// Corners, then the middles of the edges: four triangles that face the same way.
TEST(GmshFile, TrianglesOfSecondOrderBecomeFour)
{
  const std::string nodes = "6\n1 0 0 0\n2 2 0 0\n3 0 2 0\n4 1 0 0.5\n5 1 1 0\n6 0 1 0\n";
  const TriangleMesh mesh =
    mesh_of(read_gmsh(elements_of(nodes, "1\n1 9 2 1 1 1 2 3 4 5 6\n"), "mesh"));
  EXPECT_EQ(mesh.triangles.rows(), 4);
  EXPECT_TRUE(topology(mesh).oriented);
  for (const auto& t : mesh.triangles.rowwise())
  {
    const Vector3 a = mesh.points.row(t[0]), b = mesh.points.row(t[1]), c = mesh.points.row(t[2]);
    EXPECT_DOUBLE_EQ((b - a).cross(c - a)[2], 1) << "each has a quarter of the area";
  }
}

TEST(GmshFile, WhatIsWrittenReadsBack)
{
  TriangleMesh mesh = geodesic_sphere(3);
  mesh.points.array() /= 3;
  const TriangleMesh back = mesh_of(read_gmsh(gmsh_text(mesh), "back.msh"));
  EXPECT_EQ(back.points, mesh.points);
  EXPECT_EQ(back.triangles, mesh.triangles);
}

TEST(GmshFile, SaysWhatItCantRead)
{
  EXPECT_THAT(message_of(read_gmsh, "$Nodes\n"), HasSubstr("mesh:1: the first word should be"));
  EXPECT_THAT(message_of(read_gmsh, "$MeshFormat\n4 0 8\n$EndMeshFormat\n"),
    HasSubstr("MSH 4 can't be read; write 2.2 or 4.1"));
  EXPECT_THAT(message_of(read_gmsh, "$MeshFormat\n2.2 0 4\n$EndMeshFormat\n"),
    HasSubstr("numbers of 4 bytes"));
  EXPECT_THAT(message_of(read_gmsh, elements_of(square, "1\n1 2 2 1 1 1 2 9\n")),
    HasSubstr("element 0 has a node 9, which isn't in $Nodes"));
  EXPECT_THAT(message_of(read_gmsh, elements_of(square, "1\n1 99 2 1 1 1 2 9\n")),
    HasSubstr("mesh:13: there is no type 99 of elements"));
  EXPECT_THAT(message_of(read_gmsh, elements_of(square, "1\n1 4 2 1 1 1 2 3 4\n")),
    HasSubstr("no triangles among the elements; have gmsh save the surface"));
  EXPECT_THAT(
    message_of(read_gmsh, elements_of("2000000000\n1 0 0 0\n", "")), HasSubstr("too early"));
  EXPECT_THAT(message_of(read_gmsh, elements_of("-1\n", "")), HasSubstr("-1 can't be"));
  EXPECT_THAT(message_of(read_gmsh, elements_of("1\n1 0 x 0\n", "")),
    HasSubstr("mesh:6: 'x' stands where a coordinate should be"));
  EXPECT_THAT(message_of(read_gmsh, "$MeshFormat\n2.2 0 8\n$EndMeshFormat\nNodes\n"),
    HasSubstr("a section's name"));
}

TEST(GmshFile, LinesAreCountedPastOtherSections)
{
  EXPECT_THAT(message_of(read_gmsh,
                "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Comments\na\nb\n$EndComments\nx\n"),
    HasSubstr("mesh:8:"));
}

}
