#include "solver/scene/SceneReference.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

using namespace vesicle;

// Written anew by bin/scene_reference > docs/scenes-reference.md.
TEST(SceneReference, PageIsWhatTheSchemaSays)
{
  const auto page = std::filesystem::path(VESICLE_SOURCE_DIR) / "docs/scenes-reference.md";
  std::ostringstream text;
  text << std::ifstream(page).rdbuf();
  EXPECT_EQ(text.str(), scene_reference());
}
