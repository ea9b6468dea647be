#include "Command.h"

#include "solver/files/FileBytes.h"
#include "solver/state/Table.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <csignal>
#include <fstream>
#include <set>
#include <sstream>

namespace vesicle::test
{
namespace
{

using Json = nlohmann::json;

/// A sphere of fixed area rises at 2/9 Bo, exactly; six steps.
void write_sphere(const std::filesystem::path& folder)
{
  std::ofstream(folder / "sphere.toml") << R"(
[vesicle]
shape = "sphere"
triangles = 80
[gravity]
bond_number = 1
[time]
end = 0.5
output_every = 0.5
)";
}

/// The settings of the runs that were made, of "  balanced-80-0.001   0.5 s, 6 steps".
std::set<std::string> runs_in(const std::string& output)
{
  std::set<std::string> runs;
  std::istringstream lines(output);
  for (std::string line; std::getline(lines, line);)
    if (line.ends_with(" steps"))
      runs.insert(line.substr(2, line.find(' ', 2) - 2));
  return runs;
}

}

TEST(TradeoffCommand, RecommendsWhatKeepsItsPromise)
{
  const TemporaryFolder folder;
  write_sphere(folder.path());
  const std::vector<std::string> command{ "tradeoff", "sphere.toml", "--tolerance", "1e-3",
    "--budget", "15", "-o", "t" };
  const auto outcome = vesicle_command(folder.path(), command);
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_NE(outcome.output.find("CPU time"), std::string::npos); // how long it will take
  const auto file = [&](const char* name) { return read_file(folder.path() / "t" / name); };
  const Json json = Json::parse(file("tradeoff.json"))["recommended"];
  const Json speed = json["observables"]["velocity_z"];
  const double error = std::abs(speed["value"].get<double>() / (2. / 9) - 1),
               promised = speed["promised_error"].get<double>();
  EXPECT_TRUE(json["keeps_tolerance"].get<bool>());
  EXPECT_LT(error, 1e-3);
  EXPECT_LT(error, 2 * promised);
  EXPECT_GT(error, promised / 2);
  EXPECT_GT(json["cpu_seconds"].get<double>(), 0);

  const std::string recommended = file("recommended.toml");
  EXPECT_NE(recommended.find("preset = \"" + json["settings"]["preset"].get<std::string>()),
    std::string::npos);

  const Table table = parse_table(file("tradeoff.csv"));
  EXPECT_GT(table.rows.size(), 10U);
  double flagged = 0;
  for (const double r : table.column("recommended"))
    flagged += r;
  EXPECT_EQ(flagged, 1);
  EXPECT_GT(file("tradeoff.png").size(), 1000U);
  EXPECT_NE(file("tradeoff.svg").find("<svg"), std::string::npos);

  // The same again: what was run isn't repeated.
  const auto again = vesicle_command(folder.path(), command);
  EXPECT_EQ(again.code, 0) << again.errors;
  const auto first = runs_in(outcome.output);
  EXPECT_GT(first.size(), 10U);
  for (const std::string& run : runs_in(again.output))
    EXPECT_FALSE(first.contains(run)) << run;
}

TEST(TradeoffCommand, GoesOnAfterCtrlC)
{
  const TemporaryFolder folder;
  write_sphere(folder.path());
  const std::vector<std::string> command{ "tradeoff", "sphere.toml", "--budget", "5", "-o", "t" };
  {
    Command running(VESICLE_COMMAND, folder.path(), command);
    const auto first = folder.path() / "t" / "runs" / "balanced-80-0.01" / "summary.json";
    while (running.running() && !is_there(first))
      usleep(1000);
    running.signal(SIGINT);
    EXPECT_EQ(running.wait(), 130) << bytes_of(folder.path() / "stderr.txt");
  }
  const auto outcome = vesicle_command(folder.path(), command);
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_EQ(outcome.output.find("balanced-80-0.01 "), std::string::npos) << "was run again";
}

// Two spheres side by side rise alike, and faster than one.
TEST(TradeoffCommand, LooksAtOneOfSeveralVesiclesOrAtAll)
{
  const TemporaryFolder folder;
  std::ofstream(folder / "two.toml") << R"(
[[vesicle]]
shape = "sphere"
triangles = 80
center = [-2, 0, 0]
[[vesicle]]
shape = "sphere"
triangles = 80
center = [2, 0, 0]
[gravity]
bond_number = 1
[time]
end = 0.2
output_every = 0.2
)";
  const auto outcome = vesicle_command(folder.path(),
    { "tradeoff", "two.toml", "--budget", "5", "--observables", "velocity_z,velocity_z[1]", "-o",
      "t" });
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  const auto file = [&](const char* name) { return read_file(folder.path() / "t" / name); };
  const Json found = Json::parse(file("tradeoff.json"))["recommended"]["observables"];
  const double all = found["velocity_z"]["value"], one = found["velocity_z[1]"]["value"];
  EXPECT_NEAR(one / all, 1, 1e-3);
  EXPECT_NEAR(all / (2. / 9), 1 + 3. / 4 / 4, 0.02); // a force at each centre
  EXPECT_NE(
    file("recommended.toml").find("# of each [[vesicle]]: triangles = "), std::string::npos);
}

TEST(TradeoffCommand, RefusesWhatItCannotCompare)
{
  const TemporaryFolder folder;
  write_sphere(folder.path());
  std::ofstream(folder / "steady.toml")
    << "[vesicle]\nshape = \"sphere\"\n[time]\nend = \"steady\"\noutput_every = 1\n";
  expect_usage_errors(folder.path(),
    { { "tradeoff" }, { "tradeoff", "missing.toml" }, { "tradeoff", "steady.toml" },
      { "tradeoff", "sphere.toml", "--observables", "velocity" },
      { "tradeoff", "sphere.toml", "--observables", "velocity_z[0]" },
      { "tradeoff", "sphere.toml", "--exact", "velocity_z" },
      { "tradeoff", "sphere.toml", "--tolerance", "0" },
      { "tradeoff", "sphere.toml", "--budget", "-1" } });
  EXPECT_FALSE(std::filesystem::exists(folder / "steady-tradeoff"));
}

}
