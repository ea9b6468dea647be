#include "solver/mesh/VertexNormals.h"

#include "tests/solver/support/SmallMeshes.h"

#include <gtest/gtest.h>

namespace vesicle::test
{

TEST(VertexNormals, AreRadialWhereTheMeshIsSymmetric)
{
  const TriangleMesh icosahedron = sphere(1);
  const TriangleMesh elsewhere = moved(icosahedron, Vector3(1, -2, 3));
  const Points normals = vertex_normals(elsewhere.points, elsewhere.triangles);
  EXPECT_LT((normals - icosahedron.points).cwiseAbs().maxCoeff(), 1e-14);
}

// Two triangles of each side meet at the cube's first corner; at the second, two of the side x = 1
// and one of each of the others.
TEST(VertexNormals, WeighTrianglesByTheirArea)
{
  const TriangleMesh mesh = cube();
  const Points normals = vertex_normals(mesh.points, mesh.triangles);
  EXPECT_LT((normals.row(0) - Eigen::RowVector3d(-1, -1, -1).normalized()).norm(), 1e-15);
  EXPECT_LT((normals.row(1) - Eigen::RowVector3d(2, -1, -1).normalized()).norm(), 1e-15);
}

TEST(VertexNormals, AreZeroWithoutTriangles)
{
  TriangleMesh mesh = sphere(1);
  mesh.points.conservativeResize(13, Eigen::NoChange);
  mesh.points.row(12) << 7, 8, 9;
  EXPECT_EQ(vertex_normals(mesh.points, mesh.triangles).row(12).norm(), 0);
}

}
