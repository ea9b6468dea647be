#pragma once
// Checks and small repairs of meshes that come from elsewhere.

#include "solver/mesh/TriangleMesh.h"

#include <string>

namespace vesicle
{

/// Makes `mesh` fit for dynamics: closed, manifold, consistently oriented, one component, genus 0,
/// no degenerate triangle, no duplicate or unused point, no triangles that cross, finite coordinates. A consistently inward
/// mesh is flipped, and inconsistent orientations of an orientable mesh are mended; the returned
/// text then says so (empty: nothing was changed). Throws InputError naming the place (vertex,
/// triangle or edge with its coordinates) and a remedy, prefixed with `name`.
std::string prepare_for_dynamics(TriangleMesh& mesh, const std::string& name);

/// The structural part that any use needs: indices in range, finite coordinates. Throws InputError.
void check_indices(const TriangleMesh& mesh, const std::string& name);

}
