// Fig. 3 of the paper, and what the curvature's error does to the velocity.

#include "apps/DataFiles.h"
#include "apps/validate/Cases.h"

#include "solver/surface/Cotan.h"
#include "solver/surface/FittedCurvature.h"
#include "solver/membrane/HelfrichBending.h"
#include "solver/mesh/remesh/Remesh.h"
#include "solver/mesh/shapes/GeodesicSphere.h"
#include "solver/mesh/shapes/Shapes.h"
#include "solver/stokes/BendingVelocityError.h"
#include "solver/surface/ExactCurvature.h"
#include "solver/surface/Surface.h"
#include "solver/mesh/shapes/SampleMeshes.h"
#include "solver/state/Table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace vesicle::validation
{
namespace
{

enum class Scheme
{
  cotan,
  fit,
  loop
};
constexpr Scheme schemes[] = { Scheme::cotan, Scheme::fit, Scheme::loop };
constexpr const char* scheme_names[] = { "cotan", "fit", "loop" };

const char* name_of(Scheme scheme)
{
  return scheme_names[static_cast<int>(scheme)];
}

Curvature curvature_of(const TriangleMesh& mesh, Scheme scheme)
{
  switch (scheme)
  {
    case Scheme::cotan:
      return cotan_curvature(
        CotanGeometry(mesh.points, mesh.triangles), mesh.points, NormalScheme::area_weighted);
    case Scheme::fit:
      return fitted_curvature(mesh).curvature;
    default:
      return vertex_curvature(Surface(
        SurfaceSpace(SurfaceBasis::loop, mesh.triangles, static_cast<int>(mesh.points.rows())),
        mesh.points));
  }
}

/// Values at points of the section z = 0, by angle.
struct Section
{
  std::vector<double> degrees, mean, laplacian;
};

/// Root mean square errors, relative to the exact values'.
struct Errors
{
  double mean, laplacian;
};

class Comparison
{
public:
  void add(double mean, double laplacian, double exact_mean, double exact_laplacian)
  {
    error_ += square({ mean - exact_mean, laplacian - exact_laplacian });
    size_ += square({ exact_mean, exact_laplacian });
  }
  Errors errors() const
  {
    return { std::sqrt(error_[0] / size_[0]), std::sqrt(error_[1] / size_[1]) };
  }

private:
  static Eigen::Array2d square(const Eigen::Array2d& a) { return a * a; }
  Eigen::Array2d error_ = Eigen::Array2d::Zero(), size_ = Eigen::Array2d::Zero();
};

/// The paper's section: nodes with z = 0 of its surface as printed, in the order of their angle.
Section section_of(const TriangleMesh& mesh, const Curvature& c)
{
  std::map<double, int> by_angle;
  for (int i = 0; i < mesh.points.rows(); ++i)
  {
    if (std::abs(mesh.points(i, 2)) < 1e-12)
    {
      const double angle = std::atan2(mesh.points(i, 1), mesh.points(i, 0));
      by_angle[angle < 0 ? angle + 2 * std::numbers::pi : angle] = i;
    }
  }
  Section section;
  for (const auto& [angle, i] : by_angle)
  {
    section.degrees.push_back(angle * 180 / std::numbers::pi);
    section.mean.push_back(c.mean[i]);
    section.laplacian.push_back(c.laplacian_mean[i]);
  }
  return section;
}

Section reference_section()
{
  const Table table = parse_table(data_file("reference/surfaces/paper41_literal_z0.csv"));
  Section section{ table.column("theta"), table.column("H"), table.column("LapH") };
  for (double& angle : section.degrees)
  {
    angle *= 180 / std::numbers::pi;
  }
  return section;
}

Errors section_errors(const Section& section, const Section& exact)
{
  Comparison comparison;
  const double step = exact.degrees[1];
  for (std::size_t i = 0; i < section.degrees.size(); ++i)
  {
    comparison.add(section.mean[i], section.laplacian[i],
      periodic_cubic(exact.mean, step, section.degrees[i]),
      periodic_cubic(exact.laplacian, step, section.degrees[i]));
  }
  return comparison.errors();
}

/// Errors over all vertices of a mesh of the smooth variant.
Errors surface_errors(const TriangleMesh& mesh, Scheme scheme)
{
  const Curvature c = curvature_of(mesh, scheme);
  Comparison comparison;
  for (int i = 0; i < mesh.points.rows(); ++i)
  {
    const ExactCurvature exact =
      exact_curvature(paper_surface_level_set(), mesh.points.row(i).transpose());
    comparison.add(c.mean[i], c.laplacian_mean[i], exact.mean, exact.laplacian_mean);
  }
  return comparison.errors();
}

/// Loop's surface wants a smooth mesh, so it gets one wherever the simulations would.
TriangleMesh regular_mesh(Scheme scheme, int n)
{
  return mapped(
    scheme == Scheme::loop ? smooth_sphere(20 * n * n) : geodesic_sphere(n), paper_surface);
}

TriangleMesh irregular_mesh(Scheme scheme, int n)
{
  const TriangleMesh rough = mapped(delaunay_sphere(jittered_sphere(n, 0.3)), paper_surface);
  if (scheme != Scheme::loop)
  {
    return rough;
  }
  TriangleMesh directions = remesh(rough, 20 * n * n).mesh;
  directions.points.rowwise().normalize();
  return mapped(directions, paper_surface); // back on the surface
}

/// What is measured for a scheme, and how far it may be off.
struct Limits
{
  Errors section, regular, irregular;
};

std::vector<ChartSpec> charts_of(Scheme scheme, const Section& exact)
{
  const std::string angle = "angle (degrees)";
  return { { fmt::format("Section z = 0 of the paper's 4.1, {}", name_of(scheme)), angle, "H",
             { { "exact", exact.degrees, exact.mean } } },
    { "", angle, "surface Laplacian of H", { { "exact", exact.degrees, exact.laplacian } } } };
}

void add_errors(Report& report, const std::string& name, const Errors& errors, const Errors& limits)
{
  report.add(at_most(fmt::format("{}: H", name), limits.mean, errors.mean));
  report.add(at_most(fmt::format("{}: Lap H", name), limits.laplacian, errors.laplacian));
}

void figure_3(Report& report, Scheme scheme, const Limits& fast, const Limits& full)
{
  const Limits& limits = report.full() ? full : fast;
  const int finest = report.full() ? 32 : 16; // 20,480 and 5,120 triangles
  const Section exact = reference_section();
  std::vector<ChartSpec> charts = charts_of(scheme, exact);
  for (int n = finest / 4; n <= finest; n *= 2)
  {
    const TriangleMesh mesh = mapped(geodesic_sphere(n), printed_paper_surface);
    const Section section = section_of(mesh, curvature_of(mesh, scheme));
    const std::string label = fmt::format("{} triangles", 20 * n * n);
    charts[0].lines.push_back({ label, section.degrees, section.mean, ChartLine::Style::points });
    charts[1].lines.push_back(
      { label, section.degrees, section.laplacian, ChartLine::Style::points });
    if (n == finest)
    {
      add_errors(report, fmt::format("section, {}", 20 * n * n), section_errors(section, exact),
        limits.section);
    }
  }
  report.chart(fmt::format("fig3-{}", name_of(scheme)), charts);
  const int size = 20 * finest * finest;
  add_errors(report, fmt::format("regular, {}", size),
    surface_errors(regular_mesh(scheme, finest), scheme), limits.regular);
  add_errors(report,
    fmt::format("{}, {}", scheme == Scheme::loop ? "resampled" : "irregular", size),
    surface_errors(irregular_mesh(scheme, finest), scheme), limits.irregular);
}

/// Of the pointwise scheme on the ellipsoid 2:1:1.
double velocity_error(const TriangleMesh& sphere)
{
  const TriangleMesh mesh = mapped(sphere, ellipsoid_2_1_1);
  return bending_velocity_error(
    mesh, ellipsoid_2_1_1_level_set(), fitted_curvature(mesh).curvature);
}

void velocity_errors(Report& report)
{
  report.add(at_most("regular, 1280", 6e-3, velocity_error(geodesic_sphere(8))));
  report.add(
    at_most("jittered, 1280", 3e-2, velocity_error(delaunay_sphere(jittered_sphere(8, 0.3)))));
  if (!report.full())
  {
    return;
  }
  report.add(at_most("regular, 5120", 1e-3, velocity_error(geodesic_sphere(16))));
  report.add(
    at_most("jittered, 5120", 6e-3, velocity_error(delaunay_sphere(jittered_sphere(16, 0.3)))));
}

}

std::vector<Case> curvature_cases()
{
  // Measured, with a quarter to spare. The surface is hard: at its dent the radius of curvature is
  // two edges of the mesh with 5,120 triangles. On irregular meshes cotan's Laplacian of H does not
  // converge. Resampled triangles are as large in the dent as elsewhere: at 5,120 how the vertices
  // happen to lie there decides about Loop's.
  const Limits fast[] = { { { 0.05, 0.34 }, { 0.026, 0.3 }, { 0.16, 1.9 } },
    { { 4e-3, 0.11 }, { 1.8e-3, 0.1 }, { 4e-3, 0.2 } },
    { { 0.012, 0.17 }, { 4e-3, 0.15 }, { 0.017, 1.3 } } };
  const Limits full[] = { { { 0.027, 0.4 }, { 8.5e-3, 0.22 }, { 0.16, 9.5 } },
    { { 2e-4, 7e-3 }, { 1.3e-4, 0.011 }, { 3.3e-4, 0.042 } },
    { { 9.5e-3, 0.5 }, { 1.4e-3, 0.27 }, { 2.1e-3, 0.33 } } };
  std::vector<Case> cases;
  for (const Scheme scheme : schemes)
  {
    const int i = static_cast<int>(scheme);
    cases.push_back({ fmt::format("fig3/{}", name_of(scheme)),
      fmt::format("H and its surface Laplacian on the surface of 4.1, scheme {}: rms errors",
        name_of(scheme)),
      Case::Set::fast, [=](Report& report) { figure_3(report, scheme, fast[i], full[i]); } });
  }
  cases.push_back({ "fig3/velocity",
    "Error of the bending force as it moves the fluid, |G(f_h - f)|/|G f|, ellipsoid 2:1:1, fit",
    Case::Set::fast, velocity_errors });
  return cases;
}

}
