// What a scene doesn't name costs nothing: steps of one length without a term, beside steps with it.
#include "tests/benchmarks/Measuring.h"
#include "tests/benchmarks/Scenes.h"

#include "solver/flow/Shear.h"

#include <memory>
#include <string>

namespace vesicle::benchmarks
{
namespace
{

void shear(Scene& scene)
{
  scene.flow = std::make_shared<Shear>(1);
}

struct Case
{
  const char* name;
  void (*change)(Scene&); ///< of a prolate vesicle in a fluid at rest, with bending and tension
};
const Case cases[] = {
  { "at-rest", [](Scene&) {} },
  { "gravity",
    [](Scene& scene)
    {
      scene.gravity = Scene::Gravity{};
      scene.gravity->bond_number = 10;
    } },
  { "flow", shear },
  { "spontaneous-curvature", [](Scene& scene) { scene.membrane.spontaneous_curvature = 0.5; } },
  { "area-difference", [](Scene& scene) { scene.membrane.area_difference_stiffness = 1; } },
  { "flow-without-bending",
    [](Scene& scene)
    {
      shear(scene);
      scene.membrane.bending_rigidity.reset();
    } },
  { "flow-without-tension",
    [](Scene& scene)
    {
      shear(scene);
      scene.membrane.incompressible = false;
    } },
};

Scene scene_of(const Case& changed)
{
  Scene scene = endless("pear", 1280);
  scene.gravity.reset();
  scene.time.step = 1e-3;
  changed.change(scene);
  return scene;
}

void steps(benchmark::State& state, const Case& changed)
{
  const Threads two(2);
  Run run(scene_of(changed), 1);
  std::int64_t iterations = 0;
  for (auto _ : state)
  {
    run.step();
    iterations += run.state.iterations;
  }
  state.counters["gmres"] =
    benchmark::Counter(static_cast<double>(iterations), benchmark::Counter::kAvgIterations);
}

[[maybe_unused]] const bool added = []
{
  for (const Case& changed : cases)
    benchmark::RegisterBenchmark((std::string("Term/") + changed.name).c_str(),
      [&changed](benchmark::State& state) { steps(state, changed); })
      ->Apply(with_all_threads)
      ->Iterations(8);
  return true;
}();

}
}
