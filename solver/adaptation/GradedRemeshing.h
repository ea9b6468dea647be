#pragma once
// A mesh brought to wanted edge lengths by splits, collapses and flips of its edges.

#include "solver/adaptation/PlacedMesh.h"

namespace vesicle
{

/// About `triangles` triangles on the surface, made from the surface's own (M. Botsch, L. Kobbelt,
/// Symposium on Geometry Processing 2004, 185; edges are measured in the length that is wanted at
/// their ends). Its vertices have four to eight neighbours: necks and tethers, around which there are
/// fewer triangles than around the bodies that they join, can't do without sevens.
PlacedMesh graded_remeshing(
  const LimitSurface& surface, const Eigen::VectorXd& edge_lengths, int triangles);

}
