#include "solver/mesh/io/GridFile.h"

#include "solver/Errors.h"

#include <algorithm>

namespace vesicle
{

namespace
{

/// `more`: than steps between points, along each axis.
std::int64_t product(const std::array<int, 6>& extent, int more, const std::string& name)
{
  std::int64_t product = 1;
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::int64_t steps = static_cast<std::int64_t>(extent[2 * axis + 1]) - extent[2 * axis];
    if (steps < 0)
      return 0;
    if (__builtin_mul_overflow(product, std::max(steps + more, std::int64_t(1)), &product))
      throw InputError(name + ": its extent is of more points than there can be; write it anew");
  }
  return product;
}

}

std::int64_t points_in(const std::array<int, 6>& extent, const std::string& name)
{
  return product(extent, 1, name);
}

std::int64_t cells_in(const std::array<int, 6>& extent, const std::string& name)
{
  return product(extent, 0, name);
}

}
