#pragma once
// Whether vesicles start apart from each other.

#include "solver/mesh/TriangleMesh.h"

#include <optional>
#include <string>
#include <vector>

namespace vesicle
{

struct Overlap
{
  std::size_t first = 0, second = 0; ///< the vesicles, first < second
  bool inside = false;               ///< one of them is inside of the other
  Vector3 place = Vector3::Zero();   ///< of both, a point
};

/// The first pair that is found whose surfaces pass through each other, or of which one encloses the
/// other. Closed meshes that face outward and don't pass through themselves; N log N.
std::optional<Overlap> find_overlap(const std::vector<TriangleMesh>& meshes);

/// "vesicles 0 and 3 overlap near (0, 0, 1)".
std::string to_text(const Overlap& overlap);

/// Whether the point is inside of a closed mesh.
bool encloses(const TriangleMesh& mesh, const Vector3& point);

}
