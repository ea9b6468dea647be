#pragma once
// The map as a picture: a row for what is varied, a box for each value, its colour for what became of it.

#include <filesystem>
#include <string>
#include <vector>

namespace vesicle::test
{

struct MapBox
{
  std::string row, label, note; ///< the note in smaller letters below the label
  std::string end;              ///< end_name
};

/// As PNG; boxes of a row stand together.
void write_map(
  const std::filesystem::path& file, const std::string& title, const std::vector<MapBox>& boxes);

}
