#include "solver/surface/FlatPieces.h"

#include <algorithm>

namespace vesicle
{

namespace
{

// Elements of smooth surfaces are cut in cuts² pieces.
constexpr int cuts = 4;
constexpr int corner_count = 3;

// Those whose corners reach the plane y = height, or nearly: an element bulges.
std::vector<int> elements_around(double height, const Surface& surface)
{
  std::vector<int> around;
  const Triangles& elements = surface.space->triangles();
  for (int e = 0; e < elements.rows(); ++e)
  {
    const auto corner = surface.vertices(elements.row(e), Eigen::all);
    const double bulge = 0.5 * (corner.row(0) - corner.row(1)).norm();
    if (corner.col(1).minCoeff() - bulge <= height && height <= corner.col(1).maxCoeff() + bulge)
      around.push_back(e);
  }
  return around;
}

}

FlatPieces::FlatPieces(const SurfaceSpace& space) : points_{ { 0, 0 }, { 1, 0 }, { 0, 1 } }
{
  if (!space.smooth())
    return;
  const auto point = [&](int i, int j)
  {
    const std::array<double, 2> uv{ double(i) / cuts, double(j) / cuts };
    const auto found = std::find(points_.begin(), points_.end(), uv);
    const auto index = static_cast<int>(found - points_.begin());
    if (found == points_.end())
      points_.push_back(uv);
    return index;
  };
  for (int j = 0; j < cuts; ++j)
    for (int i = 0; i + j < cuts; ++i)
    {
      pieces_.push_back({ point(i, j), point(i + 1, j), point(i, j + 1) });
      if (i + j < cuts - 1)
        pieces_.push_back({ point(i + 1, j), point(i + 1, j + 1), point(i, j + 1) });
    }
  std::vector<ParametricPoint> inner;
  for (int e = 0; e < space.triangles().rows(); ++e)
    for (auto uv = points_.begin() + corner_count; uv != points_.end(); ++uv)
      inner.push_back({ e, (*uv)[0], (*uv)[1], 0 });
  inner_ = space.basis().tabulate(inner);
}

FlatSample FlatPieces::around(double height, const Surface& surface, const Points& field) const
{
  if (pieces_.empty())
    return { { surface.vertices, surface.space->triangles() }, field };
  const Points control_field = rows_of_three(surface.to_control(flat(field)));
  const std::vector<int> elements = elements_around(height, surface);
  const auto count = static_cast<Eigen::Index>(elements.size());
  const auto each = static_cast<Eigen::Index>(points_.size());
  const int inner = static_cast<int>(each) - corner_count;
  FlatSample result;
  result.mesh.points.resize(count * each, 3);
  result.field.resize(count * each, 3);
  result.mesh.triangles.resize(count * static_cast<Eigen::Index>(pieces_.size()), 3);
  int point = 0, piece = 0;
  for (const int e : elements)
  {
    for (const auto& [a, b, c] : pieces_)
      result.mesh.triangles.row(piece++) << point + a, point + b, point + c;
    for (const int vertex : surface.space->triangles().row(e))
    {
      result.mesh.points.row(point) = surface.vertices.row(vertex);
      result.field.row(point++) = field.row(vertex);
    }
    for (int row = e * inner; row < (e + 1) * inner; ++row)
    {
      result.mesh.points.row(point) = interpolate(inner_, row, surface.control);
      result.field.row(point++) = interpolate(inner_, row, control_field);
    }
  }
  return result;
}

}
