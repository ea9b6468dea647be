#pragma once
// Velocity fields from VTK's files: the flow that a vesicle is put into.

#include "VesicleFiltersModule.h"

#include "solver/flow/VelocityField.h"
#include "solver/scene/Scene.h"

#include <filesystem>
#include <memory>
#include <string>

namespace vesicle
{

/// Reads .vti .vtr .vts .vtu .vtk, or a .pvd or .series of them, whose times are the samples'. The
/// velocity is the active vectors of the points, else their only array of three components; of
/// cells, brought to the points, where points have none. Of a series two files at a time are kept.
/// `notes`: what to tell a user, a field that isn't free of divergence. Throws InputError naming the file, what is
/// wrong and a remedy.
VESICLEFILTERS_EXPORT std::shared_ptr<const VelocityField> read_velocity_field(
  const std::filesystem::path& file, std::string& notes);

/// The scene with the field that its flow names, if it names one.
VESICLEFILTERS_EXPORT Scene with_velocity_field(Scene scene, std::string& notes);

}
