#pragma once
// The kinds of flow that there are. To add one: a class in a file pair of this folder that
// describes itself (Shear is the simplest), and a line in the list of FlowKinds.cpp. Scenes, data
// sets, pictures and the reference page follow; for a property of the VTK classes its name goes
// into vtkVesicleSceneAlgorithm::FlowKinds and into ParaView's list.

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
