#pragma once
// How long a mesh's edges should be where, for the surface's curvature.

#include "solver/mesh/Connectivity.h"
#include "solver/mesh/TriangleMesh.h"

namespace vesicle
{

/// h = c (κ1² + κ2² + 1/r²)^(−exponent/2), nowhere with |∇h| > growth. Without the floor 1/r² a saddle
/// or a flat place beside a bend would be left without points. c follows from the number of triangles,
/// ∮ 4/(√3 h²) dS.
struct SizingLaw
{
  double exponent = 0.5;
  double growth = 0.25;
  double radius = 1; ///< r, the length beyond which curvature doesn't count
};

/// At the vertices, N. `curvature`: κ1² + κ2² = 4H² − 2K, N; `area`: the vertices' shares, N. The
/// growth is kept along edges, which the mesh's own steps follow to within its angles.
Eigen::VectorXd wanted_edge_lengths(const SizingLaw& law, const Points& points,
  const AdjacencyList& neighbours, const Eigen::VectorXd& curvature, const Eigen::VectorXd& area,
  int triangles);

/// From every vertex to the mean of its triangles' centroids weighted by area/h³, h the mean of the
/// three corners': N by 3. Where it vanishes edges are proportional to h^{3/2} (a hexagonal lattice
/// under a conformal map z + ε e_k → f: 2 ∇ln|f'| = 3 ∇ln h).
Points towards_wanted(
  const Points& points, const Triangles& triangles, const Eigen::VectorXd& edge_lengths);

}
