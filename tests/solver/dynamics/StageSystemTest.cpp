// On flat triangles: what a block says of itself once is one operator, whichever way it is used.
#include "solver/dynamics/StageSystem.h"

#include "solver/dynamics/Preconditioner.h"
#include "solver/flow/Shear.h"
#include "solver/membrane/Buoyancy.h"
#include "solver/membrane/HelfrichBending.h"
#include "tests/solver/support/TestMeshes.h"

#include <gtest/gtest.h>

namespace vesicle
{
namespace
{

struct Setting
{
  const char* name;
  VertexCurvature curvature;
  bool conserved;
};

constexpr Setting settings[] = {
  { "paper", VertexCurvature::paper, false },
  { "flat", VertexCurvature::cotan, true },
};

Vesicle vesicle_of(const Setting& setting, const TriangleMesh& mesh)
{
  Vesicle vesicle =
    make_vesicle(std::make_unique<SurfaceSpace>(SurfaceBasis::linear, setting.curvature,
                   mesh.triangles, static_cast<int>(mesh.points.rows()), 3),
      3);
  vesicle.terms.push_back(make_bending(*vesicle.space, 0));
  vesicle.terms.push_back(make_buoyancy(*vesicle.space, 5));
  vesicle.incompressibility = make_incompressibility(*vesicle.space);
  vesicle.conserved = setting.conserved;
  return vesicle;
}

TriangleMesh ellipsoid()
{
  return test::mapped(test::smooth_sphere(80), test::ellipsoid_2_1_1);
}

std::shared_ptr<const ImposedFlow> shear()
{
  auto flow = std::make_shared<Shear>();
  flow->rate = 2;
  return flow;
}

class Stage : public testing::TestWithParam<Setting>
{
};

void expect_dense_to_be_the_operator(const System& system, const std::vector<Points>& points)
{
  const SystemShape shape(system, points);
  const std::vector<Mobility> mobility = mobilities(shape);
  const StageSystem stage(shape, mobility, 0.01, {});
  const Eigen::MatrixXd dense = stage.dense().cast<double>();
  ASSERT_EQ(dense.rows(), stage.unknowns());
  double difference = 0;
  Eigen::MatrixXd applied(stage.unknowns(), stage.unknowns());
  for (Eigen::Index i = 0; i < stage.unknowns(); ++i)
    applied.col(i) = stage.apply(Eigen::VectorXd::Unit(stage.unknowns(), i));
  for (Eigen::Index i = 0; i < stage.unknowns(); ++i)
    difference = std::max(difference,
      (dense.row(i) - applied.row(i)).cwiseAbs().maxCoeff() / applied.row(i).cwiseAbs().maxCoeff());
  EXPECT_LT(difference, 1e-5); // single precision
}

TEST_P(Stage, DenseMatrixIsTheOperators)
{
  const TriangleMesh mesh = ellipsoid();
  System system;
  system.vesicles.push_back(vesicle_of(GetParam(), mesh));
  expect_dense_to_be_the_operator(system, { mesh.points });
}

// On a sphere the gauge of the tension is an unknown more.
TEST_P(Stage, DenseMatrixIsTheOperatorsWithAPinnedGauge)
{
  const TriangleMesh mesh = test::smooth_sphere(80);
  System system;
  system.vesicles.push_back(vesicle_of(GetParam(), mesh));
  expect_dense_to_be_the_operator(system, { mesh.points });
}

TEST_P(Stage, SolutionKeepsTheConstraints)
{
  const TriangleMesh mesh = ellipsoid();
  System system;
  system.vesicles.push_back(vesicle_of(GetParam(), mesh));
  system.flow = shear();
  const SystemShape shape(system, { mesh.points });
  const std::vector<Mobility> mobility = mobilities(shape);
  const StageSystem stage(shape, mobility, 0.01, {});
  DensePreconditioner preconditioner;
  preconditioner.build(stage);
  const StageSolution solution = stage.solve(preconditioner, 1e-12, 60);
  const Surface& surface = *shape.vesicles[0].surface;
  const ConstraintRows& rows = *shape.vesicles[0].constraint;
  const Eigen::VectorXd divergence = rows.rate * surface.to_control(solution.velocity);
  const double scale = divergence.size() * surface.divergence(shape.imposed).cwiseAbs().maxCoeff();
  EXPECT_LT(divergence.cwiseAbs().maxCoeff(), 1e-9 * scale);
  if (GetParam().conserved)
  {
    EXPECT_LT(std::abs(surface.volume_gradient.dot(solution.velocity)), 1e-9 * surface.volume);
  }
}

// Two vesicles are blocks of one system, and far apart each moves as if it were alone.
TEST_P(Stage, TwoVesiclesFarApartMoveAsAlone)
{
  const TriangleMesh mesh = ellipsoid();
  const auto solve = [&](const std::vector<Points>& points)
  {
    System system;
    for (std::size_t v = 0; v < points.size(); ++v)
      system.vesicles.push_back(vesicle_of(GetParam(), mesh));
    if (points.size() > 1)
      expect_dense_to_be_the_operator(system, points);
    const SystemShape shape(system, points);
    const std::vector<Mobility> mobility = mobilities(shape);
    const StageSystem stage(shape, mobility, 0.01, {});
    DensePreconditioner preconditioner;
    preconditioner.build(stage);
    const StageSolution solution = stage.solve(preconditioner, 1e-10, 60);
    EXPECT_EQ(solution.vesicles.size(), points.size());
    return shape.vesicles[0].surface->mean_velocity(shape.part(solution.velocity, 0)).z();
  };
  const double alone = solve({ mesh.points });
  // A point force F changes the other's speed by F/(8πd) across their line of centres, F = Bo V.
  const double V = Surface(*vesicle_of(GetParam(), mesh).space, mesh.points).volume;
  for (const double d : { 20., 40. })
  {
    const Points other = mesh.points.rowwise() + Eigen::RowVector3d(d, 0, 0);
    const double gain = solve({ mesh.points, other }) - alone;
    EXPECT_NEAR(gain * (8 * M_PI * d) / (5 * V), 1, 4 / d) << d;
  }
}

INSTANTIATE_TEST_SUITE_P(Schemes, Stage, testing::ValuesIn(settings),
  [](const auto& setting) { return setting.param.name; });

}
}
