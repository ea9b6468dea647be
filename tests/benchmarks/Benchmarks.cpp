// Kernel, assembly, factorisation and step. The first two benchmarks are the machine's own rates;
// quote the others against them:
//   build/release/bin/vesicle_benchmarks
//   build/release/bin/vesicle_benchmarks --benchmark_filter=Step --benchmark_repetitions=5
#include "solver/linear/Blas.h"
#include "solver/linear/DenseFactorization.h"
#include "solver/linear/SparseCholesky.h"
#include "solver/simulation/SystemOfScene.h"
#include "solver/simulation/Simulation.h"
#include "solver/simulation/StartMesh.h"
#include "solver/stokes/kernels/StokesletKernel.h"
#include "solver/surface/NodeFrames.h"

#include <Eigen/SparseCholesky>
#include <benchmark/benchmark.h>

#include <numeric>
#include <vector>

namespace
{

using namespace vesicle;

// Forces at points and their velocities at others: the kernel alone.
template<class Real>
void KernelRate(benchmark::State& state)
{
  const int sources = 1024;
  std::vector<Real> x(sources), y(sources), z(sources), f(sources, 1);
  for (int i = 0; i < sources; ++i)
    x[i] = 2 + Real(0.001) * i, y[i] = 1 + Real(0.002) * i, z[i] = 3;
  const PointForces<Real> forces{ x.data(), y.data(), z.data(), f.data(), f.data(), f.data(),
    sources };
  std::vector<Real> targets(3 * sum_lanes), velocities(3 * sum_lanes);
  std::iota(targets.begin(), targets.end(), Real(-48));
  for (auto _ : state)
  {
    add_point_forces(forces, targets.data(), velocities.data());
    benchmark::DoNotOptimize(velocities.data());
  }
  state.counters["pairs/s"] = benchmark::Counter(
    static_cast<double>(sources) * sum_lanes, benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK_TEMPLATE(KernelRate, double);
BENCHMARK_TEMPLATE(KernelRate, float);

void FactorizationRate(benchmark::State& state)
{
  const int n = static_cast<int>(state.range(0));
  Eigen::MatrixXf A = Eigen::MatrixXf::Random(n, n);
  A.diagonal().array() += 10;
  for (auto _ : state)
  {
    DenseFactorization lu;
    lu.compute(A);
  }
  state.counters["flop/s"] = benchmark::Counter(
    2. / 3 * n * n * static_cast<double>(n), benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(FactorizationRate)->Arg(1284)->Arg(5124)->UseRealTime()->Unit(benchmark::kMillisecond);

Scene pear(int triangles)
{
  Scene scene;
  scene.vesicle.shape = { ShapeRequest::Kind::prolate, triangles, {}, 0.95, {}, {} };
  scene.membrane.bending_rigidity = 1;
  scene.gravity = Scene::Gravity{};
  scene.gravity->bond_number = 10;
  scene.time.end = 100;
  return scene;
}

// The velocities that bending, tension and gravity make, as matrices: the two bases beside each
// other.
void Assembly(benchmark::State& state, Scene::Basis basis)
{
  Scene scene = pear(static_cast<int>(state.range(0)));
  scene.accuracy =
    Scene::preset(basis == Scene::Basis::loop ? Scene::Preset::balanced : Scene::Preset::fast);
  const TriangleMesh mesh = make_start_mesh(scene);
  const System system =
    system_of(scene, scales_of(scene, mesh), mesh.triangles, static_cast<int>(mesh.points.rows()));
  const SystemShape shape(system, { mesh.points });
  for (auto _ : state)
    benchmark::DoNotOptimize(mobilities(shape));
  state.counters["pairs/s"] = benchmark::Counter(
    3. * static_cast<double>(mesh.points.rows()) * static_cast<double>(mesh.triangles.rows()),
    benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK_CAPTURE(Assembly, linear, Scene::Basis::linear)
  ->Arg(1280)
  ->Arg(5120)
  ->UseRealTime()
  ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(Assembly, loop, Scene::Basis::loop)
  ->Arg(1280)
  ->Arg(5120)
  ->UseRealTime()
  ->Unit(benchmark::kMillisecond);

// The bending's stiffness of a pear and its mass, of two unknowns a node: what a step factorises.
SymmetricMatrix tangential_stiffness(int triangles)
{
  const Scene scene = pear(triangles);
  const TriangleMesh mesh = make_start_mesh(scene);
  const System system =
    system_of(scene, scales_of(scene, mesh), mesh.triangles, static_cast<int>(mesh.points.rows()));
  const SystemShape shape(system, { mesh.points });
  const VesicleLoads& loads = *shape.vesicles.front().loads;
  SymmetricMatrix K = loads.stiffness_along(frames_along(loads.surface().normals).rightCols<6>());
  K.diagonal().array() += 1;
  return K;
}

void compute(Eigen::SimplicialLDLT<SymmetricMatrix>& factors, const SymmetricMatrix& A)
{
  factors.factorize(A);
}
template<class Scalar>
void compute(SupernodalCholesky<Scalar>& factors, const SymmetricMatrix& A)
{
  factors.compute(A);
}

template<class Factors>
void SparseFactorization(benchmark::State& state)
{
  const SymmetricMatrix A = tangential_stiffness(static_cast<int>(state.range(0)));
  Factors factors(A);
  for (auto _ : state)
    compute(factors, A);
}

template<class Factors>
void SparseSolution(benchmark::State& state)
{
  const SymmetricMatrix A = tangential_stiffness(static_cast<int>(state.range(0)));
  const Factors factors(A);
  Eigen::VectorXd x = Eigen::VectorXd::Ones(A.rows());
  for (auto _ : state)
    benchmark::DoNotOptimize(x = factors.solve(x).normalized());
}

void sizes(benchmark::internal::Benchmark* benchmark)
{
  benchmark->Arg(320)->Arg(1280)->Arg(5120)->Unit(benchmark::kMillisecond);
}
BENCHMARK_TEMPLATE(SparseFactorization, Eigen::SimplicialLDLT<SymmetricMatrix>)->Apply(sizes);
BENCHMARK_TEMPLATE(SparseFactorization, SupernodalCholesky<double>)->Apply(sizes);
BENCHMARK_TEMPLATE(SparseFactorization, SupernodalCholesky<float>)->Apply(sizes);
BENCHMARK_TEMPLATE(SparseSolution, Eigen::SimplicialLDLT<SymmetricMatrix>)->Apply(sizes);
BENCHMARK_TEMPLATE(SparseSolution, SupernodalCholesky<double>)->Apply(sizes);
BENCHMARK_TEMPLATE(SparseSolution, SupernodalCholesky<float>)->Apply(sizes);

// Accepted steps of a rising vesicle from its start, everything included.
void Step(benchmark::State& state, Scene::Preset preset)
{
  Scene scene = pear(static_cast<int>(state.range(0)));
  scene.accuracy = Scene::preset(preset);
  Simulation simulation(scene, make_start_mesh(scene));
  State current = simulation.start();
  for (auto _ : state)
    current = simulation.step(current);
}
BENCHMARK_CAPTURE(Step, fast, Scene::Preset::fast)
  ->Arg(320)
  ->Arg(1280)
  ->Arg(5120)
  ->UseRealTime()
  ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(Step, balanced, Scene::Preset::balanced)
  ->Arg(320)
  ->Arg(1280)
  ->Arg(5120)
  ->UseRealTime()
  ->Unit(benchmark::kMillisecond);

// What the scene doesn't name costs nothing: the same step without bending, and without tension.
void StepWithoutBending(benchmark::State& state)
{
  Scene scene = pear(1280);
  scene.membrane.bending_rigidity.reset();
  scene.time.step = 0.01;
  Simulation simulation(scene, make_start_mesh(scene));
  State current = simulation.start();
  for (auto _ : state)
    current = simulation.step(current);
}
BENCHMARK(StepWithoutBending)->UseRealTime()->Unit(benchmark::kMillisecond);

void StepWithoutTension(benchmark::State& state)
{
  Scene scene = pear(1280);
  scene.membrane.incompressible = false;
  scene.time.step = 0.001;
  Simulation simulation(scene, make_start_mesh(scene));
  State current = simulation.start();
  for (auto _ : state)
    current = simulation.step(current);
}
BENCHMARK(StepWithoutTension)->UseRealTime()->Unit(benchmark::kMillisecond);

}

int main(int argc, char** argv)
{
  vesicle::restart_with_blas_kernel(argv);
  benchmark::AddCustomContext("BLAS kernel", vesicle::blas_kernel());
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
