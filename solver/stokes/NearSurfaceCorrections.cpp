#include "solver/stokes/NearSurfaceCorrections.h"

#include "solver/ParallelFor.h"
#include "solver/mesh/BoundingBox.h"
#include "solver/stokes/NearRule.h"
#include "solver/stokes/PanelPolynomials.h"
#include "solver/stokes/SpheresAround.h"
#include "solver/stokes/StokesOperator.h"
#include "solver/stokes/WallImage.h"

namespace vesicle
{

namespace
{

// Elements nearer than so many radii have other rules than the regular one.
constexpr double near_element_radii = 4;

using Box = Eigen::AlignedBox3d;
/// One row a term or node.
template<int size>
using Blocks = Eigen::Matrix<double, Eigen::Dynamic, size, Eigen::RowMajor, Monomials::most, size>;
template<int size>
using Block = Eigen::Matrix<double, 1, size>;

/// Around an element's panels.
struct ElementSpheres
{
  std::vector<Vector3> centers;
  std::vector<double> reach; ///< in which a vertex is near
  Box box;                   ///< around all

  ElementSpheres(const PanelBasis& basis, const SurfacePanels& panels)
  {
    for (int e = 0; e < basis.elements(); ++e)
    {
      const int first = basis.first(e), last = basis.first(e + 1);
      Vector3 center = Vector3::Zero();
      for (int p = first; p < last; ++p)
        center += panels.center(p) / (last - first);
      double radius = 0;
      for (int p = first; p < last; ++p)
        radius = std::max(radius, (panels.center(p) - center).norm() + panels.radius(p));
      centers.push_back(center);
      reach.push_back(near_element_radii * radius);
      box.extend(Box(center.array() - reach.back(), center.array() + reach.back()));
    }
  }
};

/// Points of rules on a panel, as the kernel takes them.
class PanelRule
{
public:
  void clear()
  {
    u_.clear();
    v_.clear();
    weight_.clear();
  }
  void add(double u, double v, double weight)
  {
    u_.push_back(u);
    v_.push_back(v);
    weight_.push_back(weight);
  }
  /// Filled up.
  PanelPoints points()
  {
    while (u_.size() % stokeslet_lanes != 0)
      add(u_.back(), v_.back(), 0);
    return { u_.data(), v_.data(), weight_.data(), static_cast<int>(u_.size()) };
  }

private:
  std::vector<double> u_, v_, weight_;
};

bool near_panel(const SurfacePanels& panels, int panel, const Vector3& x)
{
  const double reach = near_panel_radii * panels.radius(panel);
  return (x - panels.center(panel)).squaredNorm() < reach * reach;
}

/// ∫ m_t · kernel dS over a panel, of each of its monomials.
template<int size>
Blocks<size> moments(const SurfacePanels& panels, int panel, PointKind kind, const Vector3& x)
{
  thread_local PanelRule rule;
  rule.clear();
  const auto add = [](double u, double v, double weight) { rule.add(u, v, weight); };
  if (near_panel(panels, panel, x))
    for_each_near_point(panels.nearest(panel, x), x, add);
  else
    for (const TrianglePoint& p : triangle_rule(fixed_panel_points))
      add(p.u, p.v, p.weight);
  const PanelShape shape{ panels.coefficients(panel), panels.degree(),
    panels.coefficient_stride() };
  Blocks<size> sum = Blocks<size>::Zero(polynomial_terms(panels.degree()), size);
  add_moments(kind, rule.points(), shape, x.data(), sum.data());
  return sum;
}

/// The kernel times the weight at a point of a rule.
template<int size>
Block<size> block_of_point(const LayerPoints& points, int row, PointKind kind, const Vector3& x);

template<>
Block<image_components> block_of_point<image_components>(
  const LayerPoints& points, int row, PointKind kind, const Vector3& x)
{
  const Vector3 y = points.surface.position.row(row).transpose();
  const Eigen::Matrix3d image = kind == PointKind::force_image
    ? force_image(x, y)
    : stresslet_image(x, y, -points.surface.cross.row(row).normalized().transpose());
  return points.weight[row] * image.reshaped<Eigen::RowMajor>().transpose();
}

template<>
Block<stokeslet_components> block_of_point<stokeslet_components>(
  const LayerPoints& points, int row, PointKind kind, const Vector3& x)
{
  const Vector3 X = points.surface.position.row(row).transpose() - x;
  const double over_r = 1 / X.norm(), square = over_r * over_r;
  double diagonal = 0, along = 0;
  if (kind == PointKind::force)
  {
    diagonal = points.weight[row] * over_r;
    along = diagonal * square;
  }
  else
    along = points.weight[row] * over_r * square * square *
      X.dot(points.surface.cross.row(row).normalized());
  Block<stokeslet_components> block;
  block << diagonal + along * X.x() * X.x(), along * X.x() * X.y(), along * X.x() * X.z(),
    diagonal + along * X.y() * X.y(), along * X.y() * X.z(), diagonal + along * X.z() * X.z();
  return block;
}

}

NearVertices near_vertices(
  const LayerRules& rules, const Points& control, const std::vector<VertexGroup>& others)
{
  NearVertices near;
  const PanelBasis& basis = rules.panels();
  SurfacePanels panels(basis, control);
  ElementSpheres spheres(basis, panels);
  std::vector<int> candidates;
  std::vector<Eigen::RowVector3d> places;
  for (const VertexGroup& other : others)
    if (spheres.box.intersects(other.box))
      for (int i = 0; i < other.vertices->rows(); ++i)
        if (spheres.box.contains(other.vertices->row(i).transpose()))
        {
          candidates.push_back(other.first + i);
          places.emplace_back(other.vertices->row(i));
        }
  const SpheresAround search(std::move(spheres.centers), std::move(spheres.reach));
  near.elements.start.push_back(0);
  std::vector<int> found;
  for (std::size_t k = 0; k < candidates.size(); ++k)
    if (search.find(places[k].transpose(), found); !found.empty())
    {
      near.vertex.push_back(candidates[k]);
      near.elements.item.insert(near.elements.item.end(), found.begin(), found.end());
      near.elements.start.push_back(static_cast<int>(near.elements.item.size()));
    }
  if (!near.vertex.empty())
    near.panels = std::move(panels);
  return near;
}

std::vector<NearVertices> near_vertices(const std::vector<LayerSurface>& surfaces)
{
  std::vector<VertexGroup> groups;
  int first = 0;
  for (const LayerSurface& surface : surfaces)
  {
    groups.push_back({ first, &surface.vertices, bounding_box(surface.vertices) });
    first += static_cast<int>(surface.vertices.rows());
  }
  std::vector<NearVertices> result(surfaces.size());
  parallel_for(surfaces.size(),
    [&](std::size_t s)
    {
      std::vector<VertexGroup> others = groups;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(s));
      result[s] = near_vertices(*surfaces[s].rules, surfaces[s].control, others);
    });
  return result;
}

NearSurfaceCorrections::NearSurfaceCorrections(
  const Surface& surface, const Points& vertices, const NearVertices& near, PointKind kind)
  : block_size_(block_components(kind)), vertex_(near.vertex)
{
  for (int row = 0; row < static_cast<int>(vertex_.size()); ++row)
  {
    const auto first = static_cast<std::ptrdiff_t>(node_.size());
    for (const int* e = near.elements.begin(row); e != near.elements.end(row); ++e)
    {
      const std::span<const int> nodes = surface.rules.panels().nodes(*e);
      node_.insert(node_.end(), nodes.begin(), nodes.end());
    }
    std::sort(node_.begin() + first, node_.end());
    node_.erase(std::unique(node_.begin() + first, node_.end()), node_.end());
    start_.push_back(node_.size());
  }
  blocks_.assign(block_size_ * node_.size(), 0);
  constexpr int grain = 4;
  parallel_for(
    static_cast<int>(vertex_.size()),
    [&](int row)
    {
      const Vector3 x = vertices.row(vertex_[row]).transpose();
      if (is_image(kind))
        fill<image_components>(surface, near, kind, row, x);
      else
        fill<stokeslet_components>(surface, near, kind, row, x);
    },
    grain);
}

template<int size>
void NearSurfaceCorrections::fill(
  const Surface& surface, const NearVertices& near, PointKind kind, int row, const Vector3& x)
{
  const auto begin = node_.begin() + static_cast<std::ptrdiff_t>(start_[row]),
             end = node_.begin() + static_cast<std::ptrdiff_t>(start_[row + 1]);
  const auto block_of = [&](int node)
  {
    return Eigen::Map<Block<size>>(
      blocks_.data() + size * (std::lower_bound(begin, end, node) - node_.begin()));
  };
  const auto add_rule =
    [&](const LayerRules::Rule& rule, const LayerPoints& points, int element, double sign)
  {
    for (int q = rule.start[element]; q < rule.start[element + 1]; ++q)
    {
      const Block<size> block = sign * block_of_point<size>(points, q, kind, x);
      for (int k = rule.table.start[q]; k < rule.table.start[q + 1]; ++k)
        block_of(rule.table.node[k]) += rule.table.value[k] * block;
    }
  };
  const PanelBasis& basis = surface.rules.panels();
  const LayerRules::Rule& near_rule = surface.rules.near();
  for (const int* e = near.elements.begin(row); e != near.elements.end(row); ++e)
  {
    bool by_panels = near_rule.start[*e] == near_rule.start[*e + 1];
    for (int panel = basis.first(*e); panel < basis.first(*e + 1) && !by_panels; ++panel)
      by_panels = near_panel(*near.panels, panel, x);
    add_rule(surface.rules.regular(), surface.regular, *e, -1);
    if (!by_panels)
    {
      add_rule(near_rule, surface.near, *e, 1);
      continue;
    }
    const std::span<const int> nodes = basis.nodes(*e);
    for (int panel = basis.first(*e); panel < basis.first(*e + 1); ++panel)
    {
      const Blocks<size> of_terms = moments<size>(*near.panels, panel, kind, x);
      const auto C = basis.coefficients(panel);
      for (std::size_t k = 0; k < nodes.size(); ++k)
        block_of(nodes[k]) += C.col(static_cast<Eigen::Index>(k)).transpose().lazyProduct(of_terms);
    }
  }
}

void NearSurfaceCorrections::add(const Eigen::VectorXd& density, Points& velocity) const
{
  constexpr int grain = 32;
  parallel_for(
    static_cast<int>(vertex_.size()),
    [&](int row)
    {
      Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
      for (std::size_t k = start_[row]; k < start_[row + 1]; ++k)
      {
        const double *f = density.data() + 3L * node_[k], *g = blocks_.data() + block_size_ * k;
        if (block_size_ == image_components)
          sum += Eigen::Map<const Eigen::RowVector3d>(f) * Eigen::Map<const Eigen::Matrix3d>(g);
        else
          sum += Eigen::RowVector3d(g[0] * f[0] + g[1] * f[1] + g[2] * f[2],
            g[1] * f[0] + g[3] * f[1] + g[4] * f[2], g[2] * f[0] + g[4] * f[1] + g[5] * f[2]);
      }
      velocity.row(vertex_[row]) += sum;
    },
    grain);
}

}
