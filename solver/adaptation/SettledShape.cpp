#include "solver/adaptation/SettledShape.h"

#include "solver/Errors.h"
#include "solver/equilibrium/BorderedSystem.h"
#include "solver/surface/SurfaceIntegrals.h"
#include "solver/surface/WeakForms.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace vesicle
{

namespace
{

// At the vertices, each of which has two equilateral triangles' area.
Eigen::VectorXd edge_lengths(const Surface& surface)
{
  return (2 / std::numbers::sqrt3 * surface.vertex_area).cwiseSqrt();
}

struct Measures
{
  double area, volume, energy; ///< the last of the membrane's own terms
};

double own_energy(const MembraneTerms& terms, const Surface& surface)
{
  double sum = 0;
  for (const auto& term : terms)
    if (!term->external())
      sum += term->energy(surface);
  return sum;
}

Variation own_variation(const MembraneTerms& terms, const Surface& surface)
{
  Variation sum{ Eigen::VectorXd::Zero(3 * surface.vertices.rows()), {} };
  for (const auto& term : terms)
    if (!term->external())
    {
      Variation variation = term->variation(surface);
      sum.gradient += variation.gradient;
      std::move(variation.rates.begin(), variation.rates.end(), std::back_inserter(sum.rates));
    }
  return sum;
}

// M/(λ h⁴); h at the vertices.
SymmetricMatrix resistance(const Surface& surface, const Eigen::VectorXd& edge_lengths)
{
  constexpr double lambda = 0.3;
  const BasisTable& table = surface.space->table();
  const Eigen::VectorXd h = interpolate(table, edge_lengths);
  return SymmetricMatrix(gram_matrix(table, surface.points,
           [&](int q, int entry) { return table.value[entry] / (h[q] * h[q]); })) /
    lambda;
}

// Displacements of the control points along the normals at their vertices.
SparseMatrix along_normals(const Surface& surface)
{
  SparseMatrix D(3 * surface.normals.rows(), surface.normals.rows());
  D.reserve(Eigen::VectorXi::Ones(D.rows()));
  for (Eigen::Index i = 0; i < surface.normals.rows(); ++i)
    for (int d = 0; d < 3; ++d)
      D.insert(3 * i + d, i) = surface.normals(i, d);
  return D;
}

// The longer ones of the two meshes, at the new one's vertices.
Eigen::VectorXd longer_edges(
  const Surface& surface, const AdaptedMesh& mesh, const OriginalShape& original)
{
  const Eigen::VectorXd old = edge_lengths(original.surface);
  const Triangles& triangles = original.surface.space->triangles();
  Eigen::VectorXd h = edge_lengths(surface);
  for (Eigen::Index i = 0; i < h.size(); ++i)
    h[i] = std::max(h[i], linear(mesh.places[i], triangles, old));
  return h;
}

// The density whose moments the gradient is: of the nodes' functions.
Points density(const Surface& surface, const Eigen::VectorXd& gradient)
{
  const SparseCholesky factors(
    SymmetricMatrix(mass_matrix(surface.space->table(), surface.points)), surface.space->plans());
  return factors.solve(rows_of_three(gradient));
}

// What the old shape's gradient is on the new mesh.
Eigen::VectorXd carried_gradient(
  const Surface& surface, const AdaptedMesh& mesh, const OriginalShape& original)
{
  const Eigen::VectorXd old = own_variation(original.terms, original.surface).gradient;
  const Points at_vertices =
    at_places(original.surface.space->basis(), mesh.places, density(original.surface, old));
  const Points nodal = surface.collocation().fit(at_vertices);
  const Points moments = mass_matrix(surface.space->table(), surface.points) * nodal;
  return flat(moments);
}

Points smoothed(const SurfaceSpace& space, const MembraneTerms& terms, const AdaptedMesh& mesh,
  const OriginalShape& original)
{
  const Points& points = mesh.mesh.points;
  const Surface surface(space, points);
  const Variation variation = own_variation(terms, surface);
  if (variation.rates.empty())
    return points;
  const SparseMatrix D = along_normals(surface),
                     stiffness = gauss_newton_matrix(space.table(), variation.rates);
  Eigen::MatrixXd constraints(points.rows(), 2);
  constraints << D.transpose() * area_gradient(surface.space->table(), surface.points),
    D.transpose() * volume_gradient(space.table(), surface.points);
  BorderedSystem system;
  system.compute(resistance(surface, longer_edges(surface, mesh, original)) +
      SymmetricMatrix(SparseMatrix(D.transpose()) * stiffness * D),
    constraints, Eigen::Vector2d::Zero());
  const Eigen::VectorXd noise =
    D.transpose() * (variation.gradient - carried_gradient(surface, mesh, original));
  const Eigen::VectorXd step = D * system.solve(-noise, Eigen::Vector2d::Zero()).x;
  return points + rows_of_three(space.collocation().to_vertices(step));
}

// The normal part of a functional of the control points: of the vertices' normal displacements, N.
Eigen::VectorXd along_normals(const Surface& surface, const Eigen::VectorXd& functional)
{
  return rows_of_three(surface.collocation().from_control(functional))
    .cwiseProduct(surface.normals)
    .rowwise()
    .sum();
}

// What area, volume and energy lack of the wanted, relative.
Eigen::Vector3d missing(const Surface& surface, const MembraneTerms& terms, const Measures& wanted)
{
  return { 1 - surface.area / wanted.area, 1 - surface.volume / wanted.volume,
    1 - own_energy(terms, surface) / wanted.energy };
}

Points moved_along_normals(const Surface& surface, const Eigen::VectorXd& way)
{
  return surface.vertices + (surface.normals.array().colwise() * way.array()).matrix();
}

// Area and volume, and the energy unless it has to stay as it is.
class Restoration
{
public:
  Restoration(
    const SurfaceSpace& space, const MembraneTerms& terms, const Measures& wanted, bool with_energy)
    : space_(space), terms_(terms), wanted_(wanted), with_energy_(with_energy)
  {
  }

  /// Newton's method. False where it doesn't get there.
  bool restore(const Points& from)
  {
    constexpr int most_steps = 8;
    constexpr double close_enough = 1e-13;
    points_ = from;
    way_ = Eigen::VectorXd::Zero(from.rows());
    for (int step = 0; step < most_steps; ++step)
    {
      const Surface surface(space_, points_);
      Eigen::Vector3d lack = missing(surface, terms_, wanted_);
      if (!with_energy_)
        lack[2] = 0;
      if (!lack.allFinite())
        return false;
      if (lack.cwiseAbs().maxCoeff() < close_enough)
        return true;
      const Eigen::VectorXd way = correction(surface, lack);
      points_ = moved_along_normals(surface, way);
      way_ += way.cwiseQuotient(edge_lengths(surface));
    }
    return false;
  }

  const Points& points() const { return points_; }
  /// In edge lengths.
  double largest_way() const { return way_.cwiseAbs().maxCoeff(); }

private:
  Eigen::VectorXd correction(const Surface& surface, const Eigen::Vector3d& lack) const
  {
    const int count = with_energy_ ? 3 : 2;
    Eigen::MatrixXd G(surface.vertices.rows(), count);
    G.col(0) =
      along_normals(surface, area_gradient(surface.space->table(), surface.points)) / wanted_.area;
    G.col(1) =
      along_normals(surface, volume_gradient(space_.table(), surface.points)) / wanted_.volume;
    if (with_energy_)
      G.col(2) = along_normals(surface, own_variation(terms_, surface).gradient) / wanted_.energy;
    const Eigen::MatrixXd directions = spread_out(surface, G, with_energy_ && lack[2] > 0);
    const Eigen::MatrixXd J = G.transpose() * directions;
    return directions * J.fullPivLu().solve(lack.head(count));
  }

  // S G.
  Eigen::MatrixXd spread_out(const Surface& surface, const Eigen::MatrixXd& G, bool widely) const
  {
    SymmetricMatrix S = mass_matrix(space_.table(), surface.points);
    if (widely)
    {
      const double length = 2 * edge_lengths(surface).mean();
      S += std::pow(length, 4) *
        SymmetricMatrix(bilaplacian(space_.table(), surface.points, *surface.curvature));
    }
    const SparseCholesky factors(S, space_.plans());
    return factors.solve(G);
  }

  const SurfaceSpace& space_;
  const MembraneTerms& terms_;
  const Measures& wanted_;
  bool with_energy_;
  Points points_;
  Eigen::VectorXd way_;
};

}

SettledShape settle_shape(const SurfaceSpace& space, const MembraneTerms& terms,
  const AdaptedMesh& mesh, const OriginalShape& original)
{
  constexpr double longest_way = 1e-2; // in edge lengths
  const Measures wanted{ original.area, original.volume,
    own_energy(original.terms, original.surface) };
  const Points smooth = smoothed(space, terms, mesh, original);
  if (wanted.energy != 0)
  {
    Restoration all(space, terms, wanted, true);
    if (all.restore(smooth) && all.largest_way() <= longest_way)
      return { all.points(), 0, all.largest_way() };
  }
  Restoration two(space, terms, wanted, false);
  if (!two.restore(smooth))
    throw NumericalError("area and volume can't be restored");
  return { two.points(), own_energy(terms, Surface(space, two.points())) - wanted.energy,
    two.largest_way() };
}

}
