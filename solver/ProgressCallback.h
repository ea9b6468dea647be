#pragma once
// Long loops that say how far they are and can be ended.

#include "solver/ParallelFor.h"

#include <algorithm>
#include <functional>

namespace vesicle
{

/// Told the share of the work that is done, 0 to 1, never less than before, on the thread that
/// asked for the work. What it throws ends the work and is passed on. Empty: nobody asks.
using ProgressCallback = std::function<void(double share)>;

/// The part of a larger work that goes from share `from` to share `to`.
inline ProgressCallback part_of(const ProgressCallback& whole, double from, double to)
{
  if (!whole)
    return {};
  return [whole, from, to](double share) { whole(from + (to - from) * share); };
}

/// parallel_for over 0 to count − 1, `part` of them at a time; the progress is told in between.
template<typename Body>
void parallel_for_in_parts(int count, int part, const ProgressCallback& progress, const Body& body)
{
  for (int first = 0; first < count; first += part)
  {
    const int size = std::min(part, count - first);
    parallel_for(size, [&](int i) { body(first + i); });
    if (progress)
      progress(static_cast<double>(first + size) / count);
  }
}

}
