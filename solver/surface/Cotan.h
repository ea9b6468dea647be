#pragma once
// Curvatures of a flat-triangle mesh by averaging over vertex patches, paper (14)–(24).
// Works on any triangle mesh; vertices on an open border or without triangles are marked.

#include "solver/surface/SurfaceIntegrals.h"

namespace vesicle
{

/// The mesh's triangles at their current shape.
struct CotanGeometry
{
  CotanGeometry(const Points& points, const Triangles& triangles);

  Eigen::VectorXd vertex_area; ///< A_i: a third of the incident triangles' areas (barycentric)
  Eigen::VectorXd angle_sum;   ///< Σ θ at each vertex
  Points vertex_normal;        ///< area-weighted mean of the incident triangles' normals, unit
  SparseMatrix laplacian; ///< L, (14)–(18): (L f)_i = Σ_j (cot α + cot β)(f_j − f_i)/(2A_i)
};

enum class NormalScheme
{
  area_weighted, ///< from the incident triangles (default)
  curvature ///< from the curvature vector (19), oriented by the triangles; area-weighted where |Lx|
            ///< √A < 0.02
};

/// Curvatures at the vertices. n outward, H = +1/R on a sphere of radius R.
struct Curvature
{
  Points normal;                  ///< N by 3
  Eigen::VectorXd mean;           ///< H = −½ (L x)·n, (20) with its sign mended
  Eigen::VectorXd gauss;          ///< K = (2π − Σθ)/A, (24)
  Eigen::VectorXd laplacian_mean; ///< Δ_s H = L H, (22)
};
Curvature cotan_curvature(const CotanGeometry& geometry, const Points& points, NormalScheme scheme);

/// Paper (28)–(31): D = diag(1/A) B, the surface divergence of a nodal velocity: N by 3N.
SparseMatrix surface_divergence_matrix(
  const CotanGeometry& geometry, const SparseMatrix& area_rate);
/// Paper (32)–(35): F_γ, the density of the tension force ∇_s γ − 2γHn = ∇_s γ + γ L x: 3N by N.
SparseMatrix tension_force_matrix(const CotanGeometry& geometry, const Points& points,
  const Triangles& triangles, const Points& normal);

}
