#include "solver/mesh/shapes/Shapes.h"

#include "solver/Errors.h"
#include "solver/mesh/MeshIntegrals.h"
#include "solver/mesh/MeshQuality.h"
#include "solver/mesh/shapes/ExactMeasures.h"
#include "solver/mesh/shapes/ShapeFamily.h"
#include "solver/mesh/shapes/SphereMeshSmoothing.h"
#include "solver/mesh/shapes/UniformMesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vesicle
{

namespace
{
constexpr int fewest_triangles = 20;      // the icosahedron
constexpr int most_triangles = 5'000'000; // more is a slip of the pen
constexpr double allowed_error = 1e-6; // of the reduced volume where it can't be tuned: a sphere's
constexpr double unit_sphere_volume = 4 * std::numbers::pi / 3;

BodyMeasures measures(const ShapeMesher& mesher, const TriangleMesh& mesh)
{
  return mesher.measure(mesh.triangles, static_cast<int>(mesh.points.rows()))(mesh.points);
}

/// The reduced volume of a shape by its deflation, with which it falls.
using ReducedVolume = std::function<double(double deflation)>;

/// The deflation in [low, high] with the reduced volume v, by false position with a bisection every
/// fourth step; the nearer end if v isn't reached in between.
double solve_between(const ReducedVolume& reduced_volume_at, double v, double low, double high)
{
  const double rounding = 1e-13; // of the reduced volume, a sum over the surface
  double above = reduced_volume_at(low) - v;
  double below = reduced_volume_at(high) - v;
  if (above <= 0 || below >= 0)
    return above <= 0 ? low : high;
  double deflation = low;
  for (int step = 0; step < 200; ++step)
  {
    deflation = step % 4 == 3 ? (low + high) / 2 : (low * below - high * above) / (below - above);
    const double excess = reduced_volume_at(deflation) - v;
    if (std::abs(excess) <= rounding)
      break;
    (excess > 0 ? low : high) = deflation;
    (excess > 0 ? above : below) = excess;
  }
  return deflation;
}

/// As solve_between, over the family's whole range, searched outwards from a guess.
double solve_near(
  const ShapeFamily& family, const ReducedVolume& reduced_volume_at, double v, double guess)
{
  for (double width = 0.02;; width *= 3)
  {
    const double low = std::max(family.roundest, guess - width);
    const double high = std::min(family.flattest, guess + width);
    const bool above = low > family.roundest && reduced_volume_at(low) < v;
    const bool below = high < family.flattest && reduced_volume_at(high) > v;
    if (!above && !below)
      return solve_between(reduced_volume_at, v, low, high);
  }
}

double exact_reduced_volume(const ShapeFamily& family, double deflation)
{
  const ExactMeasures m = exact_measures(family.surface(deflation), family.symmetry);
  return reduced_volume(m.area, m.volume);
}

/// The deflation of the smooth surface with a reduced volume.
double exact_deflation(const ShapeFamily& family, double v)
{
  return solve_between([&](double deflation) { return exact_reduced_volume(family, deflation); }, v,
    family.roundest, family.flattest);
}

/// Even meshes of flat triangles.
class FlatShapes final : public ShapeMesher
{
public:
  SphereMesh mesh(
    const SphericalParametrisation& surface, int triangles, Symmetry symmetry) const override
  {
    return uniform_mesh(surface, triangles, symmetry);
  }
  void settle(SphereMesh& mesh, const SphericalParametrisation& surface) const override
  {
    smooth(mesh, surface, 20);
  }
  std::function<BodyMeasures(const Points&)> measure(const Triangles& triangles, int) const override
  {
    return [triangles](const Points& points) -> BodyMeasures
    {
      const TriangleMesh mesh{ points, triangles };
      return { flat_area(mesh), flat_volume(mesh), volume_centroid(mesh) };
    };
  }
  double roundness_tolerance() const override { return allowed_error; }
};

[[noreturn]] void refuse(const ShapeRequest& request, int triangles, double largest)
{
  const double v = *request.reduced_volume;
  const std::string beginning = fmt::format(
    "reduced_volume = {}: the shape '{}' in {} triangles", v, shape_name(request.kind), triangles);
  if (v > largest - allowed_error)
  {
    throw InputError(fmt::format("{} has at most {:.6f} (flat triangles enclose less than the "
                                 "smooth surface): lower reduced_volume or raise triangles",
      beginning, largest));
  }
  throw InputError(beginning + " can't be brought to it: raise triangles or reduced_volume");
}

/// The mesh with the reduced volume that is asked for. The nodes are spread on the shape first and
/// then, their directions fixed, the shape is deflated until its surface has it; what the spacing
/// loses by that is mended.
TriangleMesh fitted_mesh(
  const ShapeRequest& request, const ShapeFamily& family, const ShapeMesher& mesher, int triangles)
{
  const double v = *request.reduced_volume;
  double deflation = exact_deflation(family, v);
  SphereMesh mesh = mesher.mesh(family.surface(deflation), triangles, family.symmetry);
  const auto measure = mesher.measure(mesh.triangles, static_cast<int>(mesh.directions.rows()));
  const ReducedVolume reduced_volume_at = [&](double at)
  {
    const BodyMeasures m = measure(mapped(mesh, family.surface(at)).points);
    return reduced_volume(m.area, m.volume);
  };
  for (int round = 0; round < 3; ++round)
  {
    deflation = solve_near(family, reduced_volume_at, v, deflation);
    mesher.settle(mesh, family.surface(deflation));
  }
  deflation = solve_near(family, reduced_volume_at, v, deflation);
  const double had = reduced_volume_at(deflation);
  const bool as_round_as_can_be = deflation == family.roundest && had < v;
  const double tolerance = as_round_as_can_be ? mesher.roundness_tolerance() : allowed_error;
  if (!(std::abs(had - v) <= tolerance))
    refuse(request, triangles, reduced_volume_at(family.roundest));
  return mapped(mesh, family.surface(deflation));
}

void check_quality(const ShapeRequest& request, const TriangleMesh& mesh)
{
  const double least_angle = 10; // degrees; dynamics are known to fail near 5
  const MeshQuality quality = mesh_quality(mesh);
  if (!(quality.min_angle_deg >= least_angle))
  {
    throw InputError(
      fmt::format("{} triangles are too few for this '{}': the smallest angle is {:.1f}°; raise "
                  "triangles or take a rounder shape",
        mesh.triangles.rows(), shape_name(request.kind), quality.min_angle_deg));
  }
}

/// r0 = 1 and the centroid at the origin, by the surface's own measures.
void normalise(TriangleMesh& mesh, const ShapeMesher& mesher)
{
  const BodyMeasures m = measures(mesher, mesh);
  mesh.points.rowwise() -= m.centroid.transpose();
  mesh.points *= std::cbrt(unit_sphere_volume / m.volume);
}

/// Equilateral triangles of side h, √3 h²/4 each, on the smooth surface with r0 = 1.
int triangles_for_edge(const ShapeRequest& request, const ShapeFamily& family)
{
  const double h = *request.edge_length;
  const double v = request.reduced_volume.value_or(exact_reduced_volume(family, family.standard));
  const double area = 4 * std::numbers::pi * std::pow(v, -2.0 / 3);
  const double triangles = area / (std::numbers::sqrt3 / 4 * h * h);
  if (!(h > 0) || !(triangles >= fewest_triangles) || !(triangles <= most_triangles))
  {
    throw InputError(fmt::format(
      "edge_length = {} (in units of the radius) gives {:.3g} triangles: {} to {} can be had", h,
      triangles, fewest_triangles, most_triangles));
  }
  return static_cast<int>(std::lround(triangles));
}

int triangles_for(const ShapeRequest& request, const ShapeFamily& family)
{
  const int triangles =
    request.edge_length ? triangles_for_edge(request, family) : request.triangles;
  if (triangles < fewest_triangles || triangles > most_triangles)
  {
    throw InputError(fmt::format("triangles = {}: a start shape has {} to {} triangles", triangles,
      fewest_triangles, most_triangles));
  }
  return triangles;
}

void check_reduced_volume(const ShapeRequest& request, const ShapeFamily& family)
{
  const std::string name = shape_name(request.kind);
  if (!request.reduced_volume)
  {
    if (family.needs_reduced_volume)
      throw InputError(fmt::format("the shape '{}' needs a reduced_volume between 0 and 1", name));
    return;
  }
  const double v = *request.reduced_volume;
  if (!(v > 0 && v <= 1))
  {
    throw InputError(
      fmt::format("reduced_volume = {}: it is above 0 and at most 1, which only a sphere has", v));
  }
  if (request.kind == ShapeRequest::Kind::perturbed)
  {
    throw InputError("the shape 'perturbed' takes its reduced volume from its modes: leave out "
                     "reduced_volume, or change the amplitudes");
  }
}

TriangleMesh free_mesh(const ShapeFamily& family, const ShapeMesher& mesher, int triangles)
{
  const SphericalParametrisation surface = family.surface(family.standard);
  return mapped(mesher.mesh(surface, triangles, family.symmetry), surface);
}

/// A family of one shape only: the mesh as it is, if that is what was asked for.
TriangleMesh checked_sphere(
  const ShapeRequest& request, const ShapeMesher& mesher, TriangleMesh mesh)
{
  const double v = request.reduced_volume.value_or(1);
  const BodyMeasures m = measures(mesher, mesh);
  const double own = reduced_volume(m.area, m.volume);
  if (std::abs(v - 1) > allowed_error && std::abs(v - own) > allowed_error)
  {
    throw InputError(fmt::format("reduced_volume = {}: a sphere has 1 (its mesh of {} triangles "
                                 "{:.6f}); choose the shape 'prolate' or 'oblate'",
      v, mesh.triangles.rows(), own));
  }
  return mesh;
}
}

TriangleMesh make_shape(const ShapeRequest& request, const ShapeMesher& mesher)
{
  const ShapeFamily family = shape_family(request);
  check_reduced_volume(request, family);
  const int triangles = triangles_for(request, family);
  TriangleMesh mesh;
  if (family.flattest == family.roundest)
    mesh = checked_sphere(request, mesher, free_mesh(family, mesher, triangles));
  else if (request.reduced_volume)
    mesh = fitted_mesh(request, family, mesher, triangles);
  else
    mesh = free_mesh(family, mesher, triangles);
  check_quality(request, mesh);
  normalise(mesh, mesher);
  return mesh;
}

TriangleMesh make_shape(const ShapeRequest& request)
{
  return make_shape(request, FlatShapes());
}

ExactShape exact_shape(const ShapeRequest& request)
{
  const ShapeFamily family = shape_family(request);
  const bool one_shape = family.flattest == family.roundest || !request.reduced_volume;
  return { family.surface(
             one_shape ? family.standard : exact_deflation(family, *request.reduced_volume)),
    family.symmetry };
}

}
