#pragma once
// Far fields: how the sum over all pairs of source points and targets is made.

#include "solver/stokes/StokesletKernel.h"
#include "solver/mesh/TriangleMesh.h"

#include <functional>

namespace vesicle
{

/// velocity += Σ weight G f of all sources at every target, N by 3; a target must not be a source.
/// The place of a tree, an FMM or another device.
using FarSum =
  std::function<void(const ForceSources& sources, const Points& targets, Points& velocity)>;

/// The FarSum that takes pair by pair.
/// Threads share the targets; results do not depend on their number.
void add_direct_sum(const ForceSources& sources, const Points& targets, Points& velocity);

}
