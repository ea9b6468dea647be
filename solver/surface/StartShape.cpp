#include "solver/surface/StartShape.h"

#include "solver/Errors.h"
#include "solver/Joined.h"
#include "solver/mesh/MeshIntegrals.h"
#include "solver/mesh/shapes/ExactMeasures.h"
#include "solver/mesh/shapes/GradedMesh.h"
#include "solver/mesh/shapes/Shapes.h"
#include "solver/mesh/shapes/UniformMesh.h"
#include "solver/surface/LoopEnergy.h"
#include "solver/surface/Surface.h"
#include "solver/surface/SurfaceMeasures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace vesicle
{

namespace
{
// Of the bending energy of a shape, beyond which its mesh doesn't hold it.
constexpr double allowed_energy_error = 0.01;
// Error of a mesh that needs no grading.
constexpr double held = 1e-3;
// More aren't tried to find out how many hold a shape.
constexpr int most_triangles_sought = 2560;
constexpr double allowed_volume_error = 1e-6;
// z of a unit vector that is −z but for rounding.
constexpr double half_turn = -1 + 1e-12;

// Of the bending energy of Loop's surface. Neither of the two alone tells: a mesh that doesn't see a
// rim has the well-known energy of another shape, and errors may cancel.
double energy_error(const TriangleMesh& mesh, double exact)
{
  const LoopEnergy energy = loop_energy(mesh);
  return std::max(std::abs(energy.fine / exact - 1), energy.disagreement());
}

// Of Loop's surface through a mesh of `surface`: of its energy and reduced volume.
MeshError loop_error(const SphericalParametrisation& surface, Symmetry symmetry)
{
  const ExactMeasures exact = exact_measures(surface, symmetry);
  return [&surface, exact](const SphereMesh& directions)
  {
    return loop_error(
      mapped(directions, surface), exact.bending_energy, reduced_volume(exact.area, exact.volume));
  };
}

// Measured by Loop's surface. Surfaces of revolution that an even mesh doesn't hold have a graded one.
// The vesicle takes its mesh's spacing with it when it becomes another shape: an ellipsoid of three
// axes, v = .8, that becomes a prolate from a graded mesh of 320 triangles ends .57% above its energy,
// from an even one .12%.
class LoopShapes final : public ShapeMesher
{
public:
  SphereMesh mesh(
    const SphericalParametrisation& surface, int triangles, Symmetry symmetry) const override
  {
    SphereMesh even = uniform_mesh(surface, triangles, symmetry);
    const bool of_revolution = symmetry != Symmetry::none && symmetry != Symmetry::half_turns;
    if (!of_revolution || loop_error(surface, symmetry)(even) <= held)
      return even;
    return loop_mesh(surface, triangles, symmetry);
  }
  // The mesh was chosen for its error, which more passes could undo on shapes that it hardly holds.
  void settle(SphereMesh&, const SphericalParametrisation&) const override {}
  std::function<BodyMeasures(const Points&)> measure(
    const Triangles& triangles, int points) const override
  {
    const auto space = std::make_shared<SurfaceSpace>(SurfaceBasis::loop, triangles, points);
    return [space](const Points& at) -> BodyMeasures
    {
      const BasisTable& table = space->table();
      const SurfacePoints surface = evaluate(table, space->collocation().fit(at));
      return { area(surface), volume(table, surface), centroid(table, surface) };
    };
  }
  // 20 triangles lack 2.7e-4 of a sphere's, 80 lack 4e-6.
  double roundness_tolerance() const override { return 1e-3; }
};

}

SphereMesh loop_mesh(const SphericalParametrisation& surface, int triangles, Symmetry symmetry)
{
  return graded_mesh(surface, triangles, symmetry, loop_error(surface, symmetry));
}

TriangleMesh make_start_shape(const ShapeRequest& request, SurfaceBasis basis)
{
  return basis == SurfaceBasis::linear ? make_shape(request) : make_shape(request, LoopShapes());
}

static std::string volume_warning(const ShapeRequest& request, const TriangleMesh& mesh)
{
  const SurfaceMeasures m = surface_measures(SurfaceBasis::loop, mesh);
  const double has = reduced_volume(m.area, m.volume),
               wanted = request.reduced_volume.value_or(has);
  if (std::abs(has - wanted) <= allowed_volume_error || request.kind == ShapeRequest::Kind::sphere)
    return {};
  return fmt::format(
    "The reduced volume is {:.7f}, the largest that {} triangles can have, instead "
    "of {:.7f}.",
    has, mesh.triangles.rows(), wanted);
}

static bool holds(const ShapeRequest& request, double exact_energy)
try
{
  const TriangleMesh mesh = make_start_shape(request, SurfaceBasis::loop);
  return energy_error(mesh, exact_energy) <= allowed_energy_error;
}
catch (const InputError&)
{
  return false; // too few for any mesh
}

// Twice as often until the energy is right: the error of a shape that is hardly seen doesn't tell.
static std::string triangles_needed(ShapeRequest request, double exact, int triangles)
{
  for (int more = 2 * triangles; more <= most_triangles_sought; more *= 2)
  {
    request.triangles = more;
    if (holds(request, exact))
      return fmt::format("about {}", more);
  }
  return fmt::format("more than {}", std::max(triangles, most_triangles_sought));
}

static std::string energy_warning(const ShapeRequest& request, const TriangleMesh& mesh)
{
  const ExactShape shape = exact_shape(request);
  const double exact = exact_measures(shape.surface, shape.symmetry).bending_energy;
  const double error = energy_error(mesh, exact);
  if (error <= allowed_energy_error)
    return {};
  const int triangles = static_cast<int>(mesh.triangles.rows());
  return fmt::format("{} triangles are too few for this '{}': their bending energy is {:.2g}% off; "
                     "{} are needed for {:.0f}%.",
    triangles, shape_name(request.kind), 100 * error, triangles_needed(request, exact, triangles),
    100 * allowed_energy_error);
}

std::string start_shape_warning(
  const ShapeRequest& request, SurfaceBasis basis, const TriangleMesh& mesh)
{
  if (basis == SurfaceBasis::linear)
    return {};
  return lines({ volume_warning(request, mesh), energy_warning(request, mesh) });
}

Eigen::Matrix3d turn_z_to(const Vector3& axis)
{
  const Vector3 to = axis.normalized();
  const double s = std::sqrt((1 + to.z()) * 2), inverse = 1 / s;
  // What Quaterniond::FromTwoVectors does, which would compile a singular value decomposition to find
  // an axis of the half turn to −z.
  const Eigen::Quaterniond turn = to.z() < half_turn
    ? Eigen::Quaterniond(0, -1, 0, 0)
    : Eigen::Quaterniond(0.5 * s, -to.y() * inverse, to.x() * inverse, 0);
  return turn.toRotationMatrix();
}

void place(TriangleMesh& shape, double radius, const Eigen::Matrix3d& turn, const Vector3& center)
{
  shape.points = (radius * shape.points * turn.transpose()).eval();
  shape.points.rowwise() += center.transpose();
}

}
