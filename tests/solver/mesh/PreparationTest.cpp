#include "solver/Errors.h"
#include "solver/mesh/MeshIntegrals.h"
#include "solver/mesh/Preparation.h"
#include "solver/mesh/Topology.h"
#include "tests/solver/support/SmallMeshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <limits>

namespace vesicle::test
{

using testing::AllOf;
using testing::HasSubstr;

namespace
{
std::string refusal(TriangleMesh mesh)
{
  try
  {
    prepare_for_dynamics(mesh, "cell.stl");
  }
  catch (const InputError& error)
  {
    return error.what();
  }
  return "";
}

TriangleMesh read_off(const std::string& path)
{
  std::ifstream file(path);
  std::string line;
  std::getline(file, line); // OFF
  while (std::getline(file, line) && (line.empty() || line[0] == '#'))
  {
  }
  int points = 0, triangles = 0;
  std::sscanf(line.c_str(), "%d %d", &points, &triangles);
  TriangleMesh mesh{ Points(points, 3), Triangles(triangles, 3) };
  for (int i = 0; i < points; ++i)
    file >> mesh.points(i, 0) >> mesh.points(i, 1) >> mesh.points(i, 2);
  for (int t = 0, corners = 0; t < triangles; ++t)
    file >> corners >> mesh.triangles(t, 0) >> mesh.triangles(t, 1) >> mesh.triangles(t, 2);
  return mesh;
}
}

TEST(Preparation, LeavesAGoodMeshAlone)
{
  TriangleMesh mesh = sphere();
  const TriangleMesh before = mesh;
  EXPECT_EQ(prepare_for_dynamics(mesh, "cell.stl"), "");
  EXPECT_EQ(mesh.points, before.points);
  EXPECT_EQ(mesh.triangles, before.triangles);
}

TEST(Preparation, AcceptsAnyUnitAndPlace)
{
  for (const double scale : { 1e-6, 1e6 })
  {
    TriangleMesh mesh = sphere();
    mesh.points *= scale;
    mesh = moved(mesh, 100 * scale * Vector3::Ones());
    EXPECT_EQ(prepare_for_dynamics(mesh, "cell.stl"), "");
  }
}

TEST(Preparation, TurnsAnInwardMeshOutward)
{
  TriangleMesh mesh = turned_over(sphere(), 0, static_cast<int>(sphere().triangles.rows()));
  EXPECT_THAT(
    prepare_for_dynamics(mesh, "cell.stl"), HasSubstr("cell.stl: the triangles faced inward"));
  EXPECT_GT(flat_volume(mesh), 0);
}

TEST(Preparation, MendsTheOrientation)
{
  const TriangleMesh good = sphere();
  for (const auto& [first, last] : { std::pair{ 3, 9 }, std::pair{ 0, 1 }, std::pair{ 0, 300 } })
  {
    TriangleMesh mesh = turned_over(good, first, last);
    EXPECT_THAT(prepare_for_dynamics(mesh, "cell.stl"),
      HasSubstr(std::to_string(last - first) + " of 320 triangles faced inward"));
    EXPECT_TRUE(topology(mesh).oriented);
    EXPECT_DOUBLE_EQ(flat_volume(mesh), flat_volume(good));
  }
}

TEST(Preparation, DropsUnusedPoints)
{
  TriangleMesh mesh = sphere();
  const TriangleMesh good = mesh;
  mesh.points.conservativeResize(mesh.points.rows() + 1, 3);
  mesh.points.bottomRows(1) << 50, 0, 0;
  mesh = in_reverse_order(mesh); // now the unused point is the first
  EXPECT_THAT(
    prepare_for_dynamics(mesh, "cell.stl"), HasSubstr("a point that no triangle uses was dropped"));
  EXPECT_EQ(mesh.points.rows(), good.points.rows());
  EXPECT_NEAR(flat_volume(mesh), flat_volume(good), 1e-14);
}

TEST(Preparation, NamesTheOpenBorder)
{
  const TriangleMesh mesh = without_triangles(sphere(), { 0, 100, 200 });
  EXPECT_THAT(refusal(mesh),
    AllOf(HasSubstr("cell.stl: open border at edge "), HasSubstr("–"), HasSubstr("near ("),
      HasSubstr("3 holes"), HasSubstr("vtkFillHolesFilter")));
  EXPECT_THAT(refusal(without_triangles(sphere(), { 9 })), HasSubstr("1 hole "));
}

TEST(Preparation, NamesNonManifoldPlaces)
{
  TriangleMesh wall = sphere(1);
  wall.triangles.conservativeResize(21, 3);
  wall.triangles.row(20) << wall.triangles(0, 0), wall.triangles(0, 1), 3;
  EXPECT_THAT(
    refusal(wall), AllOf(HasSubstr("3 triangles meet at edge 0–1 near ("), HasSubstr("remove")));
  EXPECT_THAT(
    refusal(bow_tie()), AllOf(HasSubstr("touch in point 0 near ("), HasSubstr("own point")));
}

TEST(Preparation, NamesComponentsGenusAndSides)
{
  const TriangleMesh pair = together(sphere(), moved(sphere(), Vector3(5, 0, 0)));
  EXPECT_THAT(
    refusal(pair), AllOf(HasSubstr("2 separate components"), HasSubstr("point 162 near (")));
  EXPECT_THAT(refusal(torus()), AllOf(HasSubstr("genus 1 (1 handle"), HasSubstr("near (")));
  EXPECT_THAT(refusal(projective_plane()), AllOf(HasSubstr("one side only"), HasSubstr("edge ")));
}

// Neither remeshing nor merging helps against a handle.
TEST(Preparation, NamesTheGenusBeforeWhatCouldBeMended)
{
  TriangleMesh ring = torus();
  const Eigen::RowVector3i corners = ring.triangles.row(4);
  ring.points.row(corners[0]) = 0.5 * (ring.points.row(corners[1]) + ring.points.row(corners[2]));
  EXPECT_THAT(refusal(ring), HasSubstr("genus 1 (1 handle"));
}

TEST(Preparation, NamesTwoTrianglesThatCross)
{
  TriangleMesh mesh = sphere();
  int top = 0;
  mesh.points.col(2).maxCoeff(&top);
  mesh.points(top, 2) -= 3; // through the other side
  EXPECT_THAT(refusal(mesh), AllOf(HasSubstr("crosses itself: triangles "), HasSubstr("near (")));
}

TEST(Preparation, NamesDegenerateTriangles)
{
  TriangleMesh repeated = sphere();
  repeated.triangles(17, 1) = repeated.triangles(17, 0);
  EXPECT_THAT(
    refusal(repeated), AllOf(HasSubstr("degenerate triangle 17 (points "), HasSubstr("near (")));

  // A vertex moved onto the opposite edge of its first triangle: three points in a line.
  TriangleMesh flat = sphere();
  const Eigen::RowVector3i corners = flat.triangles.row(40);
  flat.points.row(corners[0]) = 0.5 * (flat.points.row(corners[1]) + flat.points.row(corners[2]));
  EXPECT_THAT(refusal(flat), HasSubstr("degenerate triangle"));
}

TEST(Preparation, NamesDuplicatePoints)
{
  // As STL readers leave it: every triangle with points of its own.
  const TriangleMesh joined = sphere();
  TriangleMesh soup{ Points(3 * joined.triangles.rows(), 3),
    Triangles(joined.triangles.rows(), 3) };
  for (int i = 0; i < joined.triangles.size(); ++i)
  {
    soup.points.row(i) = joined.points.row(joined.triangles(i / 3, i % 3));
    soup.triangles(i / 3, i % 3) = i;
  }
  EXPECT_THAT(refusal(soup),
    AllOf(HasSubstr("duplicate points"), HasSubstr("near ("), HasSubstr("vtkCleanPolyData")));

  TriangleMesh nearly = sphere();
  nearly.points.row(5) = nearly.points.row(90);
  nearly.points(5, 0) += 1e-10;
  EXPECT_THAT(refusal(nearly), HasSubstr("duplicate points 5 and 90 near ("));
}

TEST(Preparation, NamesASeamThatDiffersInTheLastDigits)
{
  const TriangleMesh joined = sphere();
  TriangleMesh soup{ Points(3 * joined.triangles.rows(), 3),
    Triangles(joined.triangles.rows(), 3) };
  std::vector<int> copies(joined.points.rows(), 0);
  for (int i = 0; i < joined.triangles.size(); ++i)
  {
    const int point = joined.triangles(i / 3, i % 3);
    soup.points.row(i) = (1 + 1e-7 * copies[point]++) * joined.points.row(point);
    soup.triangles(i / 3, i % 3) = i;
  }
  EXPECT_THAT(refusal(soup),
    AllOf(HasSubstr("corners of neighbouring triangles differ by up to "), HasSubstr("--merge ")));
}

TEST(Preparation, NamesImpossibleNumbers)
{
  TriangleMesh mesh = sphere();
  mesh.points(8, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(refusal(mesh), HasSubstr("cell.stl: point 8 is ("));
  mesh = sphere();
  mesh.triangles(3, 2) = 162;
  EXPECT_THAT(
    refusal(mesh), HasSubstr("triangle 3 uses point 162, but the points are numbered 0 to 161"));
  EXPECT_THAT(refusal({ Points(0, 3), Triangles(0, 3) }), HasSubstr("empty"));
  mesh = sphere(1);
  mesh.points.setConstant(2);
  EXPECT_THAT(refusal(mesh), HasSubstr("all points coincide near (2, 2, 2)"));
}

// Two triangles back to back are closed, oriented and of genus 0, but enclose nothing.
TEST(Preparation, RefusesASurfaceWithoutVolume)
{
  TriangleMesh pillow{ sphere(1).points.topRows(3), triangle_list({ { 0, 1, 2 }, { 0, 2, 1 } }) };
  EXPECT_THAT(refusal(pillow), HasSubstr("encloses no volume near ("));
}

// gmsh's surface of revolution faces inward; see data/meshes/README.md.
TEST(Preparation, TakesAMeshOfAnotherProgram)
{
  TriangleMesh mesh = read_off(VESICLE_SOURCE_DIR "/data/meshes/peanut.off");
  ASSERT_EQ(mesh.triangles.rows(), 1106);
  EXPECT_THAT(prepare_for_dynamics(mesh, "peanut.off"), HasSubstr("turned outward"));
  EXPECT_GT(flat_volume(mesh), 0);
}

}
