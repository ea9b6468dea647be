#include "solver/mesh/remesh/ProjectedMesh.h"

#include "solver/mesh/Connectivity.h"
#include "solver/mesh/MeshIntegrals.h"
#include "solver/mesh/remesh/TriangleCount.h"
#include "solver/mesh/shapes/UniformMesh.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace vesicle
{

namespace
{
constexpr int passes = 60;         // the ellipsoid's spacing is a guess only
constexpr double least_angle = 36; // degrees; flatter ones don't resolve a tip or rim
/// Of the area, times the number of triangles: five are what flat triangles lose on a sphere.
constexpr double allowed_loss = 30;

/// The images of the unit vectors are the semi-axes of an ellipsoid with the surface's principal
/// axes and its extents along them. They point where the third moments are positive, so that a
/// turned surface's are turned.
Eigen::Matrix3d principal_axes(const EditableMesh& surface)
{
  const Triangles& triangles = surface.triangles;
  Points centres(triangles.rows(), 3);
  Eigen::VectorXd areas(triangles.rows());
  for (int t = 0; t < triangles.rows(); ++t)
  {
    const Vector3 a = surface.point(triangles(t, 0)), b = surface.point(triangles(t, 1)),
                  c = surface.point(triangles(t, 2));
    centres.row(t) = (a + b + c) / 3;
    areas[t] = (b - a).cross(c - a).norm();
  }
  const Eigen::Matrix3d moments = centres.transpose() * areas.asDiagonal() * centres;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(moments);
  Eigen::Matrix3d directions = solver.eigenvectors();
  for (int axis = 1; axis < 3; ++axis)
  {
    const Eigen::ArrayXd along = centres * directions.col(axis);
    directions.col(axis) *= areas.dot(along.cube().matrix()) < 0 ? -1 : 1;
  }
  directions.col(0) = directions.col(1).cross(directions.col(2));
  const Points along = surface.points * directions;
  const Eigen::Vector3d extents = along.colwise().maxCoeff() - along.colwise().minCoeff();
  return directions * (extents / extents.maxCoeff()).asDiagonal();
}

/// The vertex from which each sample of the surface starts looking for its nearest one: the one on
/// the nearest ray, found from neighbour to neighbour.
std::vector<int> first_nearest(
  const SphereMesh& sphere, const Eigen::Matrix3d& image, const SurfaceSmoother& smoother)
{
  const Connectivity connectivity(sphere.triangles, static_cast<int>(sphere.directions.rows()));
  const AdjacencyList& around = connectivity.vertex_neighbours;
  const Eigen::Matrix3d back = image.inverse();
  std::vector<int> nearest;
  int vertex = 0;
  for (const CurvedSurface::Sample& sample : smoother.samples())
  {
    const Vector3 direction = back * sample.point;
    for (int last = -1; vertex != last;)
    {
      last = vertex;
      for (const int* i = around.begin(last); i != around.end(last); ++i)
        if (sphere.directions.row(*i).dot(direction) > sphere.directions.row(vertex).dot(direction))
          vertex = *i;
    }
    nearest.push_back(vertex);
  }
  return nearest;
}
}

std::optional<EditableMesh> projected_mesh(const SurfaceSmoother& smoother, int triangles)
{
  const Eigen::Matrix3d image = principal_axes(smoother.input());
  const SphereMesh sphere =
    uniform_mesh([&](const Vector3& d) -> Vector3 { return image * d; }, triangles, Symmetry::none);
  const auto count = static_cast<double>(sphere.triangles.rows());
  if (std::abs(count - triangles) > allowed_deviation * triangles)
    return std::nullopt;
  EditableMesh mesh{ sphere.directions * image.transpose(), sphere.directions, sphere.triangles,
    first_nearest(sphere, image, smoother), {} };
  for (int i = 0; i < mesh.points.rows(); ++i)
  {
    const Vector3 x = mesh.points.row(i);
    const PointWithNormal there = smoother.project_along(x, x.normalized());
    mesh.points.row(i) = there.point;
    mesh.normals.row(i) = there.normal;
  }
  for (int pass = 0; pass < passes; ++pass)
    smoother.smooth(mesh);
  const double area = flat_area({ mesh.points, mesh.triangles });
  const bool all_of_it = area >= (1 - allowed_loss / count) * smoother.area();
  return all_of_it && mesh.quality().min_angle_deg >= least_angle ? std::optional(std::move(mesh))
                                                                  : std::nullopt;
}

}
