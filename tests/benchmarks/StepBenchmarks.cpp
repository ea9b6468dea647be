// Whole steps, everything included, by two threads and by one. Each repetition is the next step of a
// run: their median counts.
#include "tests/benchmarks/Measuring.h"
#include "tests/benchmarks/Scenes.h"

#include <fmt/format.h>

#include <string>

namespace vesicle::benchmarks
{
namespace
{

void step(benchmark::State& state, const std::string& name, Scene::Preset preset)
{
  const auto triangles = static_cast<int>(state.range(0)),
             threads = static_cast<int>(state.range(1));
  const Threads limit(threads);
  Scene scene = endless(name, triangles);
  scene.accuracy = Scene::preset(preset);
  Run& run =
    kept_run(fmt::format("{} {} {} {}", name, static_cast<int>(preset), triangles, threads), scene);
  for (auto _ : state)
    run.step();
  state.counters["gmres"] = static_cast<double>(run.state.iterations);
  state.counters["memory"] = peak_memory();
}

void sizes(benchmark::internal::Benchmark* benchmark)
{
  with_all_threads(benchmark);
  benchmark->ArgNames({ "", "threads" })
    ->ArgsProduct({ { 320, 1280, 5120, 20480, 81920 }, { 2, 1 } })
    ->Iterations(1);
}
BENCHMARK_CAPTURE(step, pear, "pear", Scene::Preset::balanced)->Name("Step/pear")->Apply(sizes);
BENCHMARK_CAPTURE(step, tank_treading, "tank-treading", Scene::Preset::balanced)
  ->Name("Step/tank-treading")
  ->Apply(sizes);
BENCHMARK_CAPTURE(step, flat, "pear", Scene::Preset::fast)->Name("Step/pear-fast")->Apply(sizes);

}
}
