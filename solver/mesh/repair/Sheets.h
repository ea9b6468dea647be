#pragma once
// Sheets of a surface that hang together at points or edges only, as bodies that touch do.

#include "solver/mesh/TriangleMesh.h"

namespace vesicle
{

/// Gives each sheet its own points, so that the triangles at each point form one fan and each edge
/// has two triangles at most. Of more than two triangles at an edge those belong together that are
/// connected elsewhere by edges of two; where that doesn't tell, those with the inside of the body
/// between them, going by the way they face. What finds no partner is left with an open border
/// there. Points that were one are drawn a little towards their own neighbours, so that the sheets
/// part. Returns how many points were shared. Triangles with a corner twice must not be there.
int part_sheets(TriangleMesh& mesh);

}
