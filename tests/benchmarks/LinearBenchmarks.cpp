// What is factorised: a step's sparse matrices, by Eigen's simplicial LDLᵀ and by ours in double and
// single precision; flat triangles' dense columns, and the factorisation of what is made of them.
#include "tests/benchmarks/Measuring.h"
#include "tests/benchmarks/Scenes.h"

#include "solver/linear/DenseFactorization.h"
#include "solver/linear/SparseCholesky.h"
#include "solver/simulation/StartMesh.h"
#include "solver/simulation/SystemOfScene.h"
#include "solver/surface/NodeFrames.h"

#include <Eigen/SparseCholesky>

namespace vesicle::benchmarks
{
namespace
{

/// A start mesh's system and shape.
struct Shaped
{
  TriangleMesh mesh;
  System system;
  SystemShape shape;

  explicit Shaped(const Scene& scene)
    : mesh(make_start_mesh(scene)),
      system(system_of(scene, scales_of(scene, mesh),
        { { mesh.triangles, static_cast<int>(mesh.points.rows()) } })),
      shape(system, { mesh.points })
  {
  }
};

// The bending's stiffness of a pear and its mass, of two unknowns a node.
SymmetricMatrix tangential_stiffness(int triangles)
{
  const Shaped pear(endless("pear", triangles));
  const VesicleLoads& loads = *pear.shape.vesicles.front().loads;
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
void factorize(benchmark::State& state)
{
  const SymmetricMatrix A = tangential_stiffness(static_cast<int>(state.range(0)));
  Factors factors(A);
  for (auto _ : state)
    compute(factors, A);
}

template<class Factors>
void solve(benchmark::State& state)
{
  const SymmetricMatrix A = tangential_stiffness(static_cast<int>(state.range(0)));
  const Factors factors(A);
  Eigen::VectorXd x = Eigen::VectorXd::Ones(A.rows());
  for (auto _ : state)
    benchmark::DoNotOptimize(x = factors.solve(x).normalized());
}

void sizes(benchmark::internal::Benchmark* benchmark)
{
  with_all_threads(benchmark);
  benchmark->Arg(320)->Arg(1280)->Arg(5120);
}

template<class Factors>
void add(const std::string& name)
{
  benchmark::RegisterBenchmark(("Linear/factor/" + name).c_str(), factorize<Factors>)->Apply(sizes);
  benchmark::RegisterBenchmark(("Linear/solve/" + name).c_str(), solve<Factors>)->Apply(sizes);
}

// Two unknowns a vertex, as flat triangles have.
void dense_factors(benchmark::State& state)
{
  const auto n = state.range(0) + 4;
  Eigen::MatrixXf A = Eigen::MatrixXf::Random(n, n);
  A.diagonal().array() += 10;
  for (auto _ : state)
  {
    DenseFactorization lu;
    lu.compute(A);
  }
}

void dense_columns(benchmark::State& state)
{
  Scene scene = endless("pear", static_cast<int>(state.range(0)));
  scene.accuracy = Scene::preset(Scene::Preset::fast);
  const Shaped flat(scene);
  for (auto _ : state)
    benchmark::DoNotOptimize(mobilities(flat.shape));
}

[[maybe_unused]] const bool added = []
{
  add<Eigen::SimplicialLDLT<SymmetricMatrix>>("eigen");
  add<SupernodalCholesky<double>>("double");
  add<SupernodalCholesky<float>>("single");
  benchmark::RegisterBenchmark("Linear/columns", dense_columns)->Apply(sizes);
  benchmark::RegisterBenchmark("Linear/factor/dense", dense_factors)->Apply(sizes);
  return true;
}();

}
}
