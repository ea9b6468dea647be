#pragma once
// The cells of unstructured grids that a surface can have, by VTK's numbers.

#include "solver/mesh/PolygonMesh.h"

#include <cstdint>
#include <span>
#include <string>

namespace vesicle
{

/// Adds the polygons of a cell: triangles, quadrilaterals, pixels, polygons and triangle strips;
/// vertices and lines are left out. Throws InputError "name: …" with the type's name and a remedy
/// for any other.
void add_cell(PolygonList& polygons, int type, std::span<const std::int64_t> corners,
  std::int64_t cell, const std::string& name);

}
