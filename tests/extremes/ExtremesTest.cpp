// At the ends of what can be asked for a scene runs and is right, is refused, or stops and says why.

#include "Extremes.h"

#include <gtest/gtest.h>

#include <sstream>

namespace vesicle::test
{

class Extremes : public testing::TestWithParam<Cell>
{
};

TEST_P(Extremes, EndWell)
{
  const CellResult result = run_cell(GetParam());
  SCOPED_TRACE(GetParam().scene);
  EXPECT_NE(result.end, CellResult::End::wrong) << result.message;
  EXPECT_NE(result.end, CellResult::End::crawls) << result.steps << " steps to t = " << result.time;
  EXPECT_EQ(result.end == CellResult::End::runs, result.message.empty()) << result.message;
  if (result.end == CellResult::End::stopped)
  {
    EXPECT_NE(result.message.find("t = "), std::string::npos) << result.message; // when
  }
}

INSTANTIATE_TEST_SUITE_P(Of80Triangles, Extremes, testing::ValuesIn(extremes(80)),
  [](const testing::TestParamInfo<Cell>& info)
  {
    std::string name = std::to_string(info.index) + "_" + info.param.axis + "_" + info.param.value;
    for (char& c : name)
      c = std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
    return name;
  });

}
