#include "solver/mesh/PointHash.h"

#include <cmath>

namespace vesicle
{

// Cells are two tolerances wide, so that a ball of one tolerance reaches into two cells a
// direction.
PointHash::Cell PointHash::cell(const Vector3& point) const
{
  constexpr double last = 1LL << 62;
  const auto cells = (point / (2 * tolerance_)).array().floor();
  return cells.max(-last).min(last).matrix().cast<std::int64_t>();
}

// Different cells may share a key: find() compares the points themselves.
std::uint64_t PointHash::key(const Cell& cell)
{
  std::uint64_t hash = 0;
  for (const std::int64_t coordinate : cell)
  {
    hash = (hash ^ static_cast<std::uint64_t>(coordinate)) * 0x9E3779B97F4A7C15ULL;
    hash ^= hash >> 32;
  }
  return hash;
}

void PointHash::insert(const Vector3& point, int id)
{
  cells_.emplace(key(cell(point)), Entry{ point, id });
}

int PointHash::find(const Vector3& point) const
{
  const Cell low = cell(point.array() - tolerance_);
  const Cell high = cell(point.array() + tolerance_);
  for (std::int64_t i = low[0]; i <= high[0]; ++i)
  {
    for (std::int64_t j = low[1]; j <= high[1]; ++j)
    {
      for (std::int64_t k = low[2]; k <= high[2]; ++k)
      {
        const auto [first, last] = cells_.equal_range(key(Cell(i, j, k)));
        for (auto entry = first; entry != last; ++entry)
          if ((entry->second.point - point).norm() <= tolerance_)
            return entry->second.id;
      }
    }
  }
  return -1;
}

}
