// Stages on smooth surfaces: the solution keeps the constraints, and the energy goes where the
// dissipation says.

#include "solver/dynamics/LoadStage.h"

#include "solver/dynamics/LocalPreconditioner.h"
#include "solver/dynamics/StageSolver.h"
#include "solver/flow/Shear.h"
#include "solver/membrane/Buoyancy.h"
#include "solver/membrane/HelfrichBending.h"
#include "solver/stokes/DoubleLayer.h"
#include "tests/solver/support/TestMeshes.h"

#include <gtest/gtest.h>

namespace vesicle
{
namespace
{

// Elongated, without symmetry: symmetric shapes need fewer iterations.
TriangleMesh body(int triangles)
{
  return test::mapped(test::smooth_sphere(triangles),
    [](const Vector3& d) -> Vector3 {
      return { 1.5 * d.x() + 0.2 * d.z(), 0.8 * d.y(), 0.8 * d.z() + 0.1 * d.x() * d.x() };
    });
}

Vesicle vesicle_of(const TriangleMesh& mesh, NodeMotionKind motion)
{
  Vesicle vesicle =
    make_vesicle(SurfaceBasis::loop, mesh.triangles, static_cast<int>(mesh.points.rows()), 3);
  vesicle.terms.push_back(make_bending(*vesicle.space, 0));
  vesicle.incompressibility = make_incompressibility(*vesicle.space);
  vesicle.motion = motion;
  return vesicle;
}

/// A system's stage with its solution.
struct Solved
{
  SystemShape shape;
  StageSolution solution;

  Solved(const System& system, const std::vector<Points>& points, double tau, double tolerance,
    const State& guess = {})
    : shape(system, points)
  {
    const StokesOperator surfaces(layer_surfaces(shape));
    const LayerSum layer(surfaces);
    std::vector<double> factors;
    for (const Vesicle& vesicle : system.vesicles)
      factors.push_back(1 - vesicle.viscosity_ratio);
    const DoubleLayer double_layer(surfaces, factors);
    ContrastMap contrast;
    if (std::any_of(factors.begin(), factors.end(), [](double factor) { return factor != 0; }))
      contrast = [&](const std::vector<Eigen::VectorXd>& nodal, const Eigen::VectorXd& at_vertices,
                   double allowed) { return double_layer.apply(nodal, at_vertices, allowed); };
    std::vector<LocalPreconditioner> preconditioners(shape.vesicles.size());
    for (std::size_t v = 0; v < shape.vesicles.size(); ++v)
    {
      preconditioners[v].build(*shape.vesicles[v].loads);
      if (tau > 0 || shape.vesicles[v].loads->taut())
        preconditioners[v].build_stiff(*shape.vesicles[v].loads, tau);
    }
    const LoadStage stage(shape,
      { [&](const std::vector<Eigen::VectorXd>& densities, double allowed)
        { return layer.apply(densities, allowed); },
        contrast },
      tau, {}, guess);
    solution = stage.solve(preconditioners, tolerance, 200);
  }

  /// With the solution as the velocities, tensions and multipliers.
  State state() const
  {
    State state;
    for (std::size_t v = 0; v < shape.vesicles.size(); ++v)
    {
      VesicleState& vesicle = state.vesicles.emplace_back();
      vesicle.velocity = rows_of_three(shape.part(solution.velocity, v));
      vesicle.tension = solution.vesicles[v].tension;
      vesicle.pressure = solution.vesicles[v].pressure;
      vesicle.volume_speed = solution.vesicles[v].volume_speed;
    }
    return state;
  }
};

class LoadStages : public testing::TestWithParam<NodeMotionKind>
{
};

TEST_P(LoadStages, SolutionKeepsTheConstraints)
{
  const TriangleMesh mesh = body(320);
  System system;
  system.vesicles.push_back(vesicle_of(mesh, GetParam()));
  auto flow = std::make_shared<Shear>();
  flow->rate = 2;
  system.flow = flow;
  const Solved s(system, { mesh.points }, 0.01, 1e-10);
  const VesicleLoads& loads = *s.shape.vesicles[0].loads;
  const Eigen::VectorXd u = loads.surface().to_control(s.solution.velocity);
  const Eigen::VectorXd rows = loads.tension_rows(u, s.solution.vesicles[0].tension);
  EXPECT_LT(rows.cwiseAbs().maxCoeff(), 1e-8 * (loads.constraint().rate * u).norm());
  EXPECT_LT(std::abs(loads.volume_rate().dot(u)), 1e-8 * loads.surface().volume);
}

// With τ = 0: dE/dt = g·Qu is minus what the layer dissipates, l·A l, and the tension's filter.
TEST_P(LoadStages, EnergyGoesWhereTheDissipationSays)
{
  for (const int triangles : { 80, 320 })
  {
    const TriangleMesh mesh = body(triangles);
    System system;
    system.vesicles.push_back(vesicle_of(mesh, GetParam()));
    const Solved s(system, { mesh.points }, 0, 1e-11);
    const VesicleLoads& loads = *s.shape.vesicles[0].loads;
    const Eigen::VectorXd& gamma = s.solution.vesicles[0].tension;
    const Eigen::VectorXd u = loads.surface().to_control(s.solution.velocity);
    const double filtered = -gamma.dot(loads.constraint().filter * gamma);
    const double lost = -loads.gradient().dot(
      loads.motion().velocity(loads.motion().parameters(s.solution.velocity)));
    // The pressure does no work: the load but for it has all of the power.
    const double done = (loads.load() - loads.area_rates_adjoint(gamma)).dot(u);
    EXPECT_GT(done, 0);
    EXPECT_GE(filtered, 0);
    EXPECT_NEAR((done + filtered) / lost, 1, 1e-8) << triangles;
  }
}

// The local preconditioner: as many iterations on every mesh.
TEST_P(LoadStages, IterationsDontGrowWithTheMesh)
{
  for (const double tau : { 1e-3, 0.1 })
    for (const int triangles : { 80, 320, 1280 })
    {
      const TriangleMesh mesh = body(triangles);
      System system;
      system.vesicles.push_back(vesicle_of(mesh, GetParam()));
      const Solved s(system, { mesh.points }, tau, 1e-8);
      EXPECT_LE(s.solution.iterations, 40) << triangles << ", " << tau;
    }
}

// Two vesicles are one problem, and far apart each moves as if it were alone: a point force F
// changes the other's speed by F/(8πd) across their line of centres, F = Bo V.
// A guess saves iterations and changes nothing within the tolerance, whatever it is.
TEST_P(LoadStages, AGuessIsWhereTheSolutionIsLookedForFrom)
{
  const TriangleMesh mesh = body(320);
  System system;
  system.vesicles.push_back(vesicle_of(mesh, GetParam()));
  const double tau = 0.01, tolerance = 1e-8;
  const Solved exact(system, { mesh.points }, tau, 1e-11),
    without(system, { mesh.points }, tau, tolerance);
  State near = exact.state();
  EXPECT_EQ(Solved(system, { mesh.points }, tau, tolerance, near).solution.iterations, 0);
  const Solved other(system, { Points(1.001 * mesh.points) }, tau, tolerance);
  const Solved with(system, { mesh.points }, tau, tolerance, other.state());
  EXPECT_LT(with.solution.iterations, without.solution.iterations * 0.75);
  const double size = exact.solution.velocity.norm();
  EXPECT_LT((with.solution.velocity - exact.solution.velocity).norm(), 3 * tolerance * size);
  EXPECT_LT((without.solution.velocity - exact.solution.velocity).norm(), 3 * tolerance * size);
}

// By sums or by a matrix, in either precision: the same within the tolerance.
TEST_P(LoadStages, TheLayersMethodDoesNotMatter)
{
  const TriangleMesh mesh = body(320);
  System system;
  system.vesicles.push_back(vesicle_of(mesh, GetParam()));
  const SystemShape shape(system, { mesh.points });
  const double tolerance = 1e-8;
  const auto velocity = [&](const LayerSettings& layer, double to)
  {
    State state;
    const auto stages = make_stage_solver(system, layer);
    return stages->solve(shape, { 0.03, 0.01, {}, to }, state).velocity;
  };
  const Eigen::VectorXd exact = velocity({ LayerMethod::dense, LayerPrecision::full }, 1e-11);
  const auto expect_exact = [&](const LayerSettings& layer, double to)
  {
    const Eigen::VectorXd u = velocity(layer, to);
    EXPECT_LT((u - exact).norm(), 3 * to * exact.norm());
  };
  expect_exact({ LayerMethod::automatic, LayerPrecision::mixed }, tolerance);
  expect_exact({ LayerMethod::direct, LayerPrecision::mixed }, tolerance);
  expect_exact({ LayerMethod::direct, LayerPrecision::full }, tolerance);
  expect_exact({ LayerMethod::direct, LayerPrecision::mixed }, 1e-5);
  expect_exact({ LayerMethod::tree, LayerPrecision::mixed, tolerance }, tolerance);
}

TEST_P(LoadStages, TwoVesiclesFarApartMoveAsAlone)
{
  const TriangleMesh mesh = body(80);
  const auto speed = [&](const std::vector<Points>& points)
  {
    System system;
    for (std::size_t v = 0; v < points.size(); ++v)
    {
      system.vesicles.push_back(vesicle_of(mesh, GetParam()));
      Vesicle& vesicle = system.vesicles.back();
      vesicle.terms.push_back(make_buoyancy(*vesicle.space, 5));
    }
    const Solved s(system, points, 0.01, 1e-10);
    return s.shape.vesicles[0].surface->mean_velocity(s.shape.part(s.solution.velocity, 0)).z();
  };
  const double alone = speed({ mesh.points });
  const double V = Surface(*vesicle_of(mesh, GetParam()).space, mesh.points).volume;
  for (const double d : { 20., 40. })
  {
    const Points other = mesh.points.rowwise() + Eigen::RowVector3d(d, 0, 0);
    EXPECT_NEAR((speed({ mesh.points, other }) - alone) * (8 * M_PI * d) / (5 * V), 1, 4 / d) << d;
  }
}

// A sphere can't deform: in shear it turns at half the rate, whatever the implicit time, and its
// tension, free of a gauge, has no mean.
TEST_P(LoadStages, ASphereTurnsRigidly)
{
  for (const double tau : { 0., 0.1 })
  {
    const TriangleMesh mesh = test::smooth_sphere(320);
    System system;
    system.vesicles.push_back(vesicle_of(mesh, GetParam()));
    auto flow = std::make_shared<Shear>();
    flow->rate = 1;
    system.flow = flow;
    const Solved s(system, { mesh.points }, tau, 1e-10);
    const VesicleLoads& loads = *s.shape.vesicles[0].loads;
    ASSERT_TRUE(loads.taut());
    const Eigen::VectorXd& gamma = s.solution.vesicles[0].tension;
    EXPECT_LT(std::abs(loads.surface().vertex_area.dot(gamma)), 1e-9 * gamma.norm());
    Points solid(mesh.points.rows(), 3);
    solid.col(0) = mesh.points.col(2) / 2;
    solid.col(1).setZero();
    solid.col(2) = -mesh.points.col(0) / 2;
    EXPECT_LT(
      (rows_of_three(s.solution.velocity) - solid).rowwise().norm().maxCoeff(), 3e-3); // 1.9e-3
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, LoadStages,
  testing::Values(NodeMotionKind::normal, NodeMotionKind::material),
  [](const auto& kind) { return kind.param == NodeMotionKind::normal ? "normal" : "material"; });

}
}
