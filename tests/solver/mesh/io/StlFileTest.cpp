#include "solver/mesh/io/StlFile.h"

#include "solver/mesh/MeshIntegrals.h"
#include "solver/mesh/Topology.h"
#include "solver/mesh/shapes/GeodesicSphere.h"
#include "tests/solver/mesh/io/SampleFiles.h"

#include <gmock/gmock.h>

#include <random>

namespace vesicle::test
{
namespace
{

using testing::HasSubstr;

Faces faces_of(const TriangleMesh& mesh)
{
  Faces faces;
  for (const auto& row : mesh.triangles.rowwise())
    faces.push_back({ row[0], row[1], row[2] });
  return faces;
}

}

TEST(StlFile, TextKeepsDoublePrecision)
{
  TriangleMesh mesh = geodesic_sphere(3);
  const double volume = flat_volume(mesh);
  mesh.points.array() += 1e6;
  const TriangleMesh back = mesh_of(read_stl(stl_sample(mesh.points, faces_of(mesh)), "far.stl"));
  EXPECT_EQ(back.points.rows(), mesh.points.rows());
  EXPECT_TRUE(topology(back).closed);
  // Coordinates of 1e6 are rounded to 1e-10.
  EXPECT_NEAR(flat_volume(back), volume, 1e-8);
}

TEST(StlFile, ReadsSeveralSolidsAndAnyCase)
{
  const TriangleMesh mesh = geodesic_sphere(1);
  TriangleMesh other = mesh;
  other.points.array() += 3;
  std::string text =
    stl_sample(mesh.points, faces_of(mesh)) + "\r\n" + stl_sample(other.points, faces_of(other));
  std::transform(text.begin(), text.end(), text.begin(), [](char c) { return std::toupper(c); });
  EXPECT_EQ(topology(mesh_of(read_stl(text, "two.stl"))).components, 2);
}

TEST(StlFile, RefusesOtherLengthsAndWhatIsNoStl)
{
  const TriangleMesh mesh = geodesic_sphere(2);
  const std::string whole = binary_stl_sample(mesh.points, faces_of(mesh));
  EXPECT_EQ(message_of(read_stl, whole), "no InputError") << "though it begins with solid";
  std::string named = whole;
  named.replace(0, 5, "cells");
  EXPECT_EQ(message_of(read_stl, named), "no InputError");
  EXPECT_THAT(message_of(read_stl, std::string_view(named).substr(0, named.size() - 7)),
    HasSubstr("ends too early"));
  EXPECT_THAT(message_of(read_stl, named + "more"), HasSubstr("something follows it"));
  EXPECT_THAT(message_of(read_stl, ""), HasSubstr("is not an STL file"));
  std::string noise(20000, '\0');
  std::mt19937 random(3);
  for (char& c : noise)
    c = static_cast<char>(random());
  EXPECT_THAT(message_of(read_stl, noise), HasSubstr("is not an STL file"));
}

}
