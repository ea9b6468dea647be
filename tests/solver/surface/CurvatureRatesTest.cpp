// The derivatives of curvature and area against difference quotients.

#include "solver/surface/CurvatureRates.h"

#include "solver/surface/NodalSum.h"
#include "solver/surface/Surface.h"
#include "tests/solver/support/TestMeshes.h"

#include <gtest/gtest.h>

namespace vesicle
{
namespace
{

TriangleMesh body()
{
  return test::mapped(test::smooth_sphere(80),
    [](const Vector3& d) -> Vector3 {
      return { 1.4 * d.x() + 0.3 * d.z(), 1.1 * d.y(), 0.8 * d.z() + 0.15 * d.x() * d.x() };
    });
}

// A displacement of the control points that is smooth in nothing.
Points displacement(Eigen::Index nodes)
{
  Points d(nodes, 3);
  for (Eigen::Index i = 0; i < nodes; ++i)
    d.row(i) << std::sin(7. * i), std::cos(3. * i + 1), std::sin(5. * i + 2);
  return d;
}

struct Quantities
{
  Eigen::VectorXd twice_mean, area;
  double integral;
};

Quantities at(const BasisTable& table, const Points& control)
{
  const SurfacePoints surface = evaluate(table, control);
  const Eigen::VectorXd twice_mean = 2 * mean_curvature(table, surface, control);
  return { twice_mean, surface.area_weight, surface.area_weight.dot(twice_mean) / 2 };
}

}

TEST(CurvatureRates, AreTheDerivatives)
{
  const TriangleMesh mesh = body();
  const SurfaceSpace space(
    SurfaceBasis::loop, mesh.triangles, static_cast<int>(mesh.points.rows()));
  const BasisTable& table = space.table();
  const Points control = rows_of_three(space.collocation().to_control(flat(mesh.points)));
  const Points d = displacement(control.rows());
  const SurfacePoints surface = evaluate(table, control);
  const CurvatureRates rates = curvature_rates(table, surface, control);

  const double h = 1e-6;
  const Quantities after = at(table, control + h * d), before = at(table, control - h * d);
  const EntryVectors of_twice_mean = entry_gradients(table, curvature_fields(table),
                       [&](int q) { return rates.of_twice_mean[q]; }),
                     of_area = entry_gradients(table, fields_of(table.du, table.dv),
                       [&](int q) { return rates.of_area[q]; });
  Eigen::VectorXd mean = Eigen::VectorXd::Zero(table.rows()), area = mean;
  for (int q = 0; q < table.rows(); ++q)
    for (int k = table.start[q]; k < table.start[q + 1]; ++k)
    {
      mean[q] += of_twice_mean.row(k).dot(d.row(table.node[k]));
      area[q] += of_area.row(k).dot(d.row(table.node[k]));
    }
  const Eigen::VectorXd mean_slope = (after.twice_mean - before.twice_mean) / (2 * h),
                        area_slope =
                          ((after.area - before.area) / (2 * h)).cwiseQuotient(surface.area_weight);
  EXPECT_LT((mean - mean_slope).norm(), 1e-7 * mean.norm());
  EXPECT_LT((area - area_slope).norm(), 1e-7 * area.norm());
  const double slope = (after.integral - before.integral) / (2 * h);
  EXPECT_NEAR(
    integrated_mean_curvature_gradient(table, surface, control).dot(flat(d)) / slope, 1, 1e-7);
}

}
