#pragma once
// Pointwise curvatures of any triangle mesh as it is, by two fits around every vertex: irregular
// meshes, valence 3 to 12, open borders.
//
// In the frame of the area-weighted normal a quartic z(x, y) through the vertex is fitted to its
// neighbours; it gives H, K and n. The same least squares, applied to the values of H that
// resulted, give Δ_s H on the fitted surface (a direct fourth derivative of the position has
// unstable modes). Neighbours are taken ring by ring until there are 28, at least two rings; their
// weights are exp(−4 d²/σ²), σ² the mean square distance of the nearest 18 (on borders exp(−d²/σ²):
// one-sided fits need the far ones). Refitting in the frame of the fitted normal did not help.
//
// Measured, as recorded by the tests named (FittedCurvatureTest):
//   ‖G(f_h n_h − f n)‖/‖G f n‖, the error of the bending force as it moves the fluid, on the
//   ellipsoid 2:1:1 with 320 / 1,280 / 5,120 triangles (VelocityErrorOnTheEllipsoid):
//     regular (geodesic)                            6.3e-2 / 5.1e-3 / 3.5e-4
//     points jittered by 0.3 edges, Delaunay        1.4e-1 / 1.7e-2 / 3.0e-3
//     jittered, not flipped                              – / 1.8e-2 / 3.0e-3
//     valence 3 and 10–12, 1,500 / 4,860 triangles  1.3e-2 / 3.7e-3
//   Relative root mean square errors at the vertices:
//     H and Δ_s H, jittered ellipsoid, 1,280 / 5,120 (ConvergesPointwiseOnIrregularMeshes):
//       H 2.0e-3 / 1.7e-4, Δ_s H 9.7e-2 / 4.0e-2
//     Clifford torus, 3,072 / 12,288 (CliffordTorusIsInEquilibrium):
//       H 1.3e-3 / 1.5e-4, Δ_s H 2.2e-2 / 5.0e-3
//     surface of the paper's 4.1, its section z = 0, 5,120 / 20,480 (PaperSurfaceSection):
//       H 3.5e-3 / 1.8e-4, Δ_s H 9.3e-2 / 6.7e-3
//     ellipsoid cut open, from 5,120 triangles (OpenBorder):
//       inside H 9.4e-5, Δ_s H 3.9e-2; on the border H 2.1e-3, Δ_s H 1.7: no figure to use

#include "solver/ProgressCallback.h"
#include "solver/mesh/Connectivity.h"
#include "solver/surface/Cotan.h"

#include <vector>

namespace vesicle
{

struct FitOptions
{
  /// Of the neighbourhood that a vertex is fitted to, a length: above the noise of the points,
  /// below the radii of curvature (ScaleFit.h). Time grows as its square. 0: the nearest vertices,
  /// for smooth meshes.
  double radius = 0;
  /// Whether Δ_s H is wanted, which with a radius takes as long as all else.
  bool laplacian = true;
};

struct FittedCurvature
{
  /// n outward, H = +1/R on a sphere; bending_density() of Bending.h turns it into the force.
  Curvature curvature;
  /// Unit tangents along which the normal curvature is greatest; n × it: least.
  Points direction;
  /// Standard error of H if what the fit leaves over is noise, independent from point to point. On
  /// staircases, which aren't, H deviates 1.3 to 1.4 times as much (ScaleFitTest).
  Eigen::VectorXd mean_error;
  /// Weighted root mean square distance of the neighbours from the fitted surface, in mean edge
  /// lengths at the vertex.
  Eigen::VectorXd residual;
  /// Of the fitted polynomials: 4; 3, 2 where neighbours are few or in line, 2 with a radius; 1
  /// where even fewer (second-order terms alone); 0 where nothing is known (no triangle of positive
  /// area, or normals that cancel) and everything is zero.
  Eigen::VectorXi degree;
  /// 1 at the ends of edges that don't have two triangles: fits are one-sided (or the surface
  /// branches) there, and less accurate.
  std::vector<char> border;
};

/// Throws InputError where the radius is above half the diagonal of the mesh's box.
FittedCurvature fitted_curvature(const TriangleMesh& mesh);
FittedCurvature fitted_curvature(const TriangleMesh& mesh, const Connectivity& connectivity,
  const FitOptions& options = {}, const ProgressCallback& progress = {});

}
