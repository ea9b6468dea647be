#include "apps/tradeoff/Extrapolation.h"

#include "solver/Errors.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vesicle::tradeoff
{
namespace
{

constexpr int orders_tried = 41;
constexpr double irregular_share = 0.25; ///< of |c|, before the samples tell
constexpr double prior_samples = 1;      ///< that this counts for

void require_usable(const std::vector<Sample>& samples, const Orders& orders)
{
  if (!(orders.lowest > 0) || !(orders.highest >= orders.lowest))
    throw InputError("extrapolation: orders must be positive, the lowest first");
  for (const Sample& s : samples)
    if (!(s.h > 0) || !std::isfinite(s.h) || !std::isfinite(s.value))
      throw InputError("extrapolation: resolutions must be positive, values finite");
}

/// The finest first, in units of its h; those of the same h as one.
std::vector<Sample> merged(std::vector<Sample> samples)
{
  std::ranges::sort(samples, {}, &Sample::h);
  std::vector<Sample> result;
  std::vector<int> counts;
  constexpr double same = 1e-9;
  for (const Sample& s : samples)
    if (!result.empty() && s.h <= result.back().h * (1 + same))
    {
      ++counts.back();
      result.back().value += (s.value - result.back().value) / counts.back();
    }
    else
    {
      result.push_back(s);
      counts.push_back(1);
    }
  for (Sample& s : result)
    s.h /= samples.front().h;
  return result;
}

struct Fit
{
  double limit, variance, log_likelihood;
};

/// Weighted rows (h^−p, 1) of the unknowns (q, c), right-hand side q_i h_i^−p; values are counted from
/// the finest's, which keeps their digits.
Fit fit(const std::vector<Sample>& samples, double p)
{
  double aa = 0, ab = 0, bb = 0, ay = 0, by = 0, log_h = 0;
  const double origin = samples.front().value;
  for (const Sample& s : samples)
  {
    const double a = std::pow(s.h, -p), y = (s.value - origin) * a;
    aa += a * a;
    ab += a;
    bb += 1;
    ay += a * y;
    by += y;
    log_h += std::log(s.h);
  }
  const double determinant = aa * bb - ab * ab, q = (bb * ay - ab * by) / determinant,
               c = (aa * by - ab * ay) / determinant;
  double squares = prior_samples * std::pow(irregular_share * c, 2);
  for (const Sample& s : samples)
    squares += std::pow((s.value - origin - q) * std::pow(s.h, -p) - c, 2);
  const double freedom = static_cast<double>(samples.size()) - 2 + prior_samples,
               variance = squares / freedom;
  const double tiny = std::numeric_limits<double>::min();
  return { origin + q, variance * bb / determinant,
    -freedom / 2 * std::log(std::max(variance, tiny)) - p * log_h - std::log(determinant) / 2 };
}

}

Limit extrapolate(std::vector<Sample> samples, const Orders& orders)
{
  require_usable(samples, orders);
  if (samples.empty())
    throw InputError("extrapolation: there is no sample");
  samples = merged(std::move(samples));
  if (samples.size() < 2)
    throw InputError("extrapolation: two different resolutions are needed");
  std::vector<Fit> fits;
  double best = -std::numeric_limits<double>::infinity();
  const auto order = [&](int i)
  { return orders.lowest + (orders.highest - orders.lowest) * i / (orders_tried - 1); };
  for (int i = 0; i < orders_tried; ++i)
  {
    fits.push_back(fit(samples, order(i)));
    best = std::max(best, fits.back().log_likelihood);
  }
  // Moments about the finest value, so that no digits are lost.
  const double origin = samples.front().value;
  double weights = 0, mean = 0, square = 0, variance = 0, p = 0;
  for (int i = 0; i < orders_tried; ++i)
  {
    const Fit& f = fits[static_cast<std::size_t>(i)];
    const double w = std::exp(f.log_likelihood - best), d = f.limit - origin;
    weights += w;
    mean += w * d;
    square += w * d * d;
    variance += w * f.variance;
    p += w * order(i);
  }
  mean /= weights;
  const double spread = std::max(0., square / weights - mean * mean),
               few = 1 + 2 / (static_cast<double>(samples.size()) - 1);
  return { origin + mean, few * std::sqrt(variance / weights + spread), p / weights };
}

}
