#include "apps/tradeoff/Grid.h"

#include <algorithm>

namespace vesicle::tradeoff
{
namespace
{

using enum Scene::Preset;

/// The scene's time setting, `finer` times as fine in the error: that is as the square of a step.
TimeSetting finer(TimeSetting time, double by)
{
  time.value /= time.fixed_step ? std::sqrt(by) : by;
  return time;
}

/// A preset over the triangles from the least to `most`.
void add_ladder(
  std::vector<Settings>& grid, Scene::Preset preset, int most, const TimeSetting& time)
{
  for (const int n : triangle_numbers(std::max(most, least_triangles)))
    grid.push_back({ preset, n, time, "" });
}

}

std::vector<int> triangle_numbers(int most)
{
  std::vector<int> numbers;
  for (int n = least_triangles; n <= most; n *= 2)
    numbers.push_back(n);
  return numbers;
}

std::vector<Settings> settings_grid(int most, const TimeSetting& time)
{
  // A factor of the time setting's error that is easily seen, and still so two times over.
  const double factor = time.fixed_step ? 4 : 10;
  const TimeSetting coarse = finer(time, 1 / factor), fine = finer(time, factor),
                    finest = finer(fine, factor);
  std::vector<Settings> grid;
  add_ladder(grid, balanced, most, time);
  add_ladder(grid, balanced, most / 2, coarse);
  add_ladder(grid, balanced, most / 4, fine);
  add_ladder(grid, balanced, most / 16, finest);
  add_ladder(grid, accurate, most / 4, fine);
  add_ladder(grid, fast, most / 2, time);
  add_ladder(grid, fast, most / 4, coarse);
  add_ladder(grid, paper, most / 4, time);
  add_ladder(grid, paper, most / 8, fine);
  for (const char* knob :
    { "quadrature=1", "quadrature=6", "linear_tolerance=1e-5", "precision=double" })
    grid.push_back({ balanced, std::max(most / 4, least_triangles), time, knob });
  return grid;
}

}
