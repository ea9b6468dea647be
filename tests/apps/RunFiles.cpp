#include "RunFiles.h"

#include "Command.h"

#include "vtkfilters/Filters/SeriesFile.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace vesicle::test
{
namespace
{

using std::filesystem::path;

nlohmann::json summary_of(const path& run)
{
  return nlohmann::json::parse(bytes_of(run / "summary.json"));
}

std::size_t pictures_in(const path& folder)
{
  std::size_t count = 0;
  std::error_code missing;
  for (const auto& entry : std::filesystem::directory_iterator(folder, missing))
  {
    count += entry.path().extension() == ".png";
  }
  return count;
}

}

bool draws(const path& run)
{
  return summary_of(run)["movie"].get<std::string>().find("nothing to draw") == std::string::npos;
}

void expect_complete_run(const path& run, std::size_t frames)
{
  ASSERT_TRUE(std::filesystem::exists(run / "summary.json"));
  const auto summary = summary_of(run);
  const std::string name = summary["name"];
  EXPECT_TRUE(summary["outcome"] == "finished" || summary["outcome"] == "steady") << summary;
  const auto series = read_series(run / (name + ".pvd"));
  EXPECT_GE(series.size(), frames);
  const std::string table = bytes_of(run / (name + ".csv"));
  EXPECT_EQ(table.find("nan"), std::string::npos);
  EXPECT_EQ(table.find("inf"), std::string::npos);
  if (draws(run))
  {
    EXPECT_GE(pictures_in(run / "plots"), 2u);
    EXPECT_EQ(pictures_in(run / "movie"), series.size()) << summary["movie"];
  }
}

}
