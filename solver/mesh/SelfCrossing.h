#pragma once
// Where a mesh passes through itself.

#include "solver/mesh/TriangleMesh.h"

#include <optional>
#include <string>

namespace vesicle
{

struct Crossing
{
  int first = -1; ///< triangles, first < second
  int second = -1;
  Vector3 place = Vector3::Zero(); ///< a point that both contain
};

/// Two triangles that pass through each other: a side or median of one goes through the inside of the
/// other, by more than rounding and by more than 1e-8 of their longest side. Triangles that only touch,
/// neighbours folded onto each other and sheets that lie in one plane don't count. Any triangle
/// mesh; N log N for one that doesn't cross (0.1 s for 100,000 triangles).
std::optional<Crossing> find_self_crossing(const TriangleMesh& mesh);

/// "triangles 4 and 17 cross near (0, 0, 1)".
std::string to_text(const Crossing& crossing);

}
