// Against tables made independently in double precision.
#include "solver/surface/ExactCurvature.h"
#include "tests/solver/support/TestMeshes.h"

#include <gtest/gtest.h>

namespace vesicle
{
namespace
{

void expect_as_in(const std::string& file, const LevelSet& surface)
{
  const auto reference = test::read_reference("surfaces/" + file);
  const auto& x = reference.at("x");
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    const auto at = [&](const char* name) { return reference.at(name)[i]; };
    const ExactCurvature c = exact_curvature(surface, { at("x"), at("y"), at("z") });
    ASSERT_LT((c.normal - Vector3(at("nx"), at("ny"), at("nz"))).norm(), 1e-12);
    ASSERT_NEAR(c.mean, at("H"), 1e-12);
    ASSERT_NEAR(c.gauss, at("K"), 1e-12);
    ASSERT_NEAR(c.laplacian_mean, at("LapH"), 1e-6 * std::max(1., std::abs(at("LapH"))));
    ASSERT_NEAR(c.density(), at("fn_true"), 2e-6 * std::max(1., std::abs(at("fn_true"))));
  }
}

TEST(ExactCurvature, EllipsoidAsInTheTable)
{
  expect_as_in("ellipsoid_prolate_2_1_1.csv", ellipsoid_2_1_1_level_set());
}

TEST(ExactCurvature, PaperSurfaceAsInTheTables)
{
  expect_as_in("paper41_smooth_200.csv", paper_surface_level_set());
  expect_as_in("paper41_smooth_z0.csv", paper_surface_level_set());
}

}
}
