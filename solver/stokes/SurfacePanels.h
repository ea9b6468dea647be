#pragma once
// A surface and the force density on it as polynomials on triangular pieces. Evaluating them costs
// a few dozen multiplications whatever the basis, so that a quadrature can be made for every single
// target.

#include "solver/stokes/ForceDensity.h"
#include "solver/stokes/PanelBasis.h"

namespace vesicle
{

/// Panels are the elements of the basis; those at extraordinary vertices are halved towards them,
/// as Basis::rule does. Position and f |x_u × x_v| are interpolated, on linear elements by the
/// polynomials of degree 1 that they are, on smooth bases by degree 4, in which the position is
/// exact on regular elements.
class SurfacePanels
{
public:
  /// `velocity`: at the nodes, interpolated as the position is; or empty.
  SurfacePanels(const Basis& basis, const Points& control, const ForceDensity& density,
    const Points& velocity = {});
  /// The geometry alone, on the panels of `basis`.
  SurfacePanels(const PanelBasis& basis, const Points& control);

  int size() const { return static_cast<int>(radius_.size()); }
  /// A sphere that holds the panel.
  const Vector3& center(int panel) const { return center_[panel]; }
  double radius(int panel) const { return radius_[panel]; }

  /// A panel's point at (u, v), u, v ≥ 0, u + v ≤ 1.
  struct Sample
  {
    Vector3 position;
    Vector3 force; ///< f |x_u × x_v|: force an area of the parametric domain
  };
  /// Where there is a density.
  Sample sample(int panel, double u, double v) const;
  bool has_velocity() const { return components_ > 6; }
  /// Where there is one: the velocity, and n dS/(du dv).
  struct Motion
  {
    Vector3 position, velocity, area;
  };
  Motion motion(int panel, double u, double v) const;

  /// Position and tangents.
  struct Frame
  {
    double u, v;
    Vector3 position, tangent_u, tangent_v;
    Vector3 cross() const { return tangent_u.cross(tangent_v); } ///< outward
  };
  Frame frame(int panel, double u, double v) const;
  /// Where the panel is nearest to x.
  Frame nearest(int panel, const Vector3& x) const;

  int degree() const { return degree_; }
  /// Of the position's monomials: x, y, z of each, coefficient_stride() numbers apart.
  const double* coefficients(int panel) const
  {
    return coefficients_.data() + static_cast<long>(panel) * terms_ * components_;
  }
  int coefficient_stride() const { return components_; }

private:
  void find_spheres(int panels);

  int degree_, terms_, components_;
  /// Of each panel, term: x, y, z, and, where they are known, force x, y, z, u, v, w.
  std::vector<double> coefficients_;
  std::vector<Vector3> center_;
  std::vector<double> radius_;
};

}
