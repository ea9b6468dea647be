// Convergence with the number of triangles, from smooth and from irregular start meshes.

#include "apps/validate/Cases.h"
#include "apps/validate/Runs.h"

#include "solver/mesh/remesh/Remesh.h"
#include "solver/simulation/StartMesh.h"
#include "solver/stokes/StokesOperator.h"
#include "solver/surface/LoopBasis.h"
#include "solver/surface/StartShape.h"
#include "solver/surface/Surface.h"
#include "solver/surface/SurfaceMeasures.h"
#include "solver/mesh/shapes/Shapes.h"
#include "solver/mesh/shapes/SampleMeshes.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace vesicle::validation
{
namespace
{

// The ellipsoid 2, 1, 1: area, volume and bending energy by quadrature over the meridian.
struct Measures
{
  double area, volume, energy;
};

Measures exact_measures()
{
  const int n = 4000;
  double area = 0, energy = 0;
  for (int i = 0; i < n; ++i)
  {
    const double theta = std::numbers::pi * (i + 0.5) / n;
    const double w = std::hypot(2 * std::sin(theta), std::cos(theta));
    const double strip = 2 * std::numbers::pi * std::sin(theta) * w * std::numbers::pi / n;
    area += strip;
    energy += 0.5 * std::pow(2 / (w * w * w) + 2 / w, 2) * strip;
  }
  return { area, 8 * std::numbers::pi / 3, energy };
}

/// Velocity of a normal density given at the vertices of a Loop surface. With six points a
/// triangle, as preset accurate: three leave a part of first order in h.
Points velocity_of(const TriangleMesh& mesh, const Eigen::VectorXd& density)
{
  const LoopBasis basis(mesh.triangles, static_cast<int>(mesh.points.rows()));
  const Collocation collocation(basis);
  const LayerRules rules(basis, layer_quadrature(basis, 6));
  const StokesOperator layer({ { &rules, mesh.points, collocation.fit(mesh.points) } });
  return rows_of_three(layer.apply(std::array{ normal_density(collocation.fit(density)) }));
}

/// On the unit sphere f = Y n with Y = xy: (W − V)/5, eigenvalues 1/5 and 2/35.
double layer_error(const TriangleMesh& sphere)
{
  const Points& x = sphere.points;
  const Eigen::VectorXd Y = x.col(0).cwiseProduct(x.col(1));
  Points gradient(x.rows(), 3);
  gradient << x.col(1), x.col(0), Eigen::VectorXd::Zero(x.rows());
  const Points V = gradient - 5 * (x.array().colwise() * Y.array()).matrix();
  const Points exact = (gradient / 5 - V * 2 / 35) / 5;
  return (velocity_of(sphere, Y) - exact).norm() / exact.norm();
}

/// A constant normal density moves nothing, whatever the surface.
double pressure_error(const TriangleMesh& mesh)
{
  const Points u = velocity_of(mesh, Eigen::VectorXd::Ones(mesh.points.rows()));
  return std::sqrt(u.squaredNorm() / static_cast<double>(u.rows()));
}

TriangleMesh projected_sphere(TriangleMesh mesh)
{
  mesh.points.rowwise().normalize();
  return mesh;
}

TriangleMesh projected_ellipsoid(TriangleMesh mesh)
{
  for (int i = 0; i < mesh.points.rows(); ++i)
  {
    const Vector3 x = mesh.points.row(i);
    mesh.points.row(i) /= Vector3(x[0] / 2, x[1], x[2]).norm();
  }
  return mesh;
}

/// Start meshes of the ellipsoid and of the sphere, vertices exactly on them.
struct Starts
{
  TriangleMesh ellipsoid, sphere;
};

Starts smooth_starts(int triangles)
{
  ShapeRequest request;
  request.kind = ShapeRequest::Kind::ellipsoid;
  request.semi_axes = { 2, 1, 1 };
  request.triangles = triangles;
  return { projected_ellipsoid(make_shape(request)), smooth_sphere(triangles) };
}

Starts irregular_starts(int triangles)
{
  const TriangleMesh rough = delaunay_sphere(jittered_sphere(32, 0.3)); // 20,480 triangles
  return { projected_ellipsoid(remesh(mapped(rough, ellipsoid_2_1_1), triangles).mesh),
    projected_sphere(remesh(rough, triangles).mesh) };
}

/// What falls with the number of triangles: the order in N over the three meshes, and the error at
/// 1,280 triangles. O(N⁻²) is what a surface of fourth order can have, and 1.6 that within 20%.
struct Quantity
{
  const char* name;
  double order, error;
};

// Loop's surface is of second order in h around extraordinary vertices. A mesh has twelve however
// fine it is, resampled ones of such shapes too: in the end they leave 1/N in the energy and N^−1.4
// in the layer.
constexpr Quantity quantities[] = { { "area", 1.6, 2e-5 }, { "volume", 1.6, 2e-5 },
  { "bending energy", 0.9, 2e-4 }, { "single layer", 1.6, 3e-5 } };

void convergence(Report& report, bool irregular)
{
  const Measures exact = exact_measures();
  ChartSpec chart{ irregular ? "Loop surface, irregular mesh resampled"
                             : "Loop surface, smooth mesh",
    "triangles", "relative error", {}, true, true };
  for (const Quantity& quantity : quantities)
  {
    chart.lines.push_back({ quantity.name, {}, {} });
  }
  chart.lines.push_back({ "velocity of pressure", {}, {} });
  const int finest = report.full() ? 5120 : 1280;
  for (int triangles = finest / 16; triangles <= finest; triangles *= 4)
  {
    const Starts starts = irregular ? irregular_starts(triangles) : smooth_starts(triangles);
    const SurfaceMeasures found = surface_measures(SurfaceBasis::loop, starts.ellipsoid);
    const double errors[] = { std::abs(found.area / exact.area - 1),
      std::abs(found.volume / exact.volume - 1), std::abs(found.bending_energy / exact.energy - 1),
      layer_error(starts.sphere), pressure_error(starts.ellipsoid) };
    for (std::size_t i = 0; i < std::size(errors); ++i)
    {
      chart.lines[i].x.push_back(static_cast<double>(starts.ellipsoid.triangles.rows()));
      chart.lines[i].y.push_back(errors[i]);
    }
  }
  for (std::size_t i = 0; i < std::size(quantities); ++i)
  {
    const Quantity& q = quantities[i];
    const auto& y = chart.lines[i].y;
    report.add(at_most(fmt::format("{}: error, 1280", q.name), q.error, y[report.full() ? 1 : 2],
      fmt::format("{:.1e}, {:.1e}, {:.1e} at {}, {}, {} triangles", y[0], y[1], y[2], finest / 16,
        finest / 4, finest)));
    const auto& N = chart.lines[i].x;
    report.add(at_least(fmt::format("{}: order in N", q.name), q.order,
      std::log(y[0] / y[2]) / std::log(N[2] / N[0])));
  }
  report.add(at_most("velocity of pressure", 1e-4, chart.lines.back().y.back(),
    "rms of a unit normal density's velocity; exactly 0"));
  report.chart(irregular ? "convergence-irregular" : "convergence-smooth", { chart });
}

/// The prolate ellipsoid of the scene's reduced volume from an irregular mesh of 20,480 triangles,
/// resampled as a user's mesh file is.
TriangleMesh irregular_start(const Scene& scene)
{
  ShapeRequest request = scene.vesicle.shape;
  request.triangles = 20480;
  const TriangleMesh fine = make_shape(request); // gives the semi-axes
  const Eigen::RowVector3d axes = fine.points.colwise().maxCoeff();
  const TriangleMesh rough = mapped(delaunay_sphere(jittered_sphere(32, 0.3)),
    [&](const Vector3& d) -> Vector3 { return d.cwiseProduct(axes.transpose()); });
  Scene from_file = scene;
  from_file.vesicle.mesh_triangles = scene.vesicle.shape.triangles;
  from_file.vesicle.mesh_radius = scene.vesicle.radius;
  const Eigen::AngleAxisd turn(turn_z_to(scene.vesicle.axis));
  from_file.vesicle.rotation = std::array{ turn.axis()[0], turn.axis()[1], turn.axis()[2],
    turn.angle() * 180 / std::numbers::pi };
  std::string notes;
  return place_start_mesh(from_file, rough, notes);
}

void same_from_any_mesh(Report& report)
{
  const std::string triangles = fmt::format("vesicle.triangles={}", report.triangles());
  const Scene pear = scene_of("pear", { triangles });
  const History smooth = simulate(pear), rough = simulate(pear, irregular_start(pear));
  report.add(relative("pear: speed U", smooth.end().velocity[2], rough.end().velocity[2], 3e-3));
  report.add(
    relative("pear: E/8pi", smooth.end().energy_over_8pi, rough.end().energy_over_8pi, 3e-3));
  const Scene shear = scene_of("tank-treading", { triangles });
  const History still = simulate(shear), wild = simulate(shear, irregular_start(shear));
  report.add(absolute("tank-treading: inclination (deg)", *still.end().inclination_deg,
    *wild.end().inclination_deg, 0.1));
  report.add(relative("tank-treading: frequency", still.end().tank_treading_frequency,
    wild.end().tank_treading_frequency, 5e-3));
}

}

std::vector<Case> mesh_cases()
{
  return { { "convergence/smooth",
             "Loop surface and single layer on the ellipsoid 2:1:1 and the sphere, smooth meshes",
             Case::Set::fast, [](Report& report) { convergence(report, false); } },
    { "convergence/irregular", "The same from jittered meshes of 20,480 triangles, resampled",
      Case::Set::fast, [](Report& report) { convergence(report, true); } },
    { "start-mesh/irregular",
      "Whole runs from a jittered mesh, resampled, beside those from the smooth mesh",
      Case::Set::full, same_from_any_mesh } };
}

}
