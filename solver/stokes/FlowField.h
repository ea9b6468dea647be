#pragma once
// The Stokes flow that a surface's forces make anywhere in the fluid: inside and outside, right up
// to the surface and on it.

#include "solver/mesh/Connectivity.h"
#include "solver/stokes/SurfacePanels.h"

#include <vector>

namespace vesicle
{

/// u(x) = (1/8πμ) ∮ G(x, y) f(y) dS(y), G = I/r + X Xᵀ/r³, paper (11), at points x that have
/// nothing to do with the mesh. It is continuous across the surface.
///
/// Panels farther from x than about their own size are integrated by a fixed rule. On nearer ones
/// the rule is made for x: polar coordinates (ρ, θ) about the panel's nearest point x*, with
/// ρ = d sinh t, d = |x − x*|, which takes the peak of width d out of the integrand, and about as
/// many points as the logarithm of 1/d (B. Johnston, P. Johnston, D. Elliott, Int. J. Numer. Meth.
/// Engng 69 (2007) 1389), and along each side the angle by the arsinh of its tangent (M. Khayat,
/// D. Wilton, IEEE Trans. Antennas Propag. 53 (2005) 3180), so that x* may lie near a side. The
/// quadrature is good for 1e-7 of the velocity at any distance, 0 included; what remains is
/// the error of the surface and of the density.
class FlowField
{
public:
  explicit FlowField(SurfacePanels panels);
  const SurfacePanels& panels() const { return panels_; }

  struct Flow
  {
    Points velocity;                   ///< for μ = 1: divide by μ
    std::vector<unsigned char> inside; ///< 1: enclosed by the surface; on it, either
  };
  /// Threads share the points; results do not depend on their number.
  Flow at(const Points& points) const;

private:
  /// Velocity by the panel's own rule for x.
  Vector3 near_velocity(int panel, const SurfacePanels::Frame& nearest, const Vector3& x) const;
  void at_group(
    const Points& points, const AdjacencyList& near, int first, int count, Flow& flow) const;

  SurfacePanels panels_;
  // The fixed rule's rows, the same number for each panel.
  int rows_per_panel_;
  RowVectors position_, force_, normal_;
  Eigen::VectorXd weight_;
};

}
