#include "solver/surface/Cotan.h"

#include "solver/mesh/VertexNormals.h"

#include <cmath>
#include <numbers>
#include <vector>

namespace vesicle
{

namespace
{

using Row3 = Eigen::RowVector3d;
using Triplets = std::vector<Eigen::Triplet<double>>;

// Below this |Lx| √A (twice the turning of the normal over a patch) the curvature vector is noise
// and gives no direction: "almost zero" of the paper, made relative to the local length.
constexpr double flat_patch = 0.02;

}

CotanGeometry::CotanGeometry(const Points& points, const Triangles& triangles)
  : vertex_area(Eigen::VectorXd::Zero(points.rows())),
    angle_sum(Eigen::VectorXd::Zero(points.rows())),
    vertex_normal(vertex_normals(points, triangles)), laplacian(points.rows(), points.rows())
{
  Triplets entries;
  for (const auto& triangle : triangles.rowwise())
    for (int corner = 0; corner < 3; ++corner)
    {
      const int i = triangle[corner], j = triangle[(corner + 1) % 3],
                k = triangle[(corner + 2) % 3];
      const Row3 to_j = points.row(j) - points.row(i), to_k = points.row(k) - points.row(i);
      const double twice_area = to_j.cross(to_k).norm(), dot = to_j.dot(to_k);
      if (!(twice_area > 0))
        continue; // a degenerate triangle has no area and no angles to give
      vertex_area[i] += twice_area / 6;
      angle_sum[i] += std::atan2(twice_area, dot);
      const double weight = 0.5 * dot / twice_area; // ½ cot of the angle at i, on the edge j–k
      entries.emplace_back(j, k, weight);
      entries.emplace_back(k, j, weight);
      entries.emplace_back(j, j, -weight);
      entries.emplace_back(k, k, -weight);
    }
  laplacian.setFromTriplets(entries.begin(), entries.end());
  for (int i = 0; i < vertex_area.size(); ++i)
    if (vertex_area[i] > 0)
      laplacian.row(i) /= vertex_area[i];
}

Curvature cotan_curvature(const CotanGeometry& g, const Points& points, NormalScheme scheme)
{
  const Row3 origin = points.row(0); // far from the origin L x would lose digits
  const Points vector = g.laplacian * (points.rowwise() - origin);
  Curvature c{ g.vertex_normal, Eigen::VectorXd(points.rows()), Eigen::VectorXd(points.rows()),
    {} };
  for (int i = 0; i < points.rows(); ++i)
  {
    const double length = vector.row(i).norm();
    if (scheme == NormalScheme::curvature && length * std::sqrt(g.vertex_area[i]) > flat_patch)
      c.normal.row(i) =
        vector.row(i) / std::copysign(length, vector.row(i).dot(g.vertex_normal.row(i)));
    c.mean[i] = -0.5 * vector.row(i).dot(c.normal.row(i));
    c.gauss[i] =
      g.vertex_area[i] > 0 ? (2 * std::numbers::pi - g.angle_sum[i]) / g.vertex_area[i] : 0;
  }
  c.laplacian_mean = g.laplacian * c.mean;
  return c;
}

SparseMatrix surface_divergence_matrix(const CotanGeometry& g, const SparseMatrix& area_rate)
{
  return g.vertex_area.cwiseInverse().asDiagonal() * area_rate;
}

SparseMatrix tension_force_matrix(
  const CotanGeometry& g, const Points& points, const Triangles& triangles, const Points& normal)
{
  Triplets entries;
  const auto add = [&](int i, int k, const Row3& force)
  {
    for (int c = 0; c < 3; ++c)
      entries.emplace_back(3 * i + c, k, force[c]);
  };
  for (const auto& triangle : triangles.rowwise())
  {
    const Row3 a = points.row(triangle[0]), b = points.row(triangle[1]),
               c = points.row(triangle[2]);
    const Row3 face_normal = (b - a).cross(c - a).normalized();
    for (int corner = 0; corner < 3; ++corner)
    {
      // A_e g_k / 3 with g_k = n_e × e_k/(2A_e), e_k the edge opposite corner k.
      const int k = triangle[corner];
      const Row3 edge =
        points.row(triangle[(corner + 2) % 3]) - points.row(triangle[(corner + 1) % 3]);
      const Row3 gradient = face_normal.cross(edge) / 6;
      for (int i : triangle)
      {
        const Row3 n = normal.row(i);
        add(i, k, (gradient - gradient.dot(n) * n) / g.vertex_area[i]);
      }
    }
  }
  const Points vector = g.laplacian * (points.rowwise() - Row3(points.row(0)));
  for (int i = 0; i < points.rows(); ++i)
    add(i, i, vector.row(i));
  SparseMatrix F(3 * points.rows(), points.rows());
  F.setFromTriplets(entries.begin(), entries.end());
  return F;
}

}
