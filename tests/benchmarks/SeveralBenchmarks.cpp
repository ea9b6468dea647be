// Steps of side³ vesicles of 320 triangles in shear flow, with bending, on a lattice with turned axes.
#include "tests/benchmarks/Measuring.h"
#include "tests/benchmarks/Scenes.h"

#include <fmt/format.h>

#include <cmath>

namespace vesicle::benchmarks
{
namespace
{

// In r0: with these axes no two overlap.
constexpr double spacing = 2.9;

Scene lattice(int side)
{
  Scene scene = endless("tank-treading", 320);
  scene.membrane.bending_rigidity = 1;
  scene.vesicle.shape.reduced_volume = 0.9;
  const Scene::Companion one = scene.companion();
  for (int i = 0; i < side * side * side; ++i)
  {
    if (i > 0)
      scene.companions.push_back(one);
    Scene::Vesicle& vesicle = i > 0 ? scene.companions.back().vesicle : scene.vesicle;
    const Vector3 cell(i % side, i / side % side, i / side / side);
    vesicle.center = spacing * (cell.array() - (side - 1) / 2.).matrix();
    vesicle.axis = Vector3(std::sin(1. + i), std::cos(2.3 * i), std::sin(3.7 * i + 1)).normalized();
  }
  return scene;
}

// Repetitions are the next steps of a run, as in StepBenchmarks.cpp.
void step(benchmark::State& state)
{
  const auto side = static_cast<int>(state.range(0)), threads = static_cast<int>(state.range(1));
  const Threads limit(threads);
  Run& run = kept_run(fmt::format("several {} {}", side, threads), lattice(side));
  for (auto _ : state)
    run.step();
  state.counters["vesicles"] = side * side * side;
  state.counters["gmres"] = static_cast<double>(run.state.iterations);
  state.counters["memory"] = peak_memory();
}
BENCHMARK(step)
  ->Name("Several/step")
  ->Apply(with_all_threads)
  ->ArgNames({ "side", "threads" })
  ->ArgsProduct({ { 1, 2, 4, 8 }, { 2, 1 } })
  ->Iterations(1);

}
}
