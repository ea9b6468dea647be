// `vesicle validate` as a user calls it, on rows that take no time, and the judgement behind it.
#include "Command.h"

#include "apps/validate/Row.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace vesicle::test
{
namespace
{

using Json = nlohmann::json;
namespace v = validation;

TEST(ValidateRow, IsJudgedByItsKind)
{
  EXPECT_TRUE(v::relative("", -2, -2.01, 0.006).passed);
  EXPECT_FALSE(v::relative("", -2, -2.01, 0.004).passed);
  EXPECT_FALSE(v::relative("", 2, -2, 1).passed);
  EXPECT_TRUE(v::absolute("", 0, 0.1, 0.2).passed);
  EXPECT_FALSE(v::absolute("", 0, -0.3, 0.2).passed);
  EXPECT_TRUE(v::at_most("", 1, 1).passed);
  EXPECT_FALSE(v::at_most("", 1, 1.1).passed);
  EXPECT_TRUE(v::at_least("", 1, 1).passed);
  EXPECT_FALSE(v::at_least("", 1, 0.9).passed);
}

TEST(ValidateRow, FailsWithoutANumber)
{
  for (const double none : { std::nan(""), HUGE_VAL, -HUGE_VAL })
  {
    EXPECT_FALSE(v::relative("", 1, none, 10).passed);
    EXPECT_FALSE(v::absolute("", 1, none, 10).passed);
    EXPECT_FALSE(v::at_most("", 1, none).passed);
    EXPECT_FALSE(v::at_least("", 1, none).passed);
  }
  EXPECT_FALSE(v::stopped("", "why").passed);
}

TEST(Validate, RowsJsonAndChartsOfAFamily)
{
  const TemporaryFolder folder;
  const auto outcome = vesicle_command(folder.path(),
    { "validate", "layer/drag-linear", "fig4/fast", "--json", "rows.json", "--plots", "plots" });
  ASSERT_EQ(outcome.code, 0) << outcome.output << outcome.errors;
  EXPECT_NE(outcome.output.find("layer/drag-linear: Drag of the ellipsoid"), std::string::npos);
  EXPECT_NE(outcome.output.find("22.6938"), std::string::npos) << "Happel and Brenner's number";
  EXPECT_NE(outcome.output.find(" 0 failed, "), std::string::npos);
  const Json report = Json::parse(bytes_of(folder / "rows.json"));
  EXPECT_EQ(report["set"], "fast");
  EXPECT_EQ(report["failed"], 0);
  ASSERT_EQ(report["rows"].size(), 6);
  for (const Json& row : report["rows"])
  {
    EXPECT_EQ(row["passed"], true);
    for (const char* key : { "reference", "computed", "error", "tolerance", "seconds" })
    {
      EXPECT_TRUE(row[key].is_number()) << row["name"] << key;
    }
  }
  EXPECT_EQ(report["rows"][0]["name"], "fig4/fast/velocity error, 1280") << "in the paper's order";
  EXPECT_GT(bytes_of(folder / "plots/fig4-fast.png").size(), 5000);
}

TEST(Validate, ListsCasesAndRunsNone)
{
  const TemporaryFolder folder;
  const auto outcome = vesicle_command(folder.path(), { "validate", "--list" });
  EXPECT_EQ(outcome.code, 0);
  for (const char* name : { "fig3/cotan", "fig4/balanced", "fig5/limit-angle", "fig6/prolate-0.8",
         "fig8/banana", "fig9/inclined", "layer/drag-loop", "relaxation/two-modes" })
  {
    EXPECT_NE(outcome.output.find(name), std::string::npos) << name;
  }
}

TEST(Validate, UnknownNamesAreTwoAndTheKnownOnesAreListed)
{
  const TemporaryFolder folder;
  for (const char* name : { "fig2", "fig", "fig4/", "fig4/fas" })
  {
    const auto outcome = vesicle_command(folder.path(), { "validate", name });
    EXPECT_EQ(outcome.code, 2) << name;
    EXPECT_NE(outcome.errors.find(name), std::string::npos);
    EXPECT_NE(outcome.errors.find("fig5/limit-angle"), std::string::npos) << outcome.errors;
  }
}

TEST(Validate, NowhereToWriteIsFourBeforeAnythingIsComputed)
{
  const TemporaryFolder folder;
  const auto outcome =
    vesicle_command(folder.path(), { "validate", "fig4", "--json", "none/rows.json" });
  EXPECT_EQ(outcome.code, 4);
  EXPECT_EQ(outcome.output.find("fig4/"), std::string::npos) << outcome.output;
}

}
}
