#include "solver/mesh/io/OffFile.h"

#include "solver/mesh/MeshIntegrals.h"
#include "tests/solver/mesh/io/SampleFiles.h"

#include <gmock/gmock.h>

namespace vesicle::test
{
namespace
{

using testing::HasSubstr;

double area_of(const std::string& text)
{
  return flat_area(mesh_of(read_off(text, "mesh.off")));
}

}

TEST(OffFile, ReadsCommentsPolygonsAndColours)
{
  EXPECT_DOUBLE_EQ(area_of("# a square\nOFF\n4 1 4\n0 0 0\n1 0 0 # corner\n1 1 0\n0 1 0\n"
                           "4 0 1 2 3 255 0 0\n"),
    1);
}

TEST(OffFile, ReadsItsDialects)
{
  const auto sample = [](const char* keyword, const char* after)
  { return off_sample(l_prism_points(), l_prism_faces(), keyword, after); };
  for (const auto& text : { sample("COFF", " 255 0 0 255"), sample("COFF", " 0.5 0 0"),
         sample("NOFF", " 0 0 1"), sample("CNOFF", " 1 0 0 1 0 0 1"), sample("STOFF", " 0.5 0.5"),
         sample("STCNOFF", " 0 1 1 1 1 1 0 0 1"), sample("OFF", " 12 13 14"),
         sample("\xef\xbb\xbfOFF", "") })
    EXPECT_NEAR(area_of(text), 14, 1e-14) << text.substr(0, 8);
  EXPECT_DOUBLE_EQ(area_of("OFF 3 1\n0 0 0 1 0 0 0 1 0 3 0 1 2"), 0.5) << "all on one line";
  EXPECT_DOUBLE_EQ(
    area_of("OFF\r\n3 1 0\r\n0\r\n0\r\n0\r\n1\r\n0\r\n0\r\n0 1 0\r\n3\r\n0 1 2\r\n"), 0.5)
    << "free-form";
  EXPECT_DOUBLE_EQ(
    area_of("COFF\n3 1 0\n0 0\n0 1 1 1 1 1\n0 0 1 1 1 1\n0 1 0 1 1 1 1\n3 0 1 2"), 0.5)
    << "free-form with colours";
  EXPECT_DOUBLE_EQ(area_of("3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), 0.5) << "without its keyword";
}

TEST(OffFile, SaysWhatItCantRead)
{
  EXPECT_THAT(message_of(read_off, "OFF BINARY\n"), HasSubstr("binary"));
  EXPECT_THAT(message_of(read_off, "4OFF\n3 1 0\n"), HasSubstr("three coordinates"));
  EXPECT_THAT(message_of(read_off, "nOFF 5\n3 1 0\n"), HasSubstr("three coordinates"));
  EXPECT_THAT(message_of(read_off, "OFFSIDE\n3 1 0\n"), HasSubstr("first word"));
  EXPECT_THAT(message_of(read_off, "OFF\n3 1 0\n0 0 0\n1 x 0\n0 1 0\n3 0 1 2\n"),
    HasSubstr("mesh:4: 'x' stands where a coordinate should be"));
  EXPECT_THAT(message_of(read_off, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n"),
    HasSubstr("face 0 uses point 7, but the points are numbered 0 to 2"));
  EXPECT_THAT(message_of(read_off, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 nan 0\n3 0 1 2\n"),
    HasSubstr("point 2 is (0, nan, 0): coordinates must be finite"));
  EXPECT_THAT(message_of(read_off, "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"),
    HasSubstr("ends too early"));
  EXPECT_THAT(message_of(read_off, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 2\n"),
    HasSubstr("more than the 1 faces"));
  EXPECT_THAT(message_of(read_off, "OFF\n4000000000 1 0\n"), HasSubstr("ends too early"));
}

}
