#include "solver/surface/ElementPattern.h"

#include "solver/mesh/shapes/GeodesicSphere.h"
#include "solver/surface/LoopBasis.h"
#include "solver/surface/WeakForms.h"
#include "tests/solver/support/TestMeshes.h"

#include <gtest/gtest.h>

#include <random>

namespace vesicle
{
namespace
{

// Loop's patches have different numbers of nodes around extraordinary vertices.
struct Case
{
  TriangleMesh mesh = test::jittered_sphere(3, 0.2);
  LoopBasis basis{ mesh.triangles, static_cast<int>(mesh.points.rows()) };
  BasisTable table = tabulate_rule(basis, triangle_rule(3), 1);
  SurfacePoints surface = evaluate(table, mesh.points);
};

EntryVectors random_vectors(const BasisTable& table)
{
  std::mt19937 random(1);
  std::normal_distribution<double> value;
  EntryVectors vectors(table.node.size(), 3);
  for (double& x : vectors.reshaped())
    x = value(random);
  return vectors;
}

TEST(ElementPattern, HoldsEveryPairOfNodesOfAnElementOnce)
{
  const Case c;
  const ElementPattern pattern(c.table);
  Eigen::MatrixXi together = Eigen::MatrixXi::Zero(c.table.nodes, c.table.nodes);
  for_each_element(c.table,
    [&](int, int, std::span<const int> nodes)
    {
      for (const int i : nodes)
        for (const int j : nodes)
          together(i, j) = 1;
    });
  Eigen::MatrixXi held = Eigen::MatrixXi::Zero(c.table.nodes, c.table.nodes);
  for (int i = 0; i < pattern.nodes(); ++i)
    for (int p = pattern.start()[i]; p < pattern.start()[i + 1]; ++p)
      ++held(i, pattern.partner()[p]);
  EXPECT_EQ(held, together);
}

TEST(ElementPattern, SumsAreThoseOfAllRows)
{
  const Case c;
  const SparseMatrix M = mass_matrix(c.table, c.surface), B = area_rate_matrix(c.table, c.surface);
  Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(c.table.nodes, c.table.nodes);
  for (int q = 0; q < c.table.rows(); ++q)
    for (int j = c.table.start[q]; j < c.table.start[q + 1]; ++j)
      for (int k = c.table.start[q]; k < c.table.start[q + 1]; ++k)
        mass(c.table.node[j], c.table.node[k]) +=
          c.surface.area_weight[q] * c.table.value[j] * c.table.value[k];
  EXPECT_LT((Eigen::MatrixXd(M) - mass).norm(), 1e-14 * mass.norm());
  // A constant of the first function leaves the area's gradient.
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(c.table.nodes),
                        gradient = area_gradient(c.table, c.surface);
  EXPECT_LT((B.transpose() * ones - gradient).norm(), 1e-14 * gradient.norm());
}

TEST(ElementPattern, GaussNewtonMatricesAreTheirRowsProducts)
{
  const Case c;
  const EntryVectors R = random_vectors(c.table);
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(c.table.rows(), 3L * c.table.nodes);
  for (int q = 0; q < c.table.rows(); ++q)
    for (int k = c.table.start[q]; k < c.table.start[q + 1]; ++k)
      rows.row(q).segment<3>(3L * c.table.node[k]) += R.row(k);
  const Eigen::MatrixXd exact = 2 * rows.transpose() * rows,
                        once = Eigen::MatrixXd(gauss_newton_matrix(c.table, { R })),
                        twice = Eigen::MatrixXd(gauss_newton_matrix(c.table, { R, R }));
  EXPECT_LT((once - exact).norm(), 1e-14 * exact.norm());
  EXPECT_LT((twice - 2 * exact).norm(), 1e-14 * exact.norm());
}

TEST(ElementPattern, OfATableIsUsedWhereItHasOne)
{
  Case c;
  const SparseMatrix before = mass_matrix(c.table, c.surface);
  c.table.pattern = std::make_shared<const ElementPattern>(c.table);
  EXPECT_EQ(pattern_of(c.table), c.table.pattern);
  EXPECT_EQ((mass_matrix(c.table, c.surface) - before).norm(), 0);
}

}
}
