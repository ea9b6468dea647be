#include "solver/mesh/shapes/Shapes.h"

#include "solver/Errors.h"
#include "solver/mesh/MeshIntegrals.h"
#include "solver/mesh/MeshQuality.h"
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

/// Reduced volume of the flat triangles above fixed directions; falls as the deflation rises.
double reduced_volume_of(const ShapeFamily& family, double deflation, const SphereMesh& mesh)
{
  return flat_reduced_volume(mapped(mesh, family.surface(deflation)));
}

/// The deflation in [low, high] with the reduced volume v, by false position with a bisection every
/// fourth step; the nearer end if v isn't reached in between.
double solve_between(
  const ShapeFamily& family, const SphereMesh& mesh, double v, double low, double high)
{
  const double rounding = 1e-13; // of the reduced volume, a sum over the triangles
  double above = reduced_volume_of(family, low, mesh) - v;
  double below = reduced_volume_of(family, high, mesh) - v;
  if (above <= 0 || below >= 0)
    return above <= 0 ? low : high;
  double deflation = low;
  for (int step = 0; step < 200; ++step)
  {
    deflation = step % 4 == 3 ? (low + high) / 2 : (low * below - high * above) / (below - above);
    const double excess = reduced_volume_of(family, deflation, mesh) - v;
    if (std::abs(excess) <= rounding)
      break;
    (excess > 0 ? low : high) = deflation;
    (excess > 0 ? above : below) = excess;
  }
  return deflation;
}

/// As solve_between, over the family's whole range, searched outwards from a guess.
double solve_near(const ShapeFamily& family, const SphereMesh& mesh, double v, double guess)
{
  for (double width = 0.02;; width *= 3)
  {
    const double low = std::max(family.roundest, guess - width);
    const double high = std::min(family.flattest, guess + width);
    const bool above = low > family.roundest && reduced_volume_of(family, low, mesh) < v;
    const bool below = high < family.flattest && reduced_volume_of(family, high, mesh) > v;
    if (!above && !below)
      return solve_between(family, mesh, v, low, high);
  }
}

[[noreturn]] void refuse(
  const ShapeRequest& request, const ShapeFamily& family, int triangles, double v)
{
  const SphericalParametrisation roundest = family.surface(family.roundest);
  const double largest =
    flat_reduced_volume(mapped(uniform_mesh(roundest, triangles, family.symmetry), roundest));
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

/// The mesh with reduced volume v. The nodes are spread on the shape first and then, their
/// directions fixed, the shape is deflated until the flat triangles have v; the little that they
/// lose in evenness by that is mended by some more passes.
TriangleMesh fitted_mesh(
  const ShapeRequest& request, const ShapeFamily& family, int triangles, double v)
{
  const int fine = 24; // resolves the shape for a first guess
  double deflation =
    solve_between(family, geodesic_sphere_mesh(fine), v, family.roundest, family.flattest);
  SphereMesh mesh = uniform_mesh(family.surface(deflation), triangles, family.symmetry);
  for (int round = 0; round < 3; ++round)
  {
    deflation = solve_near(family, mesh, v, deflation);
    smooth(mesh, family.surface(deflation), 20);
  }
  deflation = solve_near(family, mesh, v, deflation);
  TriangleMesh result = mapped(mesh, family.surface(deflation));
  if (!(std::abs(flat_reduced_volume(result) - v) <= allowed_error))
    refuse(request, family, triangles, v);
  return result;
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

/// r0 = 1 by the discrete volume, volume centroid at the origin.
void normalise(TriangleMesh& mesh)
{
  mesh.points *= std::cbrt(unit_sphere_volume / flat_volume(mesh));
  const Vector3 centroid = volume_centroid(mesh);
  mesh.points.rowwise() -= centroid.transpose();
}

/// Equilateral triangles of side h, √3 h²/4 each, on the smooth surface with r0 = 1.
int triangles_for_edge(const ShapeRequest& request, const ShapeFamily& family)
{
  const double h = *request.edge_length;
  const int fine = 24;
  const SphereMesh sphere = geodesic_sphere_mesh(fine);
  const double v =
    request.reduced_volume.value_or(reduced_volume_of(family, family.standard, sphere));
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

TriangleMesh free_mesh(const ShapeFamily& family, int triangles)
{
  const SphericalParametrisation surface = family.surface(family.standard);
  return mapped(uniform_mesh(surface, triangles, family.symmetry), surface);
}

/// A family of one shape only: the mesh as it is, if that is what was asked for.
TriangleMesh checked_sphere(const ShapeRequest& request, TriangleMesh mesh)
{
  const double v = request.reduced_volume.value_or(1);
  const double own = flat_reduced_volume(mesh);
  if (std::abs(v - 1) > allowed_error && std::abs(v - own) > allowed_error)
  {
    throw InputError(fmt::format("reduced_volume = {}: a sphere has 1 (its mesh of {} triangles "
                                 "{:.6f}); choose the shape 'prolate' or 'oblate'",
      v, mesh.triangles.rows(), own));
  }
  return mesh;
}
}

TriangleMesh make_shape(const ShapeRequest& request)
{
  const ShapeFamily family = shape_family(request);
  check_reduced_volume(request, family);
  const int triangles = triangles_for(request, family);
  TriangleMesh mesh;
  if (family.flattest == family.roundest)
    mesh = checked_sphere(request, free_mesh(family, triangles));
  else if (request.reduced_volume)
    mesh = fitted_mesh(request, family, triangles, *request.reduced_volume);
  else
    mesh = free_mesh(family, triangles);
  check_quality(request, mesh);
  normalise(mesh);
  return mesh;
}

}
