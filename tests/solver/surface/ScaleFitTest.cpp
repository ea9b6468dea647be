#include "solver/surface/ScaleFit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

namespace vesicle::test
{
namespace
{

const Vector3 up(0, 0, 1);

/// Points of a surface over a disc of radius 1, the vertex at the origin being the first.
Candidates points(int count, std::mt19937& random, const std::function<Vector3(double, double)>& at)
{
  std::uniform_real_distribution<double> share(0, 1);
  Candidates result;
  const auto add = [&](const Vector3& x)
  {
    result.x.push_back(x.x());
    result.y.push_back(x.y());
    result.z.push_back(x.z());
    for (auto* n : { &result.nx, &result.ny })
      n->push_back(0);
    result.nz.push_back(1);
  };
  add(at(0, 0));
  while (static_cast<int>(result.x.size()) < count)
  {
    const double r = std::sqrt(share(random)), angle = 2 * std::numbers::pi * share(random);
    add(at(r * std::cos(angle), r * std::sin(angle)));
  }
  return result;
}

bool compute(ScaleFit& fit, const Candidates& candidates, double radius, const Vector3& normal = up)
{
  const Vector3 vertex(candidates.x[0], candidates.y[0], candidates.z[0]);
  fit.choose(candidates, vertex, normal, radius, -1);
  return fit.compute(normal, radius);
}

}

// The radius is more than half of that of curvature, the normal given off by 0.2.
TEST(ScaleFit, SpheresAndCylindersAreExact)
{
  std::mt19937 random(2);
  constexpr double R = 1.5;
  const Vector3 tilted = Vector3(0.2, -0.1, 1).normalized();
  ScaleFit fit;
  const auto sphere = points(
    60, random, [](double x, double y) { return Vector3(x, y, std::sqrt(R * R - x * x - y * y)); });
  ASSERT_TRUE(compute(fit, sphere, 0.9, tilted));
  // Sixth order: radius to curvature to the power of four, 0.13, over some tens.
  EXPECT_NEAR(fit.surface().mean(), 1 / R, 2e-3);
  EXPECT_NEAR(fit.surface().gauss(), 1 / (R * R), 3e-3);
  EXPECT_LT((fit.surface().normal() - up).norm(), 5e-3);
  const auto cylinder =
    points(60, random, [](double x, double y) { return Vector3(x, y, std::sqrt(R * R - x * x)); });
  ASSERT_TRUE(compute(fit, cylinder, 0.9, tilted));
  EXPECT_NEAR(fit.surface().mean(), 0.5 / R, 2e-3);
  EXPECT_NEAR(fit.surface().gauss(), 0, 2e-3);
  EXPECT_GT(std::abs(fit.surface().direction().x()), 0.999);
}

// The mean error says how much H deviates from one noise to the next.
TEST(ScaleFit, TheMeanErrorIsTheDeviation)
{
  std::mt19937 random(2);
  std::normal_distribution<double> noise(0, 0.01);
  constexpr int samples = 1000, count = 60;
  double sum = 0, squares = 0, expected = 0;
  ScaleFit fit;
  for (int k = 0; k < samples; ++k)
  {
    const auto plate =
      points(count, random, [&](double x, double y) { return Vector3(x, y, noise(random)); });
    ASSERT_TRUE(compute(fit, plate, 2));
    sum += fit.surface().mean();
    squares += fit.surface().mean() * fit.surface().mean();
    expected += fit.mean_error() * fit.mean_error();
    EXPECT_NEAR(fit.residual(), 0.01, 0.004); // five deviations of the estimate
  }
  // A deviation is known from n samples up to 1/√(2n), 2.2%.
  EXPECT_NEAR(std::sqrt(squares / expected), 1, 4 * 0.022);
  EXPECT_LT(std::abs(sum / samples), 4 * std::sqrt(squares) / samples);
}

TEST(ScaleFit, LaplacianOfQuadraticFields)
{
  std::mt19937 random(2);
  const auto plate = points(40, random, [](double x, double y) { return Vector3(x, y, 0); });
  ScaleFit fit;
  ASSERT_EQ(fit.choose(plate, Vector3::Zero(), up, 2, 0), 40);
  std::vector<double> field;
  for (int k = 0; k < 40; ++k)
    field.push_back(5 + 2 * plate.x[k] + 3 * plate.x[k] * plate.x[k] - plate.x[k] * plate.y[k] -
      plate.y[k] * plate.y[k]);
  EXPECT_NEAR(fit.laplacian(up, 2, field), 4, 1e-12);
}

TEST(ScaleFit, ChoosesByDistanceAndByTheWayThatPointsFace)
{
  Candidates candidates{ { 0, 1, 2, 0.5 }, { 0, 0, 0, 0 }, { 0, 0, 0, 0.1 }, { 0, 0, 0, 0 },
    { 0, 0, 0, 0 }, { 1, 1, 1, -1 } };
  ScaleFit fit;
  EXPECT_EQ(fit.choose(candidates, Vector3::Zero(), up, 1.5, 0), 2);
  EXPECT_EQ(fit.chosen(), (std::vector<int>{ 0, 1 }));
  EXPECT_EQ(fit.choose(candidates, Vector3::Zero(), up, 3, -1), 4);
}

TEST(ScaleFit, PointsThatDontDetermineIt)
{
  std::mt19937 random(2);
  ScaleFit fit;
  EXPECT_FALSE(
    compute(fit, points(6, random, [](double x, double y) { return Vector3(x, y, 0); }), 2));
  EXPECT_FALSE(
    compute(fit, points(40, random, [](double x, double) { return Vector3(x, 2 * x, 0); }), 2));
  EXPECT_FALSE(
    compute(fit, points(40, random, [](double, double) { return Vector3(0, 0, 0); }), 2));
}

}
