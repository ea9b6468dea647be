#include "solver/flow/FlowNumbers.h"

#include "solver/flow/Extension.h"
#include "solver/flow/FlowKinds.h"
#include "solver/flow/Poiseuille.h"
#include "solver/flow/Uniform.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace vesicle
{
namespace
{

using Numbers = std::map<std::string, std::vector<double>>;

std::shared_ptr<const ImposedFlow> flow_from(int kind, const Numbers& numbers)
{
  return flow_of(kind,
    [&](const std::string& name, std::span<double> values)
    { std::copy_n(numbers.at(name).begin(), values.size(), values.begin()); });
}

Numbers numbers_from(const ImposedFlow& flow)
{
  Numbers numbers;
  for (const FlowNumbers& entry : numbers_of(flow))
    numbers[entry.name] = entry.values;
  return numbers;
}

TEST(FlowNumbers, AreTheParameters)
{
  EXPECT_EQ(numbers_from(Uniform({ 1, 2, 3 })), (Numbers{ { "velocity", { 1, 2, 3 } } }));
  EXPECT_EQ(numbers_from(Extension(Extension::Type::planar, -2)), (Numbers{ { "rate", { -2 } } }));
}

TEST(FlowNumbers, ASpeedAlongAnAxisIsAVector)
{
  const Poiseuille poiseuille(-3, 4, { 0, 0, 1 }, { 1, 0, 5 });
  const Numbers numbers{ { "velocity", { 0, 0, -3 } }, { "radius", { 4 } },
    { "center", { 1, 0, 5 } } };
  EXPECT_EQ(numbers_from(poiseuille), numbers);
  const auto again = flow_from(number_of(poiseuille.kind()), numbers);
  const auto& same = dynamic_cast<const Poiseuille&>(*again);
  EXPECT_EQ(same.velocity, 3);
  EXPECT_EQ(same.axis, Vector3(0, 0, -1));
  EXPECT_EQ(same.radius, 4);
  EXPECT_EQ(same.center, Vector3(1, 0, 5));
}

TEST(FlowNumbers, NothingFlowsWithoutAKind)
{
  EXPECT_EQ(flow_from(0, {}), nullptr);
}

TEST(FlowNumbers, AtRestAPoiseuilleFlowKeepsItsAxis)
{
  const Numbers still{ { "velocity", { 0, 0, 0 } }, { "radius", { 4 } },
    { "center", { 0, 0, 0 } } };
  const auto flow = flow_from(number_of(Poiseuille::description()), still);
  EXPECT_EQ(dynamic_cast<const Poiseuille&>(*flow).axis, Vector3(1, 0, 0));
}

}
}
