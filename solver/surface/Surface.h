#pragma once
// The surface of one vesicle at one moment, on flat triangles or on Loop's limit surface: what is
// known of its geometry. Forces, flows and scenes are unknown here.

#include "solver/linear/EliminationPlans.h"
#include "solver/surface/SurfaceBasis.h"
#include "solver/surface/Collocation.h"
#include "solver/surface/Cotan.h"
#include "solver/surface/WeakForms.h"

#include <memory>
#include <optional>

namespace vesicle
{

/// How curvatures at the vertices are found.
enum class VertexCurvature
{
  paper, ///< flat triangles: cotangents, normals along the curvature vector, (19)
  cotan, ///< flat triangles: cotangents, area-weighted normals
  weak,  ///< smooth surfaces: projections of the curvature at the quadrature points
  fitted ///< by two fits to the neighbourhood: right at every vertex on any mesh, but no gradient
         ///< of an energy of the mesh, as time stepping needs it
};

/// What a mesh's triangles fix once for all shapes: the basis, its quadrature, the way between
/// vertices and control points.
class SurfaceSpace
{
public:
  /// The regular quadrature of flat triangles has `points` points each; smooth surfaces have their
  /// own. Throws InputError if the mesh can't carry the basis.
  SurfaceSpace(SurfaceBasis kind, const Triangles& triangles, int nodes, int points = 3);
  /// With another curvature than the basis' own (cotan or weak).
  SurfaceSpace(SurfaceBasis kind, VertexCurvature curvature, const Triangles& triangles, int nodes,
    int points);

  const Basis& basis() const { return *basis_; }
  const Triangles& triangles() const { return basis_->elements(); }
  int nodes() const { return basis_->nodes(); }
  bool smooth() const { return basis_->smooth(); }
  VertexCurvature curvature() const { return curvature_; }
  /// For integrals over the surface; its nodes are the control points. Smooth surfaces: LoopBasis' own
  /// rule.
  const BasisTable& table() const { return table_; }
  const Collocation& collocation() const { return collocation_; }
  /// Of the matrices over its nodes, which have the same patterns shape after shape.
  const EliminationPlans& plans() const { return *plans_; }

private:
  std::unique_ptr<const Basis> basis_;
  VertexCurvature curvature_;
  BasisTable table_;
  Collocation collocation_;
  std::unique_ptr<const EliminationPlans> plans_;
};

/// Vectors have 3 entries a node. Velocities are those of the vertices unless said otherwise.
struct Surface
{
  /// The space must outlive the surface.
  Surface(const SurfaceSpace& space, const Points& vertices);

  const SurfaceSpace* space;
  Points vertices, control; ///< the same on flat triangles
  SurfacePoints points;     ///< at the space's quadrature points
  double area, volume;
  Vector3 center;              ///< centroid of the volume
  Eigen::VectorXd vertex_area; ///< ∮ N_k dS
  Points normals;              ///< unit, outward, at the vertices

  Eigen::VectorXd volume_gradient;                            ///< ∂V/∂x
  Eigen::Matrix<double, 3, Eigen::Dynamic> centroid_velocity; ///< W: U = W u
  /// B: d(∮ N_k dS)/dt from the velocities of the control points, N by 3N.
  SparseMatrix area_rate;

  std::optional<PointCurvature> curvature; ///< at the quadrature points; smooth surfaces only
  std::optional<CotanGeometry> cotan;      ///< flat triangles only

  const Collocation& collocation() const { return space->collocation(); }
  Eigen::VectorXd to_control(const Eigen::VectorXd& velocity) const
  {
    return collocation().to_control(velocity);
  }
  /// ∇_s·u at the vertices, averaged over N_k: N.
  Eigen::VectorXd divergence(const Eigen::VectorXd& velocity) const;
  /// The velocity of the volume's centroid, and u minus it at every vertex.
  Vector3 mean_velocity(const Eigen::VectorXd& velocity) const;
  Eigen::VectorXd relative_to_centroid(const Eigen::VectorXd& velocity) const;
};

/// H, K, Δ_s H and the normals that belong to them at the vertices, by the space's way.
Curvature vertex_curvature(const Surface& surface);

/// κ1² + κ2² at the vertices, averaged over N_k on smooth surfaces: N, nowhere negative.
Eigen::VectorXd squared_curvature(const Surface& surface);

/// True where a uniform tension does no work, so that the total area follows from the volume: a
/// relative deviation of the vertices' distance to the centre below 1e-3. The area in excess of a
/// sphere's, its square, is then below 1e-6 and far below what the mesh resolves.
bool nearly_sphere(const Surface& surface);

/// Area and volume of a shape.
class AreaAndVolume
{
public:
  /// The space must outlive it.
  AreaAndVolume(const SurfaceSpace& space, const Points& vertices);

  double area() const { return area_; }
  double volume() const { return volume_; }

  /// Their derivatives, and directions in which a shape is corrected.
  struct Changes
  {
    Eigen::VectorXd area_gradient, volume_gradient;   ///< ∂A/∂x, ∂V/∂x
    Eigen::VectorXd area_direction, volume_direction; ///< about 2 H n and n
  };
  Changes changes() const;

private:
  const SurfaceSpace& space_;
  Points control_;
  SurfacePoints surface_;
  double area_, volume_;
};

}
