#include "apps/AreaStatistics.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace vesicle
{
namespace
{

struct Sample
{
  double value, area;
};

std::vector<Sample> sorted(const std::vector<double>& values, const std::vector<double>& areas)
{
  std::vector<Sample> samples;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    samples.push_back({ values[i], areas[i] });
  }
  std::stable_sort(samples.begin(), samples.end(),
    [](const Sample& l, const Sample& r) { return l.value < r.value; });
  return samples;
}

double percentile(const std::vector<Sample>& samples, double area, int percent)
{
  double below = 0;
  for (const Sample& sample : samples)
  {
    below += sample.area;
    if (100 * below >= percent * area)
    {
      return sample.value;
    }
  }
  return samples.back().value; // rounding
}

void fill_bins(AreaStatistics& s, const std::vector<Sample>& samples, int count)
{
  const double low = s.percentiles.front(), high = s.percentiles.back();
  if (!(high > low))
  {
    s.bins = { { s.least, s.greatest, 1 } };
    return;
  }
  const double width = (high - low) / count;
  for (int i = 0; i < count; ++i)
  {
    s.bins.push_back({ low + i * width, low + (i + 1) * width, 0 });
  }
  s.bins.front().from = s.least;
  s.bins.back().to = s.greatest;
  for (const Sample& sample : samples)
  {
    const double place = std::clamp(std::floor((sample.value - low) / width), 0., count - 1.);
    s.bins[static_cast<std::size_t>(place)].share += sample.area / s.area;
  }
}

}

AreaStatistics area_statistics(
  const std::vector<double>& values, const std::vector<double>& areas, int bins)
{
  AreaStatistics s;
  const std::vector<Sample> samples = sorted(values, areas);
  for (const Sample& sample : samples)
  {
    s.area += sample.area;
    s.mean += sample.area * sample.value;
  }
  if (samples.empty() || !(s.area > 0))
  {
    return s;
  }
  s.mean /= s.area;
  double variance = 0;
  for (const Sample& sample : samples)
  {
    variance += sample.area / s.area * (sample.value - s.mean) * (sample.value - s.mean);
  }
  s.deviation = std::sqrt(variance);
  s.least = samples.front().value;
  s.greatest = samples.back().value;
  for (std::size_t i = 0; i < s.percents.size(); ++i)
  {
    s.percentiles[i] = percentile(samples, s.area, s.percents[i]);
  }
  fill_bins(s, samples, bins);
  return s;
}

}
