// Steps of side³ vesicles of 320 triangles in shear flow, with bending, on a lattice with turned axes.
#include "tests/benchmarks/Measuring.h"
#include "tests/benchmarks/Scenes.h"

#include <cmath>
#include <map>
#include <utility>

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
    const Eigen::Vector3d cell(i % side, i / side % side, i / side / side);
    const Eigen::Vector3d at = spacing * (cell.array() - (side - 1) / 2.).matrix();
    const Eigen::Vector3d axis(std::sin(1. + i), std::cos(2.3 * i), std::sin(3.7 * i + 1));
    Scene::Vesicle vesicle = one.vesicle;
    vesicle.center = { at.x(), at.y(), at.z() };
    const Eigen::Vector3d unit = axis.normalized();
    vesicle.axis = { unit.x(), unit.y(), unit.z() };
    if (i == 0)
      scene.vesicle = vesicle;
    else
    {
      scene.companions.push_back(one);
      scene.companions.back().vesicle = vesicle;
    }
  }
  return scene;
}

// Repetitions are the next steps of a run, as in StepBenchmarks.cpp.
void step(benchmark::State& state)
{
  static std::map<std::pair<int, int>, Run> runs;
  const auto side = static_cast<int>(state.range(0)), threads = static_cast<int>(state.range(1));
  const Threads limit(threads);
  Run& run = runs.try_emplace({ side, threads }, lattice(side)).first->second;
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
