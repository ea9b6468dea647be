#include "solver/mesh/DisjointSets.h"

#include <algorithm>
#include <numeric>

namespace vesicle
{

DisjointSets::DisjointSets(int n) : parent_(n)
{
  std::iota(parent_.begin(), parent_.end(), 0);
}

int DisjointSets::find(int i)
{
  while (parent_[i] != i)
  {
    parent_[i] = parent_[parent_[i]];
    i = parent_[i];
  }
  return i;
}

// The smaller number represents the set.
void DisjointSets::unite(int i, int j)
{
  const auto [low, high] = std::minmax({ find(i), find(j) });
  parent_[high] = low;
}

}
