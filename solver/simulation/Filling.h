#pragma once
// Copies of a vesicle at random places of a region, apart from each other: what a suspension starts
// from.

#include "solver/mesh/TriangleMesh.h"
#include "solver/stokes/Wall.h"

#include <Eigen/Geometry>

#include <cstdint>
#include <optional>
#include <vector>

namespace vesicle
{

struct FillRegion
{
  enum class Kind
  {
    box,  ///< sides along x, y, z
    tube, ///< a cylinder along x
    ball
  };
  Kind kind = Kind::box;
  Vector3 sides = Vector3::Ones(); ///< of the box; of the tube its length is the first
  double radius = 1;               ///< of tube and ball
  Vector3 center = Vector3::Zero();

  bool contains(const Vector3& point) const;
  double volume() const;
  /// Half the sides of the box around it.
  Vector3 half_sides() const;
};

struct FillSettings
{
  int count = 1;
  FillRegion region;
  double gap = 0;                ///< that vesicles have between each other at the least
  std::uint64_t seed = 0;        ///< equal settings fill equally
  bool turned = true;            ///< each at random; otherwise all as the shape is
  std::optional<Wall> wall = {}; ///< that vesicles stay the gap above
};

/// Of a copy: its points are turn · x + center of the shape's x.
struct Placement
{
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
  Vector3 center = Vector3::Zero();
};

/// One after the other, each at the first random place where it fits (random sequential addition,
/// which packs spheres to about a third of the volume). `shape`: a closed mesh that faces outward about
/// its centroid at the origin. Gaps are those of the points of either from the triangles of the other.
/// Throws InputError, telling how many fitted, where a copy finds no place in 100,000 tries.
std::vector<Placement> fill(const TriangleMesh& shape, const FillSettings& settings);

}
