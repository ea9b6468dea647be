#pragma once
// Noise and staircases taken out of a mesh, its triangles kept.

#include "solver/mesh/TriangleMesh.h"

namespace vesicle
{

/// So many passes that move each point by λ = 0.5 and then by μ = −0.53 of the way to the mean of
/// its neighbours: a low-pass filter that doesn't shrink (G. Taubin, Proc. SIGGRAPH 1995, 351).
/// Points on open borders stay.
void smooth_noise(TriangleMesh& mesh, int passes);

}
