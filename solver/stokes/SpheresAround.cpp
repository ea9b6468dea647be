#include "solver/stokes/SpheresAround.h"

#include "solver/ParallelFor.h"

#include <algorithm>
#include <cmath>

namespace vesicle
{

SpheresAround::SpheresAround(std::vector<Vector3> centers, std::vector<double> radii)
  : centers_(std::move(centers)), radii_(std::move(radii))
{
  if (centers_.empty())
    return;
  width_ = *std::max_element(radii_.begin(), radii_.end());
  for (std::size_t i = 0; i < centers_.size(); ++i)
    sorted_.emplace_back(cell(centers_[i]), static_cast<int>(i));
  std::sort(sorted_.begin(), sorted_.end());
}

SpheresAround::Cell SpheresAround::cell(const Vector3& x) const
{
  constexpr double farthest = 1e15; // cells: beyond there are no spheres
  Cell cell;
  for (int c = 0; c < 3; ++c)
    cell[c] = static_cast<std::int64_t>(std::floor(std::clamp(x[c] / width_, -farthest, farthest)));
  return cell;
}

void SpheresAround::find(const Vector3& x, std::vector<int>& found) const
{
  found.clear();
  if (sorted_.empty() || !x.allFinite())
    return;
  const Cell middle = cell(x);
  // Cells that differ in the last number alone lie one after the other.
  for (int i = -1; i <= 1; ++i)
    for (int j = -1; j <= 1; ++j)
    {
      const Cell first{ middle[0] + i, middle[1] + j, middle[2] - 1 };
      auto it = std::lower_bound(sorted_.begin(), sorted_.end(), std::pair(first, -1));
      for (; it != sorted_.end() && it->first[0] == first[0] && it->first[1] == first[1] &&
           it->first[2] <= first[2] + 2;
           ++it)
        if ((x - centers_[it->second]).squaredNorm() < radii_[it->second] * radii_[it->second])
          found.push_back(it->second);
    }
  std::sort(found.begin(), found.end());
}

AdjacencyList SpheresAround::of(const Points& points) const
{
  const auto n = static_cast<int>(points.rows());
  constexpr int grain = 16;
  std::vector<std::vector<int>> found(n);
  parallel_for(
    n, [&](int i) { find(points.row(i).transpose(), found[i]); }, grain);
  AdjacencyList result{ { 0 }, {} };
  for (const std::vector<int>& spheres : found)
  {
    result.item.insert(result.item.end(), spheres.begin(), spheres.end());
    result.start.push_back(static_cast<int>(result.item.size()));
  }
  return result;
}

}
