#include "solver/dynamics/WallGap.h"

#include "solver/ParallelFor.h"
#include "solver/stokes/PanelBasis.h"
#include "solver/stokes/PanelPolynomials.h"

#include <Eigen/LU>
#include <fmt/format.h>

#include <algorithm>

namespace vesicle
{

namespace
{

/// A panel's height over the wall and position as polynomials.
class PanelHeight
{
public:
  PanelHeight(const PanelBasis& basis, int panel, const Points& control, const Wall& wall)
    : degree_(basis.degree())
  {
    const std::span<const int> nodes = basis.nodes(basis.element(panel));
    const auto C = basis.coefficients(panel);
    position_ = Eigen::Matrix<double, Eigen::Dynamic, 3>::Zero(C.rows(), 3);
    for (std::size_t k = 0; k < nodes.size(); ++k)
      position_ += C.col(static_cast<Eigen::Index>(k)) * control.row(nodes[k]);
    height_ = position_ * wall.normal;
    height_[0] -= wall.normal.dot(wall.point);
  }

  /// The lowest of the panel's points: from a grid's lowest by Newton's method, with second derivatives
  /// from differences, kept on the panel.
  WallGap lowest() const
  {
    constexpr int divisions = 4, sweeps = 6;
    Eigen::Vector2d at(0, 0);
    for (int i = 0; i <= divisions; ++i)
      for (int j = 0; i + j <= divisions; ++j)
        if (const Eigen::Vector2d candidate = Eigen::Vector2d(i, j) / divisions;
            height(candidate) < height(at))
          at = candidate;
    for (int sweep = 0; sweep < sweeps; ++sweep)
    {
      const Eigen::Vector2d next = on_panel(at - curvature(at).inverse() * slope(at));
      if (!next.allFinite() || height(next) >= height(at))
        break;
      at = next;
    }
    const Eigen::VectorXd m = monomials(at);
    return { m.dot(height_), (m.transpose() * position_).transpose() };
  }

private:
  static Eigen::Vector2d on_panel(Eigen::Vector2d at)
  {
    at = at.cwiseMax(0);
    return at.sum() > 1 ? Eigen::Vector2d(at / at.sum()) : at;
  }
  Eigen::VectorXd monomials(const Eigen::Vector2d& at) const
  {
    return Eigen::Map<const Eigen::VectorXd>(
      Monomials(degree_, at[0], at[1]).value, height_.size());
  }
  double height(const Eigen::Vector2d& at) const { return monomials(at).dot(height_); }
  Eigen::Vector2d slope(const Eigen::Vector2d& at) const
  {
    const Monomials m(degree_, at[0], at[1]);
    const auto along = [&](const double* derivative)
    { return Eigen::Map<const Eigen::VectorXd>(derivative, height_.size()).dot(height_); };
    return { along(m.du), along(m.dv) };
  }
  Eigen::Matrix2d curvature(const Eigen::Vector2d& at) const
  {
    constexpr double step = 1e-4;
    Eigen::Matrix2d result;
    for (int c = 0; c < 2; ++c)
      result.col(c) = (slope(at + step * Eigen::Vector2d::Unit(c)) -
                        slope(at - step * Eigen::Vector2d::Unit(c))) /
        (2 * step);
    return result;
  }

  int degree_;
  Eigen::Matrix<double, Eigen::Dynamic, 3> position_;
  Eigen::VectorXd height_;
};

}

// Elements lie in the hull of their control points, so most can't have the lowest point.
WallGap wall_gap(const Wall& wall, const Proximity::Side& side)
{
  const PanelBasis& basis = side.rules->panels();
  const Surface& surface = *side.surface;
  const Eigen::VectorXd of_control = wall.heights(surface.control),
                        of_vertices = wall.heights(surface.vertices);
  Eigen::Index lowest = 0;
  WallGap gap;
  gap.distance = of_vertices.minCoeff(&lowest);
  gap.place = surface.vertices.row(lowest).transpose();
  for (int e = 0; e < basis.elements(); ++e)
  {
    const std::span<const int> nodes = basis.nodes(e);
    if (std::none_of(
          nodes.begin(), nodes.end(), [&](int k) { return of_control[k] < gap.distance; }))
      continue;
    for (int panel = basis.first(e); panel < basis.first(e + 1); ++panel)
      if (const WallGap there = PanelHeight(basis, panel, surface.control, wall).lowest();
          there.distance < gap.distance)
        gap = there;
  }
  return gap;
}

std::vector<WallGap> wall_gaps(const Wall& wall, const std::vector<Proximity::Side>& sides)
{
  std::vector<WallGap> gaps(sides.size());
  parallel_for(sides.size(), [&](std::size_t v) { gaps[v] = wall_gap(wall, sides[v]); });
  return gaps;
}

std::string to_text(const WallGap& gap)
{
  const std::string where =
    fmt::format("near ({:.4g}, {:.4g}, {:.4g})", gap.place.x(), gap.place.y(), gap.place.z());
  if (gap.distance < 0)
    return "crosses the wall " + where;
  return fmt::format("is {:.3g} from the wall {}", gap.distance, where);
}

}
