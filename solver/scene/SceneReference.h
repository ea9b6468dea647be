#pragma once
// The reference page of scenes: what the schema declares, for people.

#include <string>

namespace vesicle
{

/// In Markdown. docs/scenes-reference.md is this text.
std::string scene_reference();

}
