#include "solver/mesh/shapes/SphereMesh.h"

#include "solver/mesh/EdgeUses.h"
#include "solver/mesh/PointHash.h"
#include "solver/mesh/shapes/Shapes.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <numbers>
#include <ranges>

namespace vesicle
{

namespace
{
int find_edge(const EdgeUses& edges, int a, int b)
{
  const std::array<int, 2> wanted{ std::min(a, b), std::max(a, b) };
  const auto numbers = std::views::iota(0, edges.size());
  return *std::ranges::lower_bound(numbers, wanted, {},
    [&](int e) {
      return std::array{ edges[e].front().a, edges[e].front().b };
    });
}
}

SphereMesh geodesic_sphere_mesh(int n)
{
  auto [directions, triangles] = geodesic_sphere(n);
  return { std::move(directions), std::move(triangles), {} };
}

std::vector<Turn> dihedral_turns(const SphereMesh& mesh, int fold)
{
  const double rounding = 1e-10;
  const int points = static_cast<int>(mesh.directions.rows());
  PointHash hash(rounding);
  for (int i = 0; i < points; ++i)
  {
    hash.insert(mesh.directions.row(i), i);
  }
  std::vector<Turn> turns;
  for (int k = 1; k < 2 * fold; ++k)
  {
    const double angle = 2 * std::numbers::pi * k / fold;
    Turn turn{ Eigen::AngleAxisd(angle, Vector3::UnitZ()).toRotationMatrix(), {} };
    if (k >= fold)
    {
      turn.rotation *= Vector3(-1, 1, -1).asDiagonal();
    }
    for (int i = 0; i < points; ++i)
    {
      turn.image.push_back(hash.find(turn.rotation * mesh.directions.row(i).transpose()));
    }
    if (std::ranges::find(turn.image, -1) == turn.image.end())
    {
      turns.push_back(std::move(turn));
    }
  }
  return turns;
}

SphereMesh turned_over(const SphereMesh& mesh)
{
  const Eigen::Matrix3d over = Eigen::PermutationMatrix<3>(Eigen::Vector3i(1, 2, 0));
  SphereMesh turned = mesh;
  turned.directions = mesh.directions * over.transpose();
  for (Turn& turn : turned.turns)
  {
    turn.rotation = over * turn.rotation * over.transpose();
  }
  return turned;
}

SphereMesh cut_in_four(const SphereMesh& mesh)
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
  cut.triangles = cut_in_four(mesh.triangles, edges, points);
  for (Turn turn : mesh.turns)
  {
    for (int e = 0; e < edges.size(); ++e)
    {
      const EdgeUse& use = edges[e].front();
      turn.image.push_back(points + find_edge(edges, turn.image[use.a], turn.image[use.b]));
    }
    cut.turns.push_back(std::move(turn));
  }
  return cut;
}

}
