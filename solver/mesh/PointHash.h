#pragma once
// Finds points that lie within a tolerance of each other, in linear time.

#include "solver/mesh/TriangleMesh.h"

#include <cstdint>
#include <unordered_map>

namespace vesicle
{

class PointHash
{
public:
  /// Points within `tolerance` (> 0) count as the same. Coordinates up to 10¹⁸ tolerances are told
  /// apart.
  explicit PointHash(double tolerance) : tolerance_(tolerance) {}

  void insert(const Vector3& point, int id);
  /// The id of some inserted point within the tolerance, −1 if there is none.
  int find(const Vector3& point) const;

private:
  struct Entry
  {
    Vector3 point;
    int id;
  };
  using Cell = Eigen::Matrix<std::int64_t, 3, 1>;
  Cell cell(const Vector3& point) const;
  static std::uint64_t key(const Cell& cell);

  double tolerance_;
  std::unordered_multimap<std::uint64_t, Entry> cells_;
};

}
