// What includes what in solver/: nothing below knows what is above.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace vesicle::test
{

namespace
{
namespace fs = std::filesystem;

/// From the ground up: a folder includes itself and those before it, and what stands in solver/.
const std::vector<std::string> folders{ "solver", "solver/files", "solver/linear", "solver/mesh",
  "solver/mesh/io", "solver/mesh/shapes", "solver/mesh/remesh", "solver/mesh/repair",
  "solver/surface", "solver/flow", "solver/membrane", "solver/equilibrium", "solver/adaptation",
  "solver/stokes/kernels", "solver/stokes", "solver/dynamics", "solver/state", "solver/scene",
  "solver/simulation" };

/// The files of a folder itself: "solver/mesh/Topology.cpp" and so on.
std::vector<std::string> sources_in(const std::string& folder)
{
  const fs::path root(VESICLE_SOURCE_DIR);
  std::vector<std::string> result;
  for (const auto& entry : fs::directory_iterator(root / folder))
    if (entry.path().extension() == ".h" || entry.path().extension() == ".cpp")
      result.push_back(fs::relative(entry.path(), root).generic_string());
  return result;
}

/// What a source includes of solver/.
std::set<std::string> includes_of(const std::string& source)
{
  static const std::regex include(R"rx(^#include "(solver/[^"]+)")rx");
  std::ifstream stream(fs::path(VESICLE_SOURCE_DIR) / source);
  std::set<std::string> result;
  std::smatch match;
  for (std::string line; std::getline(stream, line);)
    if (std::regex_search(line, match, include))
      result.insert(match[1]);
  return result;
}

std::string without_extension(const std::string& source)
{
  return fs::path(source).replace_extension().generic_string();
}

/// Which header, with its source, includes which others.
using Graph = std::map<std::string, std::set<std::string>>;

Graph graph_of(const std::vector<std::string>& of)
{
  Graph graph;
  for (const std::string& folder : of)
    for (const std::string& source : sources_in(folder))
      for (const std::string& included : includes_of(source))
        graph[without_extension(source)].insert(without_extension(included));
  for (auto& [file, included] : graph)
    included.erase(file);
  return graph;
}

/// Takes away what includes nothing that is left, until nothing is left but circles and what needs
/// them.
Graph circles(Graph graph)
{
  const auto is_done = [&](const std::string& file) { return !graph.contains(file); };
  while (std::erase_if(graph,
           [&](const auto& entry) { return std::ranges::all_of(entry.second, is_done); }) > 0)
  {
  }
  return graph;
}
}

TEST(IncludeOrder, FoldersIncludeWhatStandsBelowThem)
{
  for (std::size_t place = 0; place < folders.size(); ++place)
  {
    const std::set<std::string> allowed(folders.begin(), folders.begin() + place + 1);
    const std::vector<std::string> sources = sources_in(folders[place]);
    EXPECT_FALSE(sources.empty()) << folders[place];
    for (const std::string& source : sources)
      for (const std::string& included : includes_of(source))
        EXPECT_TRUE(allowed.contains(fs::path(included).parent_path().generic_string()))
          << source << " includes " << included;
  }
}

// A header and its source count as one.
TEST(IncludeOrder, NoFilesIncludeEachOtherInACircle)
{
  const Graph graph =
    graph_of({ "solver/mesh", "solver/mesh/io", "solver/mesh/shapes", "solver/mesh/remesh" });
  EXPECT_FALSE(graph.empty());
  for (const auto& [file, included] : circles(graph))
    ADD_FAILURE() << file << " is in a circle, or includes one";
}

}
