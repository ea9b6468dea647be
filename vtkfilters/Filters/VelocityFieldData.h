#pragma once
// A velocity field of a pipeline: the flow that a vesicle is put into.

#include "solver/scene/Scene.h"

#include <string>

class vtkDataObject;

namespace vesicle
{

/// The scene with the field as its flow, steady and in its units; nullptr: as it is. `notes`: what to tell a
/// user. Throws InputError where the scene has a flow already, or the data are no field (see VelocitySample).
Scene in_velocity_field(Scene scene, vtkDataObject* data, std::string& notes);

}
