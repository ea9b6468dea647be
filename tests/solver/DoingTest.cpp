// Errors say what was being done.

#include "solver/Doing.h"
#include "solver/Errors.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <new>

using namespace vesicle;

namespace
{

/// What becomes of an exception thrown while drawing plots/velocity.png.
template<typename Expected, typename Thrown>
std::string told(const Thrown& thrown)
{
  try
  {
    doing("drawing plots/velocity.png", [&] { throw thrown; });
  }
  catch (const Expected& error)
  {
    return error.what();
  }
  return "nothing";
}

}

TEST(Doing, ReturnsWhatTheWorkReturns)
{
  EXPECT_EQ(doing("adding", [] { return 2 + 2; }), 4);
  int value = 1;
  int& same = doing("looking", [&]() -> int& { return value; });
  EXPECT_EQ(&same, &value);
}

TEST(Doing, PassesOnWhatSaysWhereItHappened)
{
  EXPECT_EQ(told<InputError>(InputError("a.toml:3: no")), "a.toml:3: no");
  EXPECT_EQ(told<NumericalError>(NumericalError("t = 3: no")), "t = 3: no");
  EXPECT_EQ(told<IoError>(IoError("a.csv: no")), "a.csv: no");
  EXPECT_THROW(doing("counting", [] { throw 3; }), int); // no error, but somebody's way to stop
}

TEST(Doing, TellsWhatALibrarysExceptionDoesNot)
{
  const auto message = told<UnforeseenError>(std::logic_error("construction from null"));
  EXPECT_EQ(
    message, "drawing plots/velocity.png failed: construction from null (std::logic_error)");
  EXPECT_EQ(
    told<UnforeseenError>(std::bad_alloc()), "drawing plots/velocity.png failed: out of memory");
}

TEST(Doing, TakesTheSystemsErrorsForThoseOfFiles)
{
  const std::filesystem::filesystem_error error(
    "cannot copy", "plots/a", std::make_error_code(std::errc::no_space_on_device));
  const auto message = told<IoError>(error);
  EXPECT_NE(message.find("drawing plots/velocity.png"), std::string::npos) << message;
  EXPECT_NE(message.find("No space left"), std::string::npos) << message;
}

TEST(Doing, KeepsTheInnermostContext)
{
  const auto nested = [] {
    doing("running pear.toml", [] { doing("writing pear.csv", [] { throw std::bad_alloc(); }); });
  };
  try
  {
    nested();
    FAIL();
  }
  catch (const UnforeseenError& error)
  {
    EXPECT_STREQ(error.what(), "writing pear.csv failed: out of memory");
  }
}
