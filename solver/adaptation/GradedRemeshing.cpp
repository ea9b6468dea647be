#include "solver/adaptation/GradedRemeshing.h"

#include "solver/mesh/TriangleTree.h"
#include "solver/mesh/remesh/EdgeCollapses.h"
#include "solver/mesh/remesh/EdgeFlips.h"
#include "solver/mesh/remesh/EdgeSplits.h"

#include <algorithm>
#include <cmath>

namespace vesicle
{

namespace
{

constexpr double long_edge = 4.0 / 3, short_edge = 4.0 / 5; // of the wanted (Botsch & Kobbelt)
constexpr int split_passes = 4, rounds = 12, spreading = 5, last_spreading = 60;

class Remeshing
{
public:
  Remeshing(const LimitSurface& surface, const Eigen::VectorXd& edge_lengths)
    : surface_(surface), edge_lengths_(edge_lengths),
      tree_(surface.mesh()), mesh_{ surface.mesh().points, Points(surface.mesh().points.rows(), 3),
        surface.mesh().triangles, {}, edge_lengths }
  {
    settle(placed());
  }

  int triangles() const { return static_cast<int>(mesh_.triangles.rows()); }
  void split_and_collapse(double length);
  void flip(FlipGoal goal) { flip_edges(mesh_, goal); }
  void spread(int passes);
  PlacedMesh placed() const;

private:
  SurfacePlace place(const Vector3& x) const;
  void settle(const PlacedMesh& mesh);

  const LimitSurface& surface_;
  const Eigen::VectorXd& edge_lengths_;
  TriangleTree tree_;
  EditableMesh mesh_;
};

SurfacePlace Remeshing::place(const Vector3& x) const
{
  const TriangleTree::Hit hit = tree_.nearest(x);
  return surface_.nearest(x, { hit.triangle, hit.weights });
}

PlacedMesh Remeshing::placed() const
{
  PlacedMesh mesh{ std::vector<SurfacePlace>(mesh_.points.rows()), mesh_.triangles };
  for (std::size_t i = 0; i < mesh.places.size(); ++i)
    mesh.places[i] = place(mesh_.point(static_cast<int>(i)));
  return mesh;
}

// The edited mesh takes its points, normals and sizes from their places.
void Remeshing::settle(const PlacedMesh& mesh)
{
  for (Eigen::Index i = 0; i < mesh_.points.rows(); ++i)
  {
    const LimitSurface::Point point = surface_.at(mesh.places[i]);
    mesh_.points.row(i) = point.position.transpose();
    mesh_.normals.row(i) = point.normal().transpose();
    mesh_.sizes[i] = linear(mesh.places[i], surface_.mesh().triangles, edge_lengths_);
  }
}

void Remeshing::split_and_collapse(double length)
{
  const auto project = [&](const Vector3& x, const Vector3&) -> PointWithNormal
  {
    const LimitSurface::Point point = surface_.at(place(x));
    return { point.position, point.normal() };
  };
  for (int pass = 0; pass < split_passes; ++pass)
    split_edges(mesh_, project, long_edge * length);
  while (collapse_edges(mesh_, short_edge * length, long_edge * length) > 0)
  {
  }
}

void Remeshing::spread(int passes)
{
  PlacedMesh mesh = placed();
  vesicle::spread(mesh, surface_, edge_lengths_, passes);
  settle(mesh);
}

}

PlacedMesh graded_remeshing(
  const LimitSurface& surface, const Eigen::VectorXd& edge_lengths, int triangles)
{
  Remeshing remeshing(surface, edge_lengths);
  double length = 1;
  for (int round = 0; round < rounds; ++round)
  {
    remeshing.split_and_collapse(length);
    remeshing.flip(FlipGoal::valences);
    remeshing.spread(spreading);
    length *=
      std::clamp(std::sqrt(static_cast<double>(remeshing.triangles()) / triangles), 0.8, 1.25);
  }
  for (int pass = 0; pass < last_spreading / spreading; ++pass)
  {
    remeshing.flip(FlipGoal::angles);
    remeshing.spread(spreading);
  }
  return remeshing.placed();
}

}
