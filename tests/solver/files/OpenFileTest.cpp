#include "solver/files/OpenFile.h"

#include "solver/Errors.h"
#include "solver/files/FileBytes.h"
#include "tests/solver/support/FullDisk.h"
#include "tests/support/TemporaryFolder.h"

#include <gtest/gtest.h>

namespace vesicle::test
{
namespace
{

class OpenFileTest : public testing::Test
{
protected:
  OpenFileTest() { replace_file(file, "line 1\n"); }

  TemporaryFolder folder;
  const std::filesystem::path file = folder / "file.txt";
};

}

TEST_F(OpenFileTest, GrowsAndChangesInPlace)
{
  OpenFile open(file);
  open.append("line 2\n");
  open.write_at(5, "0");
  open.append("line 3\n");
  open.sync();
  EXPECT_EQ(read_file(file), "line 0\nline 2\nline 3\n");
}

TEST_F(OpenFileTest, MovesLikeAValue)
{
  OpenFile first(file);
  OpenFile open = std::move(first);
  open.append("line 2\n");
  EXPECT_EQ(read_file(file), "line 1\nline 2\n");
}

TEST_F(OpenFileTest, OnAFullDiskNothingIsHalfWritten)
{
  OpenFile open(file);
  {
    const FullDisk full(10);
    EXPECT_THROW(open.append("line 2\n"), IoError);
    EXPECT_EQ(read_file(file), "line 1\n");
  }
  open.append("line 3\n");
  EXPECT_EQ(read_file(file), "line 1\nline 3\n");
}

TEST_F(OpenFileTest, AFileRemovedMeanwhileIsAnError)
{
  OpenFile open(file);
  std::filesystem::remove(file);
  open.append("line 2\n");
  try
  {
    open.sync();
    FAIL();
  }
  catch (const IoError& error)
  {
    EXPECT_EQ(
      error.what(), file.string() + ": can't be written: it was removed while it was in use");
  }
}

TEST_F(OpenFileTest, OnlyWhatIsThereIsOpened)
{
  EXPECT_THROW(OpenFile(folder / "none"), IoError);
  EXPECT_THROW(OpenFile(folder.path()), IoError);
}

}
