#pragma once
// Open borders that aren't meant: corners of neighbouring triangles that differ in the last digits.

#include "solver/mesh/TriangleMesh.h"

#include <optional>

namespace vesicle
{

/// The largest distance between points on the open border and their twins there, where at least
/// half of the border's points have one nearer than 1e-4 of the mesh's diagonal; nothing otherwise.
std::optional<double> seam_gap(const TriangleMesh& mesh);

/// A distance to merge points within that closes such a seam: twice the gap.
double merge_distance(double gap);

}
