#pragma once
// Which settings a trade-off tries.

#include "apps/tradeoff/Settings.h"

#include <vector>

namespace vesicle::tradeoff
{

/// Numbers of triangles that are tried, each twice the one before.
std::vector<int> triangle_numbers(int most);
inline constexpr int least_triangles = 80, most_triangles = 5120;

/// All that is tried with meshes of at most so many triangles, around the scene's own time setting:
///  - the default preset over all triangles, with a ladder of time settings, the finer the fewer triangles;
///  - the other presets, the paper's among them, on somewhat coarser meshes;
///  - one knob after the other (quadrature, linear tolerance, precision) on a middling mesh.
/// What is finest in triangles and what is finest in time differ, as errors in space and time add up.
std::vector<Settings> settings_grid(int most, const TimeSetting& time);

}
