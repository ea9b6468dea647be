#include "solver/flow/Extension.h"
#include "solver/flow/FieldFlow.h"
#include "solver/flow/FlowKinds.h"
#include "solver/flow/Poiseuille.h"
#include "solver/flow/Shear.h"
#include "solver/flow/Uniform.h"

#include <gtest/gtest.h>

#include <set>

namespace vesicle
{
namespace
{

Vector3 at(const ImposedFlow& flow, const Vector3& x)
{
  Points p(1, 3);
  p.row(0) = x.transpose();
  return flow.velocities(p).row(0).transpose();
}

struct SomeField final : VelocityField
{
  Points velocities(const Points& x, double time) const override
  {
    return (2 + time) * x.rowwise().reverse() * Eigen::Vector3d(1, 0, 1).asDiagonal();
  }
  double largest_rate() const override { return 1; }
  const std::vector<double>& times() const override { return times_; }
  std::vector<double> times_{ 0, 5 };
};

Vector3 some_value(const Vector3&, const FlowParameter& parameter)
{
  return parameter.dimension == Dimension::direction ? Vector3(0.6, 0, 0.8) : Vector3(1, 2, 3);
}

std::string some_value(const std::string&, const FlowParameter&)
{
  return "u.vti";
}

double some_value(double, const FlowParameter& parameter)
{
  return parameter.dimension == Dimension::length ? 4 : 2;
}

/// One of each kind, every parameter set.
std::vector<std::shared_ptr<const ImposedFlow>> every_flow()
{
  std::vector<std::shared_ptr<const ImposedFlow>> flows;
  for (const FlowKind* kind : flow_kinds())
  {
    std::shared_ptr<ImposedFlow> flow = kind->make();
    for (const FlowParameter& parameter : kind->parameters)
      std::visit([&](auto member) { (*flow).*member = some_value((*flow).*member, parameter); },
        parameter.member);
    if (auto* field = dynamic_cast<FieldFlow*>(flow.get()))
      field->field = std::make_shared<SomeField>();
    flows.push_back(flow);
  }
  return flows;
}

TEST(ImposedFlow, IsWhatTheSceneSays)
{
  const Vector3 x(0.5, -1, 2);
  EXPECT_EQ(at(Uniform({ 1, 2, 3 }), x), Vector3(1, 2, 3));
  EXPECT_EQ(at(Shear(2), x), Vector3(4, 0, 0));
  EXPECT_EQ(at(Extension(Extension::Type::planar, 2), x), Vector3(1, 0, -4));
  EXPECT_EQ(at(Extension(Extension::Type::axisymmetric, 2), x), Vector3(-0.5, 1, 4));
  // 3 (1 − d²/16) along z, d² = 0.25 + 1.
  const Poiseuille poiseuille(3, 4, { 0, 0, 2 }, { 1, 0, 5 });
  EXPECT_LT((at(poiseuille, x) - Vector3(0, 0, 3 * (1 - 1.25 / 16))).norm(), 1e-14);
}

TEST(ImposedFlow, IsIncompressible)
{
  for (const auto& flow : every_flow())
  {
    const double h = 1e-4;
    double divergence = 0;
    for (int d = 0; d < 3; ++d)
    {
      const Vector3 e = h * Vector3::Unit(d), x(0.3, 0.7, -0.2);
      divergence += (at(*flow, x + e) - at(*flow, x - e))[d] / (2 * h);
    }
    EXPECT_NEAR(divergence, 0, 1e-9) << flow->kind().title;
  }
}

TEST(ImposedFlow, ScalesLikeVelocity)
{
  const double length = 1e-6, velocity = 1e-4;
  for (const auto& flow : every_flow())
  {
    const Vector3 x(0.5, -1, 2);
    const auto scaled = flow->dimensionless(length, velocity);
    EXPECT_LT((velocity * at(*scaled, x / length) - at(*flow, x)).norm(), 1e-12)
      << flow->kind().title;
    EXPECT_EQ(&scaled->kind(), &flow->kind());
  }
}

// In a time of other units, and as strong as the factor says.
TEST(ImposedFlow, FieldsFollowTheirTimes)
{
  FieldFlow flow;
  flow.field = std::make_shared<SomeField>();
  const Vector3 x(0.5, -1, 2);
  EXPECT_EQ(flow.at(3)->velocity_at(x), Vector3(10, 0, 2.5));
  const auto scaled = flow.dimensionless(2, 8)->times(-3); // a time of 0.25
  EXPECT_LT((scaled->at(12)->velocity_at(x / 2) - Vector3(-30, 0, -7.5) / 8).norm(), 1e-14);
  EXPECT_EQ(scaled->next_corner(0), 20.);
  EXPECT_EQ(scaled->next_corner(20), std::nullopt);
  EXPECT_EQ(scaled->imposed_rate(), 0.75);
  EXPECT_FALSE(scaled->settled(1));
  EXPECT_TRUE(scaled->settled(20));
}

TEST(ImposedFlow, RateIsThatOnAUnitVesicle)
{
  EXPECT_EQ(Uniform({ 1, 2, 3 }).imposed_rate(), 0);
  EXPECT_EQ(Shear(-2).imposed_rate(), 2);
  EXPECT_EQ(Extension(Extension::Type::planar, -2).imposed_rate(), 2);
  EXPECT_EQ(Poiseuille(-8, 4).imposed_rate(), 1);
}

// From a profile's centre, across it, the velocity is along the flow and varies.
TEST(ImposedFlow, ProfilesAreUnidirectional)
{
  int profiles = 0;
  for (const auto& flow : every_flow())
    if (const auto profile = flow->profile())
    {
      const Vector3 across = profile->across.value_or(profile->along.unitOrthogonal());
      const Vector3 middle = at(*flow, profile->center);
      const Vector3 side = at(*flow, profile->center + profile->half_width * across);
      EXPECT_NEAR(across.dot(profile->along), 0, 1e-15);
      EXPECT_LT(middle.cross(profile->along).norm() + side.cross(profile->along).norm(), 1e-14);
      EXPECT_GT((middle - side).norm(), 1);
      ++profiles;
    }
  EXPECT_EQ(profiles, 2);
}

TEST(FlowKinds, HaveNamesThatDiffer)
{
  std::set<std::string> words, titles;
  for (const FlowKind* kind : flow_kinds())
  {
    words.insert(kind->name + ' ' + kind->type);
    titles.insert(kind->title);
    EXPECT_EQ(&kind->make()->kind(), kind);
    EXPECT_EQ(flow_kinds().at(number_of(*kind) - 1), kind);
  }
  EXPECT_EQ(words.size(), flow_kinds().size());
  EXPECT_EQ(titles.size(), flow_kinds().size());
}

}
}
