// Relaxation in a fluid at rest: the theory of nearly spherical vesicles, and the energy's fall.

#include "apps/validate/Cases.h"
#include "apps/validate/Runs.h"
#include "solver/mesh/LeastSquares.h"
#include "solver/mesh/shapes/Shapes.h"
#include "solver/mesh/shapes/SphericalHarmonics.h"
#include "solver/simulation/StartMesh.h"

#include <fmt/format.h>

#include <cmath>

namespace vesicle::validation
{
namespace
{

constexpr int highest_mode = 8;

/// Amplitudes of Y_l0 in r(direction)/r0 − 1 about the centroid, by least squares over the
/// vertices.
Eigen::VectorXd modes_of(Simulation& simulation, const State& state)
{
  const Points points = state.vesicles[0].points;
  const Diagnostics d = simulation.diagnose(state);
  const Vector3 center =
    Vector3(d.centroid[0], d.centroid[1], d.centroid[2]) / simulation.scales().length;
  Eigen::MatrixXd harmonics(points.rows(), highest_mode + 1);
  Eigen::VectorXd radius(points.rows());
  for (int i = 0; i < points.rows(); ++i)
  {
    const Vector3 x = points.row(i).transpose() - center;
    radius[i] = x.norm() - 1;
    for (int l = 0; l <= highest_mode; ++l)
    {
      harmonics(i, l) = real_spherical_harmonic(l, 0, x.normalized());
    }
  }
  return least_squares(harmonics, radius).value();
}

// du_l/dt = −Γ_l (l − 1)(l + 2)[l(l + 1) + σ] u_l, the tension σ such that the area stays: u2, u4
// and σ for u2 = u4 = 0.01 at the start. Amplitudes scale, σ doesn't depend on them.
struct Moment
{
  double time, u2, u4, sigma;
};
constexpr Moment theory[] = { { 0, 1, 1, -18.790698 }, { 0.1, 1.658714, 0.781546, -15.818586 },
  { 0.2, 2.212888, 0.366098, -9.143005 }, { 0.3, 2.335806, 0.098896, -6.260502 } };

void two_modes(Report& report)
{
  // Large enough for the mesh's own unevenness (at half of it the first tension is 20% off with 320
  // triangles), small enough for linear theory: nonlinear corrections are 1 to 2%.
  const double amplitude = 0.01;
  Scene scene;
  scene.vesicle.shape.kind = ShapeRequest::Kind::perturbed;
  scene.vesicle.shape.modes = { { 2, 0, amplitude }, { 4, 0, amplitude } };
  scene.vesicle.shape.triangles = report.triangles();
  scene.membrane.bending_rigidity = 1;
  scene.time.end = 0.3;
  scene.time.output_every = 0.1;
  scene.time.tolerance = 1e-5;
  Simulation simulation(scene, make_start_mesh(scene));
  State state = simulation.start();
  ChartSpec chart{ "Two modes of a nearly spherical vesicle", "time", "amplitude / start",
    { { "u2", {}, {} }, { "u4", {}, {} } } };
  for (const Moment& exact : theory)
  {
    while (state.time < exact.time)
    {
      const Eigen::VectorXd u = modes_of(simulation, state) / amplitude;
      for (int i = 0; i < 2; ++i)
      {
        chart.lines[i].x.push_back(state.time);
        chart.lines[i].y.push_back(u[2 + 2 * i]);
      }
      state = simulation.step(state);
    }
    const Eigen::VectorXd u = modes_of(simulation, state) / amplitude;
    const Eigen::VectorXd tension = simulation.fields(state).at("Tension");
    const std::string when = fmt::format(" at t = {}", exact.time);
    report.add(absolute("u2" + when, exact.u2, u[2], 0.03));
    report.add(absolute("u4" + when, exact.u4, u[4], 0.03));
    report.add(relative("sigma" + when, exact.sigma, tension.mean(), 0.04));
  }
  ChartLine u2{ "u2, theory", {}, {}, ChartLine::Style::points },
    u4{ "u4, theory", {}, {}, ChartLine::Style::points };
  for (const Moment& exact : theory)
  {
    u2.x.push_back(exact.time);
    u2.y.push_back(exact.u2);
    u4.x.push_back(exact.time);
    u4.y.push_back(exact.u4);
  }
  chart.lines.push_back(u2);
  chart.lines.push_back(u4);
  report.chart("two-modes", { chart });
}

// Long fixed steps from where the first, fast changes are over (before, nodes would move by more
// than the mesh bears, and a fixed step stops).
void energy_falls(Report& report)
{
  const std::string triangles = fmt::format("vesicle.triangles={}", report.triangles());
  const History begun =
    simulate(scene_of("relax-prolate", { triangles, "time.end=0.5", "time.output_every=0.5" }));
  report.add(at_most("rise of E in an adaptive step", 1e-6, largest_energy_rise(begun)));
  const TriangleMesh shape = begun.simulation->mesh(begun.last);
  ChartSpec chart{ "Relaxation with fixed steps", "time", "E / 8 pi EB", {} };
  for (const double step : { 0.02, 0.1, 0.2 })
  {
    const History run = simulate(
      scene_of("relax-prolate",
        { triangles, fmt::format("time.step={}", step), "time.end=2", "time.output_every=1" }),
      shape);
    report.add(
      at_most(fmt::format("rise of E in a step of {}", step), 1e-6, largest_energy_rise(run)));
    chart.lines.push_back(line_of(
      run, fmt::format("dt = {}", step), [](const Diagnostics& d) { return d.energy_over_8pi; }));
  }
  report.chart("energy-falls", { chart });
}

}

std::vector<Case> relaxation_cases()
{
  return { { "relaxation/two-modes",
             "Nearly spherical vesicle, modes 2 and 4 (in units of the start) and tension, against "
             "linear theory",
             Case::Set::fast, two_modes },
    { "stability/energy", "Relaxation never raises the energy, at any step up to 0.2",
      Case::Set::fast, energy_falls } };
}

}
