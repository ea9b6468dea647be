#include "solver/mesh/io/LegacyVtkFile.h"

#include "solver/mesh/MeshIntegrals.h"
#include "tests/solver/mesh/io/SampleFiles.h"

#include <gmock/gmock.h>

namespace vesicle::test
{
namespace
{

using testing::HasSubstr;

SurfaceFile read(const std::string& text)
{
  return read_legacy_vtk(text, "mesh.vtk");
}

std::string grid(const std::string& cells)
{
  return "# vtk DataFile Version 2.0\ngrid\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n"
         "0 0 0 1 0 0 0 1 0 1 1 0\n" +
    cells;
}

template<typename T>
std::vector<T> values(const DataArray& array)
{
  return std::get<std::vector<T>>(array.values);
}

}

TEST(LegacyVtkFile, ReadsAllAttributes)
{
  const SurfaceFile file =
    read("# vtk DataFile Version 3.0\ntriangle\nascii\nDATASET POLYDATA\n"
         "FIELD FieldData 2\nTIME 1 1 double\n0.5\nnote 1 1 string\ntwo%20words\n"
         "POINTS 3 float\n0 0 0 1 0 0 0 1 0\nMETADATA\nINFORMATION 0\n\n"
         "VERTICES 1 2\n1 0\nPOLYGONS 1 4\n3 0 1 2\n"
         "CELL_DATA 2\nSCALARS kind int\nLOOKUP_TABLE own\n4 5\nLOOKUP_TABLE own 2\n"
         "0 0 0 1 1 1 1 1\nPOINT_DATA 3\nCOLOR_SCALARS colour 3\n0 0.5 1 0 0 0 1 1 1\n"
         "VECTORS Mean%20Flow double\n0 0 0 1 1 1 2 2 2\nNORMALS n float\n0 0 1 0 0 1 0 0 1\n"
         "TEXTURE_COORDINATES t 2 float\n0 0 1 0 0 1\n"
         "TENSORS T float\n1 0 0 0 1 0 0 0 1 1 0 0 0 1 0 0 0 1 1 0 0 0 1 0 0 0 1\n"
         "TENSORS6 S float\n1 1 1 0 0 0 1 1 1 0 0 0 1 1 1 0 0 0\n"
         "GLOBAL_IDS ids vtkIdType\n5000000000 1 2\nEDGE_FLAGS e unsigned_char\n1 0 1\n"
         "METADATA\nCOMPONENT_NAMES\nedge\n\nFIELD more 1\nb 1 3 bit\n1 0 1\n");
  EXPECT_DOUBLE_EQ(flat_area(mesh_of(file)), 0.5);
  EXPECT_EQ(file.polygons.cell, std::vector<std::int64_t>{ 1 }) << "the vertex is cell 0";
  ASSERT_EQ(file.field_data.size(), 2U);
  EXPECT_EQ(values<std::string>(file.field_data[1])[0], "two words");
  ASSERT_EQ(file.cell_data.size(), 1U);
  EXPECT_EQ(values<std::int32_t>(file.cell_data[0]), (std::vector<std::int32_t>{ 4, 5 }));
  ASSERT_EQ(file.point_data.size(), 9U);
  EXPECT_EQ(values<std::uint8_t>(file.point_data[0])[1], 128);
  EXPECT_EQ(file.point_data[1].name, "Mean Flow");
  EXPECT_EQ(file.point_data[1].role, DataArray::Role::vectors);
  EXPECT_EQ(file.point_data[5].components, 6);
  EXPECT_EQ(values<std::int64_t>(file.point_data[6])[0], 5000000000);
  EXPECT_EQ(file.point_data[7].component_names, std::vector<std::string>{ "edge" });
  EXPECT_EQ(values<std::uint8_t>(file.point_data[8]), (std::vector<std::uint8_t>{ 1, 0, 1 }));
}

TEST(LegacyVtkFile, StripsBecomeTriangles)
{
  EXPECT_DOUBLE_EQ(
    flat_area(mesh_of(read(grid("CELLS 2 7\n4 0 1 2 3\n1 0\nCELL_TYPES 2\n6 1\n")))), 1);
  EXPECT_DOUBLE_EQ(flat_area(mesh_of(read(grid("CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n8\n")))), 1)
    << "a pixel";
  EXPECT_DOUBLE_EQ(flat_area(mesh_of(read("# vtk DataFile Version 3.0\nstrip\nASCII\n"
                                          "DATASET POLYDATA\nPOINTS 4 float\n"
                                          "0 0 0 1 0 0 0 1 0 1 1 0\nTRIANGLE_STRIPS 1 5\n"
                                          "4 0 1 2 3\n"))),
    1);
}

TEST(LegacyVtkFile, OtherCellsAreNamed)
{
  EXPECT_THAT(message_of(read_legacy_vtk, grid("CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n")),
    testing::AllOf(HasSubstr("cell 0 is a tetrahedron"), HasSubstr("vtkDataSetSurfaceFilter")));
  EXPECT_THAT(message_of(read_legacy_vtk, grid("CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n99\n")),
    HasSubstr("the type 99, which VTK doesn't have"));
  EXPECT_THAT(message_of(read_legacy_vtk, grid("CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n5\n")),
    HasSubstr("has 4 corners instead of 3"));
}

TEST(LegacyVtkFile, SaysWhatIsWrong)
{
  const auto mesh = [](const std::string& after)
  { return vtk_sample(l_prism_points(), l_prism_faces(), after); };
  EXPECT_EQ(message_of(read_legacy_vtk, mesh("")), "no InputError");
  EXPECT_THAT(
    message_of(read_legacy_vtk, mesh("POLYGONS 1 9\n8 0 1 2\n")), HasSubstr("ends too early"));
  EXPECT_THAT(
    message_of(read_legacy_vtk, mesh("POLYGONS 2 4\n3 0 1 2\n")), HasSubstr("cell 1 doesn't fit"));
  EXPECT_THAT(message_of(read_legacy_vtk, mesh("POLYGONS 1 4\n3 0 1 12\n")),
    HasSubstr("face 8 uses point 12, but the points are numbered 0 to 11"));
  EXPECT_THAT(message_of(read_legacy_vtk,
                mesh("POINT_DATA 2\nSCALARS s float\n"
                     "LOOKUP_TABLE default\n0 0\n")),
    HasSubstr("'s' has 2 tuples for 12 points"));
  EXPECT_THAT(message_of(read_legacy_vtk,
                mesh("POINT_DATA 9000000000000000000\n"
                     "VECTORS v double\n")),
    HasSubstr("ends too early"));
  EXPECT_THAT(message_of(read_legacy_vtk,
                "# vtk DataFile Version 3.0\nx\nASCII\n"
                "DATASET STRUCTURED_POINTS\n"),
    HasSubstr("POLYDATA or UNSTRUCTURED_GRID"));
}

}
