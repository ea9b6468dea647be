#include "solver/state/Table.h"

#include "solver/Errors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vesicle
{
namespace
{

TEST(Table, ReadsNamesTextAndNumbers)
{
  const Table table =
    parse_table("# by hand\nbranch,v,E  (units of 8π)\nprolate,0.8,1.5\noblate,0.9,2e-1\n");
  EXPECT_EQ(table.names, (std::vector<std::string>{ "branch", "v", "E" }));
  EXPECT_EQ(table.rows[1][0], "oblate");
  EXPECT_EQ(table.column("E"), (std::vector<double>{ 1.5, 0.2 }));
  EXPECT_THROW(table.column("branch"), InputError);
  EXPECT_THROW(table.column("w"), InputError);
  EXPECT_THROW(parse_table("a,b\n1\n"), InputError);
}

TEST(Table, EmptyCellsAreCellsAndLinesAreCounted)
{
  const Table table = parse_table("# by hand\na,b\r\n1,\r\n\n,2\n", "run.csv");
  EXPECT_EQ(table.names, (std::vector<std::string>{ "a", "b" }));
  EXPECT_EQ(table.rows, (std::vector<std::vector<std::string>>{ { "1", "" }, { "", "2" } }));
  EXPECT_EQ(table.lines, (std::vector{ 3, 5 }));
  try
  {
    parse_table("a,b\n1,2\n1,2,3\n", "run.csv");
    FAIL();
  }
  catch (const InputError& error)
  {
    EXPECT_STREQ(error.what(), "run.csv:3: has 3 values for 2 columns");
  }
}

TEST(Table, OnlyNumbersAreNumbers)
{
  EXPECT_EQ(number_in(" -2.5e3 "), -2500);
  for (const char* cell : { "", " ", "two", "1.5x", "1 2", "0x10" })
  {
    EXPECT_FALSE(number_in(cell)) << cell;
  }
}

TEST(Table, CubicIsExactForCubicsInsideAndPeriodic)
{
  std::vector<double> wave;
  const double step = std::numbers::pi / 90;
  for (int i = 0; i <= 180; ++i)
    wave.push_back(std::sin(step * i));
  for (double x : { 0.01, 1.234, 3.3, 6.28 })
    EXPECT_NEAR(periodic_cubic(wave, step, x), std::sin(x), 1e-7);
  std::vector<double> cubic;
  for (int i = 0; i <= 10; ++i)
    cubic.push_back(i * i * i);
  EXPECT_NEAR(periodic_cubic(cubic, 1, 4.3), 4.3 * 4.3 * 4.3, 1e-10);
}

}
}
