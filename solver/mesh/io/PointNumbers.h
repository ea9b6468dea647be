#pragma once
// Makes points of corners: those of the same coordinates are one.

#include "solver/mesh/TriangleMesh.h"

#include <array>
#include <bit>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace vesicle
{

class PointNumbers
{
public:
  /// The number of the point at these coordinates, and whether it is new.
  std::pair<std::int64_t, bool> number(const std::array<double, 3>& corner)
  {
    Bits bits;
    for (int k = 0; k < 3; ++k)
      bits[k] = std::bit_cast<std::uint64_t>(corner[k] + 0.); // −0 becomes +0
    const auto [found, is_new] = numbers_.try_emplace(bits, numbers_.size());
    if (is_new)
      coordinates_.insert(coordinates_.end(), corner.begin(), corner.end());
    return { found->second, is_new };
  }
  Points points() const
  {
    return Eigen::Map<const Points>(
      coordinates_.data(), static_cast<Eigen::Index>(coordinates_.size() / 3), 3);
  }

private:
  using Bits = std::array<std::uint64_t, 3>; ///< under which NaN, too, equals itself
  struct Hash
  {
    std::size_t operator()(const Bits& bits) const
    {
      std::uint64_t hash = 0;
      for (const std::uint64_t x : bits)
      {
        hash = (hash ^ x) * 0x9E3779B97F4A7C15ULL;
        hash ^= hash >> 32;
      }
      return hash;
    }
  };

  std::unordered_map<Bits, std::int64_t, Hash> numbers_;
  std::vector<double> coordinates_;
};

}
