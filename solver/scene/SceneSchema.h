#pragma once
// All that a scene may say: every key is declared here and nowhere else. The reader, the writer,
// the messages, the ranges of other interfaces and the reference page (docs/scenes-reference.md)
// follow.
//
// To add a key: a member of Scene, and a line in the table of SceneSchema.cpp that it belongs to.

#include "solver/scene/SceneKey.h"

#include <string>
#include <vector>

namespace vesicle
{

/// The tables, in the order in which messages list them and they are written; first that without a
/// name, of the keys at the top.
const std::vector<SceneTable>& scene_schema();

/// The first key of this name in a table. There must be one.
const SceneKey& scene_key(const std::string& table, const std::string& name);

// The tables with variants, in files of their own.
SceneTable vesicle_table();
SceneTable flow_table();

}
