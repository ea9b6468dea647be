#pragma once

#include "solver/dynamics/Proximity.h"

namespace vesicle::test
{

/// However large it is. With at least two vesicles.
inline Gap smallest_gap(const std::vector<Proximity::Side>& sides)
{
  for (double reach = 0.25;; reach *= 1.5)
    if (const auto gap = Proximity(sides, reach).smallest())
      return *gap;
}

}
