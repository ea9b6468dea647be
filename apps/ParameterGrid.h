#pragma once
// Settings of a scene to be run through.

#include <string>
#include <vector>

namespace vesicle
{

/// One key and what it is to be.
struct ParameterRange
{
  std::string key; ///< "membrane.bending_rigidity"
  std::vector<std::string> values;
};

/// Of "table.key=0.5,1,2" or "table.key=0.9:0.6:0.1" (from, to, step; both ends where steps meet
/// them). Commas within brackets part no values. Throws InputError.
ParameterRange parse_range(const std::string& text);

struct GridPoint
{
  std::vector<std::string> values;    ///< by range
  std::vector<std::string> overrides; ///< "table.key=value"
  std::string name; ///< of its folder: "bending_rigidity=0.5_reduced_volume=0.9", each another
};

/// Every value of each range with every of the others, the last range's first. Throws InputError
/// where a key is there twice, or over `most` points.
std::vector<GridPoint> parameter_grid(
  const std::vector<ParameterRange>& ranges, int most = 100'000);

}
