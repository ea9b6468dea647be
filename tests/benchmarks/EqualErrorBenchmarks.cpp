// The paper's scheme beside the default preset: runs to a quantity that docs/validation.md has a
// reference for, what the processors take for them, and how far off they end. Start meshes, which are
// no part of either, aren't timed.
#include "tests/benchmarks/Measuring.h"
#include "tests/benchmarks/Scenes.h"

#include "solver/Errors.h"
#include "solver/simulation/History.h"
#include "solver/simulation/StartMesh.h"

#include <cmath>
#include <string>
#include <vector>

namespace vesicle::benchmarks
{
namespace
{

using Overrides = std::vector<std::string>;

struct Quantity
{
  const char* name;
  double reference;
  Scene (*scene)(const Overrides& overrides);
  double (*of)(const Diagnostics& end);
};

Scene to_its_end(Scene scene)
{
  scene.time.output_every = *scene.time.end;
  return scene;
}

const Quantity quantities[] = {
  { "energy", 1.38744,
    [](const Overrides& overrides)
    {
      Scene scene = scene_of("pear", overrides);
      scene.gravity.reset();
      scene.vesicle.shape.reduced_volume = 0.8;
      scene.time.end = 4;
      return to_its_end(scene);
    },
    [](const Diagnostics& end) { return end.energy_over_8pi; } },
  { "pear-speed", 2.29870,
    [](const Overrides& overrides) { return to_its_end(scene_of("pear", overrides)); },
    [](const Diagnostics& end) { return end.velocity[2]; } },
  { "shear-angle", 32.424,
    [](const Overrides& overrides) { return to_its_end(scene_of("tank-treading", overrides)); },
    [](const Diagnostics& end) { return end.inclination_deg.value_or(NAN); } },
};

void run(benchmark::State& state, const Quantity& quantity, const std::string& preset)
{
  const Threads two(2);
  const Scene scene = quantity.scene(
    { "vesicle.triangles=" + std::to_string(state.range(0)), "accuracy.preset=" + preset });
  const TriangleMesh start = make_start_mesh(scene);
  for (auto _ : state)
    try
    {
      const Diagnostics end = run_to_end(std::make_shared<Simulation>(scene, start)).end();
      state.counters["steps"] = end.step;
      state.counters["error"] = std::abs(quantity.of(end) / quantity.reference - 1);
    }
    catch (const NumericalError& error)
    {
      state.SkipWithError(error.what());
    }
}

[[maybe_unused]] const bool added = []
{
  for (const Quantity& quantity : quantities)
    for (const std::string preset : { "balanced", "paper" })
      benchmark::RegisterBenchmark(
        (std::string("EqualError/") + quantity.name + "/" + preset).c_str(),
        [&quantity, preset](benchmark::State& state) { run(state, quantity, preset); })
        ->Apply(with_all_threads)
        ->ArgsProduct({ { 80, 320, 640, 1280, 2560 } })
        ->Iterations(1);
  return true;
}();

}
}
