#pragma once
// The far field by summing all pairs. It needs nothing but source points and targets, as a tree or
// another fast sum would in its place.

#include "solver/stokes/StokesletKernel.h"
#include "solver/mesh/TriangleMesh.h"

namespace vesicle
{

/// velocity += Σ weight G f of all sources at every target, N by 3; a target must not be a source.
/// Threads share the targets; results do not depend on their number.
void add_direct_sum(const ForceSources& sources, const Points& targets, Points& velocity);

}
