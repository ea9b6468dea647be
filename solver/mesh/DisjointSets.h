#pragma once
// Sets of numbers that grow together.

#include <vector>

namespace vesicle
{

/// Sets of the numbers 0 … n − 1: union–find with path halving.
class DisjointSets
{
public:
  explicit DisjointSets(int n);
  /// The smallest number of the set that i is in.
  int find(int i);
  void unite(int i, int j);

private:
  std::vector<int> parent_;
};

}
