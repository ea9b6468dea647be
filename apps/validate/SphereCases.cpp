// Fig. 4 of the paper: a buoyant sphere with an inextensible membrane.

#include "apps/validate/Cases.h"
#include "apps/validate/Runs.h"
#include "solver/simulation/StartMesh.h"

#include <fmt/format.h>

#include <cmath>

namespace vesicle::validation
{
namespace
{

constexpr double bond = 3;

struct Errors
{
  double speed, tension;
};

struct Preset
{
  const char* name;
  Scene::Preset preset;
  double speed, tension; ///< limits at 1,280 triangles
  double order;          ///< in N, of the speed
};
constexpr Preset presets[] = { { "paper", Scene::Preset::paper, 2e-2, 2e-2, 0.9 },
  { "fast", Scene::Preset::fast, 2e-2, 2e-2, 0.9 },
  // What the layer's regular rule leaves beyond the near rule's few edges falls as an edge does:
  // 3e-4, 4e-5, 1e-5, 4e-6 at 80 to 5,120 triangles, twenty times less with six points a triangle.
  { "balanced", Scene::Preset::balanced, 5e-5, 1e-3, 0.5 } };

Scene sphere_scene(Scene::Preset preset, int triangles)
{
  Scene scene;
  scene.vesicle.shape.kind = ShapeRequest::Kind::sphere;
  scene.vesicle.shape.triangles = triangles;
  scene.gravity = Scene::Gravity{};
  scene.gravity->bond_number = bond;
  scene.time.end = 1;
  scene.accuracy = Scene::preset(preset);
  return scene;
}

/// U = (2/9) Bo, γ = (Bo/3)(z − z_c) + const.
Errors errors_of(const Scene& scene)
{
  Simulation simulation(scene, make_start_mesh(scene));
  const State state = simulation.start();
  const Eigen::VectorXd tension = simulation.fields(state).at("Tension");
  const Eigen::VectorXd z = simulation.points(state).col(2);
  const Eigen::VectorXd exact = bond / 3 * (z.array() - z.mean());
  const Eigen::VectorXd error = tension.array() - tension.mean() - exact.array();
  const double speed = simulation.diagnose(state).velocity[2];
  return { std::abs(speed / (2. / 9 * bond) - 1), error.norm() / exact.norm() };
}

void buoyant_sphere(Report& report, const Preset& preset)
{
  ChartSpec chart{ fmt::format("Buoyant inextensible sphere, {}", preset.name), "triangles",
    "relative error", { { "velocity", {}, {} }, { "tension", {}, {} } }, true, true };
  Errors coarse{}, fine{};
  const int finest = report.full() && preset.preset != Scene::Preset::paper ? 5120 : 1280;
  for (int triangles = finest / 16; triangles <= finest; triangles *= 4)
  {
    coarse = fine;
    fine = errors_of(sphere_scene(preset.preset, triangles));
    for (ChartLine& line : chart.lines)
    {
      line.x.push_back(triangles);
    }
    chart.lines[0].y.push_back(fine.speed);
    chart.lines[1].y.push_back(fine.tension);
    if (triangles == 1280)
    {
      report.add(at_most("velocity error, 1280", preset.speed, fine.speed));
      report.add(at_most("tension error, 1280", preset.tension, fine.tension));
    }
  }
  // The paper's "linear convergence": as 1/N or faster.
  report.add(at_least(
    "order in N of the velocity", preset.order, std::log(coarse.speed / fine.speed) / std::log(4)));
  report.add(at_least(
    "order in N of the tension", 0.9, std::log(coarse.tension / fine.tension) / std::log(4)));
  report.chart(fmt::format("fig4-{}", preset.name), { chart });
}

}

std::vector<Case> sphere_cases()
{
  std::vector<Case> cases;
  for (const Preset& preset : presets)
  {
    cases.push_back({ fmt::format("fig4/{}", preset.name),
      fmt::format(
        "Buoyant inextensible sphere, U = 2/9 Bo, tension (Bo/3)(z - z_c), preset {}", preset.name),
      Case::Set::fast, [&preset](Report& report) { buoyant_sphere(report, preset); } });
  }
  return cases;
}

}
