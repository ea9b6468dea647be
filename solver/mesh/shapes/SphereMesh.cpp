#include "solver/mesh/shapes/SphereMesh.h"

#include "solver/mesh/EdgeUses.h"
#include "solver/mesh/PointHash.h"
#include "solver/mesh/Refinement.h"
#include "solver/mesh/shapes/GeodesicSphere.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <numbers>

namespace vesicle
{

SphereMesh geodesic_sphere_mesh(int n)
{
  auto [directions, triangles] = geodesic_sphere(n);
  return { std::move(directions), std::move(triangles), {} };
}

std::vector<SymmetryOperation> dihedral_symmetries(const SphereMesh& mesh, int fold)
{
  const double rounding = 1e-10;
  const int points = static_cast<int>(mesh.directions.rows());
  PointHash hash(rounding);
  for (int i = 0; i < points; ++i)
    hash.insert(mesh.directions.row(i), i);
  std::vector<SymmetryOperation> symmetries;
  for (int k = 1; k < 2 * fold; ++k)
  {
    const double angle = 2 * std::numbers::pi * k / fold;
    SymmetryOperation operation{ Eigen::AngleAxisd(angle, Vector3::UnitZ()).toRotationMatrix(),
      {} };
    if (k >= fold)
      operation.rotation *= Vector3(-1, 1, -1).asDiagonal();
    for (int i = 0; i < points; ++i)
      operation.image.push_back(hash.find(operation.rotation * mesh.directions.row(i).transpose()));
    if (std::ranges::find(operation.image, -1) == operation.image.end())
      symmetries.push_back(std::move(operation));
  }
  return symmetries;
}

SphereMesh axes_permuted(const SphereMesh& mesh)
{
  const Eigen::Matrix3d permutation = Eigen::PermutationMatrix<3>(Eigen::Vector3i(1, 2, 0));
  SphereMesh permuted = mesh;
  permuted.directions = mesh.directions * permutation.transpose();
  for (SymmetryOperation& operation : permuted.symmetries)
    operation.rotation = permutation * operation.rotation * permutation.transpose();
  return permuted;
}

SphereMesh refined(const SphereMesh& mesh)
{
  const int points = static_cast<int>(mesh.directions.rows());
  const EdgeUses edges(mesh.triangles);
  SphereMesh cut;
  cut.directions.resize(points + edges.size(), 3);
  cut.directions.topRows(points) = mesh.directions;
  for (int e = 0; e < edges.size(); ++e)
  {
    const EdgeUse& use = edges[e].front();
    cut.directions.row(points + e) =
      (mesh.directions.row(use.a) + mesh.directions.row(use.b)).normalized();
  }
  cut.triangles = refined(mesh.triangles, edges, points);
  for (SymmetryOperation operation : mesh.symmetries)
  {
    for (int e = 0; e < edges.size(); ++e)
    {
      const EdgeUse& use = edges[e].front();
      operation.image.push_back(
        points + edges.find(operation.image[use.a], operation.image[use.b]));
    }
    cut.symmetries.push_back(std::move(operation));
  }
  return cut;
}

TriangleMesh mapped(const SphereMesh& mesh, const SphericalParametrisation& surface)
{
  return mapped(TriangleMesh{ mesh.directions, mesh.triangles }, surface);
}

}
