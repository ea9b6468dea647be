// What a step on Loop's surface is made of, at the middle of a pear's second step.
#include "tests/benchmarks/Measuring.h"
#include "tests/benchmarks/Scenes.h"

#include "solver/dynamics/LoadStage.h"
#include "solver/dynamics/LocalPreconditioner.h"
#include "solver/dynamics/MeshMotion.h"
#include "solver/dynamics/Projection.h"
#include "solver/dynamics/Stepper.h"
#include "solver/simulation/SystemOfScene.h"
#include "solver/stokes/LayerSum.h"
#include "solver/stokes/TreeSum.h"

#include <functional>
#include <memory>
#include <numbers>
#include <string>

namespace vesicle::benchmarks
{
namespace
{

std::unique_ptr<const PointSum> tree_sum(const PointPlaces& places)
{
  return std::make_unique<TreeSum>(places, LayerSettings{}.tree_tolerance);
}

/// A stage as the stepper poses it, with all that solves it.
struct Stage
{
  Run run;
  const VesicleState& start;
  double dt, tau;
  System system;
  SystemShape shape;
  LayerSum layer, by_tree;
  std::vector<LocalPreconditioner> preconditioners;
  Eigen::VectorXd reference;
  AdjacencyList neighbours;

  explicit Stage(int triangles)
    : run(endless("pear", triangles), 1), start(run.state.vesicles[0]),
      dt(run.state.controller.next_step), tau((1 - 1 / std::numbers::sqrt2) * dt),
      system(fresh_system()), shape(system, { start.points + dt / 2 * start.node_velocity }),
      layer(StokesOperator(layer_surfaces(shape))),
      by_tree(StokesOperator(layer_surfaces(shape)), tree_sum), preconditioners(1),
      reference(
        relative_to_centroids(SystemShape(system, { start.points }), velocity_of(run.state))),
      neighbours(
        Connectivity(start.triangles, static_cast<int>(start.points.rows())).vertex_neighbours)
  {
    preconditioners[0].build(loads());
    preconditioners[0].build_stiff(loads(), tau);
  }

  System fresh_system() const
  {
    return system_of(run.simulation.scene(), run.simulation.scales(),
      { { start.triangles, static_cast<int>(start.points.rows()) } });
  }
  const VesicleLoads& loads() const { return *shape.vesicles[0].loads; }
  /// How often the layer was applied in each precision.
  struct Solved
  {
    StageSolution solution;
    int full = 0, single = 0;
  };
  Solved solve() const
  {
    Solved solved;
    const auto apply = [&](const std::vector<Eigen::VectorXd>& densities, double allowed)
    {
      ++(allowed < single_precision_error ? solved.full : solved.single);
      return layer.apply(densities, allowed);
    };
    solved.solution =
      LoadStage(shape, { apply, {} }, tau, reference, run.state)
        .solve(preconditioners, run.simulation.scene().accuracy.linear_tolerance, 200);
    return solved;
  }
  double pairs() const
  {
    return static_cast<double>(system.vesicles[0].layer->regular().table.rows()) *
      static_cast<double>(start.points.rows());
  }
};

Stage& stage_of(int triangles)
{
  static int last = 0;
  static std::unique_ptr<Stage> stage;
  if (triangles != last)
  {
    stage.reset();
    stage = std::make_unique<Stage>(triangles);
    last = triangles;
  }
  return *stage;
}

void solve(benchmark::State& state)
{
  const Threads two(2);
  const Stage& stage = stage_of(static_cast<int>(state.range(0)));
  Stage::Solved solved;
  for (auto _ : state)
    solved = stage.solve();
  state.counters["gmres"] = solved.solution.iterations;
  state.counters["applies_double"] = solved.full;
  state.counters["applies_single"] = solved.single;
  state.counters["pairs"] = stage.pairs();
}

void sizes(benchmark::internal::Benchmark* benchmark)
{
  with_all_threads(benchmark);
  benchmark->Arg(320)->Arg(1280)->Arg(5120)->Arg(20480);
}

template<class Work>
void add(const char* name, Work work)
{
  benchmark::RegisterBenchmark((std::string("Part/") + name).c_str(),
    [work](benchmark::State& state)
    {
      const Threads two(2);
      Stage& stage = stage_of(static_cast<int>(state.range(0)));
      for (auto _ : state)
        work(stage);
    })
    ->Apply(sizes);
}

using benchmark::DoNotOptimize;

[[maybe_unused]] const bool added = []
{
  add("space",
    [](Stage& s) {
      SurfaceSpace(SurfaceBasis::loop, s.start.triangles, static_cast<int>(s.start.points.rows()));
    });
  add("rules",
    [](Stage& s)
    {
      const Basis& basis = s.system.vesicles[0].space->basis();
      LayerRules(basis, layer_quadrature(basis, s.run.simulation.scene().accuracy.quadrature));
    });
  add("shape", [](Stage& s) { SystemShape(s.system, s.shape.points); });
  add("layer", [](Stage& s) { LayerSum(StokesOperator(layer_surfaces(s.shape))); });
  const auto apply = [](double allowed)
  {
    return [allowed](Stage& s) { DoNotOptimize(s.layer.apply({ s.loads().gradient() }, allowed)); };
  };
  add("apply/double", apply(0));
  add("apply/single", apply(single_precision_error));
  add("tree", [](Stage& s) { LayerSum(StokesOperator(layer_surfaces(s.shape)), tree_sum); });
  const auto apply_by_tree = [](double allowed)
  {
    return [allowed](Stage& s)
    { DoNotOptimize(s.by_tree.apply({ s.loads().gradient() }, allowed)); };
  };
  add("tree/double", apply_by_tree(0));
  add("tree/single", apply_by_tree(single_precision_error));
  add("preconditioner/tension", [](Stage& s) { s.preconditioners[0].build(s.loads()); });
  add(
    "preconditioner/bending", [](Stage& s) { s.preconditioners[0].build_stiff(s.loads(), s.tau); });
  add("precondition",
    [](Stage& s)
    {
      const LoadUnknowns residual{ s.start.tension, s.start.tension, 1, 1, {} };
      DoNotOptimize(s.preconditioners[0].solve(s.loads(), residual));
    });
  benchmark::RegisterBenchmark("Part/solve", solve)->Apply(sizes);
  add("motion",
    [](Stage& s)
    {
      DoNotOptimize(sliding_velocity(s.loads(), sliding_motion(s.loads(), s.tau), s.neighbours,
        s.start.velocity, s.system.rate(), s.start.node_velocity));
    });
  add("projection",
    [](Stage& s)
    {
      Points moved = s.start.points + s.dt * s.start.node_velocity;
      DoNotOptimize(project_area_and_volume(
        moved, *s.system.vesicles[0].space, s.start.target_area, s.start.target_volume, false));
    });
  add("diagnostics", [](Stage& s) { DoNotOptimize(s.run.simulation.diagnose(s.run.state)); });
  return true;
}();

}
}
