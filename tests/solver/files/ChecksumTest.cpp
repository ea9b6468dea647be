#include "solver/files/Checksum.h"

#include <gtest/gtest.h>

#include <string>

namespace vesicle::test
{

TEST(Checksum, IsTheStandardOne)
{
  // The check value of CRC-64/XZ in the catalogue of parametrised CRC algorithms.
  EXPECT_EQ(checksum("123456789"), 0x995DC9BBDF1939FA);
  EXPECT_EQ(checksum(""), 0u);
}

TEST(Checksum, GoesOnFromPieces)
{
  EXPECT_EQ(checksum("6789", checksum("12345")), checksum("123456789"));
}

TEST(Checksum, NoBitFlipGoesUnnoticed)
{
  const std::string bytes(1000, '\0');
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit)
  {
    std::string flipped = bytes;
    flipped[bit / 8] = static_cast<char>(1 << bit % 8);
    EXPECT_NE(checksum(flipped), checksum(bytes)) << bit;
  }
}

}
