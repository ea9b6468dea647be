#pragma once
// The kinds of flow that there are.

#include "solver/flow/FlowKind.h"

#include <vector>

namespace vesicle
{

/// A kind's place in the list, from 1, is its number in data sets (Flow_Kind): new ones go to the
/// end.
const std::vector<const FlowKind*>& flow_kinds();

/// The number of a kind, from 1.
int number_of(const FlowKind& kind);

}
