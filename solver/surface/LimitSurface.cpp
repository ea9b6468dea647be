#include "solver/surface/LimitSurface.h"

#include "solver/mesh/Connectivity.h"
#include "solver/mesh/EdgeUses.h"
#include "solver/surface/Collocation.h"
#include "solver/surface/LoopBasis.h"
#include "solver/surface/SurfaceIntegrals.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace vesicle
{

namespace
{

constexpr int terms = 15; // of a quartic in two variables

// u^i v^j with i + j <= 4, and the two derivatives.
struct Monomials
{
  Eigen::Matrix<double, 1, terms> value, du, dv;

  Monomials(double u, double v)
  {
    double up[5] = { 1, u, u * u, u * u * u, u * u * u * u },
           vp[5] = { 1, v, v * v, v * v * v, v * v * v * v };
    int k = 0;
    for (int i = 0; i <= 4; ++i)
      for (int j = 0; i + j <= 4; ++j, ++k)
      {
        value[k] = up[i] * vp[j];
        du[k] = i > 0 ? i * up[i - 1] * vp[j] : 0;
        dv[k] = j > 0 ? j * up[i] * vp[j - 1] : 0;
      }
  }
};

// Fifteen points inside of a triangle that fix a quartic: barycentric coordinates.
std::array<Vector3, terms> lattice()
{
  std::array<Vector3, terms> points;
  int n = 0;
  for (int i = 0; i <= 4; ++i)
    for (int j = 0; i + j <= 4; ++j)
      points[n++] = Vector3(4 - i - j + 1. / 3, i + 1. / 3, j + 1. / 3) / 5;
  return points;
}

// Coefficients of the monomials from values on the lattice.
Eigen::Matrix<double, terms, terms> interpolation()
{
  Eigen::Matrix<double, terms, terms> vandermonde;
  const auto points = lattice();
  for (int n = 0; n < terms; ++n)
    vandermonde.row(n) = Monomials(points[n][1], points[n][2]).value;
  return vandermonde.inverse();
}

// Of a part's four parts: its corners, in the part's coordinates. The middle one is turned by half a turn.
std::array<Vector3, 3> corners_of_part(const std::array<Vector3, 3>& of, int part)
{
  std::array<Vector3, 3> middle{ (of[1] + of[2]) / 2, (of[2] + of[0]) / 2, (of[0] + of[1]) / 2 };
  if (part == 3)
    return middle;
  std::array<Vector3, 3> corners = middle;
  corners[part] = of[part];
  std::swap(corners[(part + 1) % 3], corners[(part + 2) % 3]);
  return corners;
}

}

// The lattices' points of all parts.
struct LimitSurface::Samples
{
  int element = 0;
  std::vector<ParametricPoint> points;
};

int LimitSurface::add_part(
  Samples& samples, const std::array<Vector3, 3>& corners, std::array<bool, 3> rough, int level)
{
  const auto number = static_cast<int>(parts_.size());
  parts_.emplace_back();
  if (level == depth || std::ranges::none_of(rough, [](bool r) { return r; }))
  {
    parts_[number].quartic = static_cast<int>(samples.points.size()) / terms;
    for (const Vector3& w : lattice())
    {
      const Vector3 at = w[0] * corners[0] + w[1] * corners[1] + w[2] * corners[2];
      samples.points.push_back({ samples.element, at[1], at[2], 0 });
    }
    return number;
  }
  for (int part = 0; part < 4; ++part)
  {
    std::array<bool, 3> still{};
    if (part < 3)
      still[part] = rough[part];
    const int made = add_part(samples, corners_of_part(corners, part), still, level + 1);
    parts_[number].parts[part] = made;
  }
  return number;
}

LimitSurface::LimitSurface(const TriangleMesh& mesh)
  : mesh_(mesh), across_(triangles_across(mesh.triangles))
{
  const auto nodes = static_cast<int>(mesh.points.rows());
  const LoopBasis basis(mesh.triangles, nodes);
  const Connectivity connectivity(mesh.triangles, nodes);
  Samples samples;
  for (int e = 0; e < mesh.triangles.rows(); ++e)
  {
    std::array<bool, 3> rough;
    for (int k = 0; k < 3; ++k)
      rough[k] = connectivity.vertex_neighbours.size(mesh.triangles(e, k)) != 6;
    samples.element = e;
    roots_.push_back(
      add_part(samples, { Vector3::UnitX(), Vector3::UnitY(), Vector3::UnitZ() }, rough, 0));
  }
  const BasisTable table = basis.tabulate(samples.points);
  const SurfacePoints surface = evaluate(table, Collocation(basis).fit(mesh.points));
  const auto to_coefficients = interpolation();
  quartics_.resize(samples.points.size() / terms);
  for (std::size_t q = 0; q < quartics_.size(); ++q)
    quartics_[q] =
      to_coefficients * surface.position.middleRows<terms>(terms * static_cast<Eigen::Index>(q));
}

LimitSurface::Point LimitSurface::at(const SurfacePlace& place) const
{
  int part = roots_[place.element];
  Vector3 w = place.weights;
  double scale = 1; // of derivatives: each level halves the coordinates
  while (parts_[part].quartic < 0)
  {
    int next = 3;
    for (int k = 0; k < 3; ++k)
      if (w[k] >= 0.5)
        next = k;
    if (next < 3)
    {
      w *= 2;
      w[next] -= 1;
      scale *= 2;
    }
    else
    {
      w = Vector3::Ones() - 2 * w;
      scale *= -2;
    }
    part = parts_[part].parts[next];
  }
  const Quartic& q = quartics_[parts_[part].quartic];
  const Monomials m(w[1], w[2]);
  return { (m.value * q).transpose(), scale * (m.du * q).transpose(),
    scale * (m.dv * q).transpose() };
}

// Around a regular vertex the elements' coordinates are those of a plane lattice: over the edge
// opposite to c the point λ becomes λ_a + λ_c, λ_b + λ_c, −λ_c.
SurfacePlace LimitSurface::carried(SurfacePlace place) const
{
  constexpr int most_edges = 50;
  for (int crossed = 0; crossed < most_edges; ++crossed)
  {
    int c = 0;
    const double least = place.weights.minCoeff(&c);
    if (least >= 0)
      return place;
    const int from = place.element, to = across_[from][c];
    Vector3 weights = Vector3::Constant(-least);
    for (int k = 0; k < 3; ++k)
      for (int j = 0; j < 3; ++j)
        if (j != c && mesh_.triangles(to, k) == mesh_.triangles(from, j))
          weights[k] = place.weights[j] + least;
    place = { to, weights };
  }
  place.weights = place.weights.cwiseMax(0);
  place.weights /= place.weights.sum();
  return place;
}

SurfacePlace LimitSurface::moved(const SurfacePlace& from, const Vector3& displacement) const
{
  const Point point = at(from);
  Eigen::Matrix<double, 3, 2> tangents;
  tangents << point.tangent_u, point.tangent_v;
  const Eigen::Matrix2d metric = tangents.transpose() * tangents;
  if (!(metric.determinant() > 0)) // at an extraordinary vertex
    return from;
  const Eigen::Vector2d step = metric.inverse() * (tangents.transpose() * displacement);
  return carried({ from.element, from.weights + Vector3(-step[0] - step[1], step[0], step[1]) });
}

SurfacePlace LimitSurface::nearest(const Vector3& x, SurfacePlace from) const
{
  constexpr int most_steps = 30;
  constexpr double close_enough = 1e-12;
  for (int step = 0; step < most_steps; ++step)
  {
    const Point point = at(from);
    const Vector3 way = x - point.position, n = point.normal(), along = way - way.dot(n) * n;
    if (along.norm() < close_enough)
      break;
    from = moved(from, along);
  }
  return from;
}

double linear(
  const SurfacePlace& place, const Triangles& triangles, const Eigen::VectorXd& at_vertices)
{
  double sum = 0;
  for (int k = 0; k < 3; ++k)
    sum += place.weights[k] * at_vertices[triangles(place.element, k)];
  return sum;
}

Points at_places(const Basis& basis, const std::vector<SurfacePlace>& places, const Points& nodal)
{
  constexpr double beside = 1e-6;
  std::vector<ParametricPoint> points;
  for (const SurfacePlace& place : places)
  {
    const Vector3 w = (1 - 3 * beside) * place.weights + Vector3::Constant(beside);
    points.push_back({ place.element, w[1], w[2], 0 });
  }
  return interpolate(basis.tabulate(points), nodal);
}

}
