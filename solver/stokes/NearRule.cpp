#include "solver/stokes/NearRule.h"

#include "solver/stokes/SpheresAround.h"

namespace vesicle
{

AdjacencyList near_panels(const SurfacePanels& panels, const Points& points)
{
  std::vector<Vector3> centers;
  std::vector<double> reach;
  for (int panel = 0; panel < panels.size(); ++panel)
  {
    centers.push_back(panels.center(panel));
    reach.push_back(near_panel_radii * panels.radius(panel));
  }
  return SpheresAround(std::move(centers), std::move(reach)).of(points);
}

const GaussRule& near_gauss_rule(double length)
{
  constexpr int most = 48;
  static const auto rules = []
  {
    std::array<GaussRule, most + 1> all;
    for (int n = 1; n <= most; ++n)
      all[n] = gauss_legendre(n);
    return all;
  }();
  const int points = 5 + static_cast<int>(std::ceil(1.5 * length));
  return rules[std::min(points, most)];
}

}
