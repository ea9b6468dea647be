#include "solver/mesh/JoinedMesh.h"

namespace vesicle
{

TriangleMesh joined(const std::vector<TriangleMesh>& meshes)
{
  Eigen::Index points = 0, triangles = 0;
  for (const TriangleMesh& mesh : meshes)
  {
    points += mesh.points.rows();
    triangles += mesh.triangles.rows();
  }
  TriangleMesh all{ Points(points, 3), Triangles(triangles, 3) };
  points = triangles = 0;
  for (const TriangleMesh& mesh : meshes)
  {
    all.points.middleRows(points, mesh.points.rows()) = mesh.points;
    all.triangles.middleRows(triangles, mesh.triangles.rows()) =
      mesh.triangles.array() + static_cast<int>(points);
    points += mesh.points.rows();
    triangles += mesh.triangles.rows();
  }
  return all;
}

std::size_t mesh_of_triangle(const std::vector<TriangleMesh>& meshes, Eigen::Index triangle)
{
  std::size_t mesh = 0;
  while (triangle >= meshes.at(mesh).triangles.rows())
    triangle -= meshes[mesh++].triangles.rows();
  return mesh;
}

}
