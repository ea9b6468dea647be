#pragma once
// Each triangle cut into four at the middles of its sides.

#include "solver/mesh/EdgeUses.h"

namespace vesicle
{

/// The triangles cut into four each, with a new vertex `points` + e on each edge e.
Triangles refined(const Triangles& triangles, const EdgeUses& edges, int points);

}
