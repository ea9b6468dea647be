#pragma once
// A velocity field of a pipeline: the flow that a vesicle is put into.

#include "solver/flow/ImposedFlow.h"

#include <memory>
#include <string>

class vtkDataObject;

namespace vesicle
{

/// The field as a flow, steady, in the scene's units. `scene_flow`: the scene's own, which is returned
/// where there are no data. `notes`: added to, what to tell a user. Throws InputError where there are both,
/// or the data are no field (see VelocitySample).
std::shared_ptr<const ImposedFlow> flow_with_field(
  const std::shared_ptr<const ImposedFlow>& scene_flow, vtkDataObject* data, std::string& notes);

}
