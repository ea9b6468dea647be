#pragma once
// How far vesicles are from a wall.

#include "solver/dynamics/Proximity.h"
#include "solver/stokes/Wall.h"

#include <limits>
#include <string>
#include <vector>

namespace vesicle
{

/// Between a vesicle's surface, not its vertices alone, and the wall; below 0 they cross.
struct WallGap
{
  double distance = std::numeric_limits<double>::infinity();
  Vector3 place = Vector3::Zero(); ///< on the surface
};

WallGap wall_gap(const Wall& wall, const Proximity::Side& side);
/// Of each surface. Threads share the surfaces.
std::vector<WallGap> wall_gaps(const Wall& wall, const std::vector<Proximity::Side>& sides);

/// "0.01 from the wall near (0, 0, 1)", or that it crosses it.
std::string to_text(const WallGap& gap);

}
