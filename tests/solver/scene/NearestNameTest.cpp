#include "solver/scene/NearestName.h"

#include <gtest/gtest.h>

using namespace vesicle;

TEST(NearestName, EditDistance)
{
  EXPECT_EQ(edit_distance("", ""), 0);
  EXPECT_EQ(edit_distance("", "rate"), 4);
  EXPECT_EQ(edit_distance("rate", "rate"), 0);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
  EXPECT_EQ(edit_distance("Rate", "rate"), 0);
}

TEST(NearestName, FindsWhatWasMeantAndNothingElse)
{
  const std::vector<std::string> known{ "rate", "radius", "reduced_volume" };
  EXPECT_EQ(nearest_name("rat", known), "rate");
  EXPECT_EQ(nearest_name("reduced_vloume", known), "reduced_volume");
  EXPECT_EQ(nearest_name("reduced volume", known), "reduced_volume");
  EXPECT_EQ(nearest_name("temperature", known), "");
}
