#include "solver/surface/VertexClusters.h"

namespace vesicle
{

VertexClusters::VertexClusters(const Points& points, const AdjacencyList& neighbours, double radius)
{
  constexpr std::size_t most = 256;
  const int n = static_cast<int>(points.rows());
  std::vector<char> taken(n, 0);
  member_.reserve(n);
  for (int first = 0; first < n; ++first)
  {
    if (taken[first])
      continue;
    const auto take = [&](int i)
    {
      taken[i] = 1;
      member_.push_back(i);
    };
    const std::size_t begin = member_.size();
    take(first);
    for (std::size_t k = begin; k < member_.size(); ++k)
      for (const int* j = neighbours.begin(member_[k]); j != neighbours.end(member_[k]); ++j)
        if (!taken[*j] && member_.size() - begin < most &&
          (points.row(*j) - points.row(first)).squaredNorm() <= radius * radius)
          take(*j);
    start_.push_back(static_cast<int>(member_.size()));
  }
}

}
