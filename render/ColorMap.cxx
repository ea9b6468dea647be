#include "render/ColorMap.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace vesicle
{
namespace
{

using Lab = std::array<double, 3>;

// Each half has about the same length in CIELAB.
const std::vector<int> diverging_low{ 0x2b5aad, 0x5f93cf, 0xa9c9e6, 0xecebe9 };
const std::vector<int> diverging_high{ 0xecebe9, 0xefb594, 0xd9734f, 0xb03a2c };
// matplotlib's viridis (Smith and van der Walt, CC0) from its second ninth on.
const std::vector<int> viridis{ 0x482878, 0x3e4989, 0x31688e, 0x26828e, 0x1f9e89, 0x35b779,
  0x6ece58, 0xb5de2b, 0xfde725 };

Lab lab_of(int hex)
{
  constexpr int byte = 255;
  const Color rgb{ (hex >> 16) / 255., ((hex >> 8) & byte) / 255., (hex & byte) / 255. };
  Lab lab;
  vtkMath::RGBToLab(rgb.data(), lab.data());
  return lab;
}

double distance(const Lab& a, const Lab& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// A polygon through colours, by its length.
class Path
{
public:
  explicit Path(const std::vector<int>& colors)
  {
    for (const int hex : colors)
    {
      corners_.push_back(lab_of(hex));
      const auto last = corners_.size() - 1;
      length_.push_back(
        last == 0 ? 0 : length_[last - 1] + distance(corners_[last - 1], corners_[last]));
    }
  }

  /// 0 to 1.
  Color at(double share) const
  {
    const double wanted = share * length_.back();
    const auto next = std::upper_bound(length_.begin() + 1, length_.end() - 1, wanted);
    const auto k = static_cast<std::size_t>(next - length_.begin());
    const double t = (wanted - length_[k - 1]) / (length_[k] - length_[k - 1]);
    Lab lab;
    for (int i = 0; i < 3; ++i)
    {
      lab[i] = (1 - t) * corners_[k - 1][i] + t * corners_[k][i];
    }
    Color rgb;
    vtkMath::LabToRGB(lab.data(), rgb.data());
    for (double& c : rgb)
    {
      c = std::clamp(c, 0., 1.);
    }
    return rgb;
  }

private:
  std::vector<Lab> corners_;
  std::vector<double> length_;
};

}

std::vector<Color> color_table(ColorMap map, int count)
{
  const Path low(map == ColorMap::diverging ? diverging_low : viridis);
  const Path high(diverging_high);
  std::vector<Color> colors;
  for (int i = 0; i < count; ++i)
  {
    const double share = i / (count - 1.);
    if (map == ColorMap::sequential)
    {
      colors.push_back(low.at(share));
    }
    else
    {
      colors.push_back(share < 0.5 ? low.at(2 * share) : high.at(2 * share - 1));
    }
  }
  return colors;
}

}
