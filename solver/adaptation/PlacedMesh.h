#pragma once
// A mesh whose vertices are places on Loop's surface, moved along it.

#include "solver/surface/LimitSurface.h"

namespace vesicle
{

struct PlacedMesh
{
  std::vector<SurfacePlace> places; ///< of the vertices
  Triangles triangles;
};

TriangleMesh mesh_of(const PlacedMesh& mesh, const LimitSurface& surface);

/// `passes` rounds along the surface towards wanted edge lengths (SizingLaw.h), given at the vertices
/// of the surface's own mesh.
void spread(
  PlacedMesh& mesh, const LimitSurface& surface, const Eigen::VectorXd& edge_lengths, int passes);

/// Each triangle cut in four, the new vertices near the middles of its sides.
PlacedMesh refined(const PlacedMesh& mesh, const LimitSurface& surface);

/// True where neighbouring triangles face each other.
bool folds_over(const TriangleMesh& mesh);

}
