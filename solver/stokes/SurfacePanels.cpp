#include "solver/stokes/SurfacePanels.h"

#include "solver/mesh/TriangleTree.h"
#include "solver/stokes/PanelPolynomials.h"

#include <algorithm>

namespace vesicle
{

namespace
{

// Levels of halving towards extraordinary vertices, where the tension force goes with a curvature
// that isn't smooth.
constexpr int grading = 4;
// Gauss–Newton for the nearest point: steps below this part of the panel end it. It converges where
// x is nearer than the radius of curvature; elsewhere a rough answer does.
constexpr double smallest_step = 1e-12;
constexpr int max_sweeps = 12;
// The sphere around a panel's corners and mid-sides holds the rest with this margin.
constexpr double sphere_margin = 1.05;

}

SurfacePanels::SurfacePanels(
  const Basis& basis, const Points& control, const ForceDensity& density, const Points& velocity)
  : components_(velocity.rows() > 0 ? 9 : 6)
{
  const bool smooth = basis.smooth();
  degree_ = smooth ? smooth_panel_degree : 1;
  const std::vector<TrianglePoint> nodes = interpolation_nodes(degree_);
  terms_ = static_cast<int>(nodes.size());
  const BasisTable table = basis.tabulate(basis.rule(nodes, smooth ? grading : 0));
  const SurfacePoints surface = evaluate(table, control);

  Eigen::MatrixXd values(table.rows(), components_);
  values.leftCols<3>() = surface.position;
  values.middleCols<3>(3) = density(table, surface).array().colwise() * surface.area_weight.array();
  if (has_velocity())
    values.rightCols<3>() = interpolate(table, velocity);
  const Eigen::MatrixXd to_coefficients = interpolation_matrix(nodes, degree_);
  coefficients_.resize(values.size());
  for (int first = 0; first < table.rows(); first += terms_)
    Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
      coefficients_.data() + static_cast<long>(first) * components_, terms_, components_) =
      to_coefficients * values.middleRows(first, terms_);

  find_spheres(table.rows() / terms_);
}

SurfacePanels::SurfacePanels(const PanelBasis& basis, const Points& control)
  : degree_(basis.degree()), terms_(basis.terms()), components_(3)
{
  coefficients_.resize(static_cast<std::size_t>(basis.size()) * terms_ * components_);
  for (int element = 0; element < basis.elements(); ++element)
  {
    const std::span<const int> nodes = basis.nodes(element);
    Eigen::Matrix<double, Eigen::Dynamic, 3> at(nodes.size(), 3);
    for (std::size_t k = 0; k < nodes.size(); ++k)
      at.row(static_cast<Eigen::Index>(k)) = control.row(nodes[k]);
    for (int panel = basis.first(element); panel < basis.first(element + 1); ++panel)
      Eigen::Map<Points>(coefficients_.data() + static_cast<long>(panel) * terms_ * components_,
        terms_, 3) = basis.coefficients(panel) * at;
  }
  find_spheres(basis.size());
}

void SurfacePanels::find_spheres(int panels)
{
  center_.resize(panels);
  radius_.resize(panels); // sets size()
  for (int panel = 0; panel < panels; ++panel)
  {
    const Vector3 middle = frame(panel, 1. / 3, 1. / 3).position;
    double radius = 0;
    for (const auto& [u, v] : { std::array{ 0., 0. }, std::array{ 1., 0. }, std::array{ 0., 1. },
           std::array{ 0.5, 0. }, std::array{ 0., 0.5 }, std::array{ 0.5, 0.5 } })
      radius = std::max(radius, (frame(panel, u, v).position - middle).norm());
    center_[panel] = middle;
    radius_[panel] = sphere_margin * radius;
  }
}

SurfacePanels::Sample SurfacePanels::sample(int panel, double u, double v) const
{
  const Monomials monomial(degree_, u, v);
  constexpr int components = 6;
  const double* c = coefficients_.data() + static_cast<long>(panel) * terms_ * components_;
  double sum[components] = {};
  for (int term = 0; term < terms_; ++term, c += components_)
    for (int k = 0; k < components; ++k)
      sum[k] += monomial.value[term] * c[k];
  return { { sum[0], sum[1], sum[2] }, { sum[3], sum[4], sum[5] } };
}

SurfacePanels::Frame SurfacePanels::frame(int panel, double u, double v) const
{
  const Monomials monomial(degree_, u, v);
  const double* c = coefficients_.data() + static_cast<long>(panel) * terms_ * components_;
  Frame f{ u, v, Vector3::Zero(), Vector3::Zero(), Vector3::Zero() };
  for (int term = 0; term < terms_; ++term, c += components_)
  {
    const Eigen::Map<const Vector3> x(c);
    f.position += monomial.value[term] * x;
    f.tangent_u += monomial.du[term] * x;
    f.tangent_v += monomial.dv[term] * x;
  }
  return f;
}

SurfacePanels::Motion SurfacePanels::motion(int panel, double u, double v) const
{
  const Monomials monomial(degree_, u, v);
  const double* c = coefficients_.data() + static_cast<long>(panel) * terms_ * components_;
  const Frame f = frame(panel, u, v);
  Motion motion{ f.position, Vector3::Zero(), f.cross() };
  for (int term = 0; term < terms_; ++term, c += components_)
    motion.velocity += monomial.value[term] * Eigen::Map<const Vector3>(c + 6);
  return motion;
}

SurfacePanels::Frame SurfacePanels::nearest(int panel, const Vector3& x) const
{
  Frame f = frame(panel, 1. / 3, 1. / 3);
  for (int sweep = 0; sweep < max_sweeps; ++sweep)
  {
    // The nearest point of the panel's tangent triangle.
    const auto corner = [&](double u, double v) -> Vector3
    { return f.position + (u - f.u) * f.tangent_u + (v - f.v) * f.tangent_v - x; };
    const Vector3 weights = nearest_weights(corner(0, 0), corner(1, 0), corner(0, 1));
    const double step = std::max(std::abs(weights[1] - f.u), std::abs(weights[2] - f.v));
    f = frame(panel, weights[1], weights[2]);
    if (step < smallest_step)
      break;
  }
  return f;
}

}
