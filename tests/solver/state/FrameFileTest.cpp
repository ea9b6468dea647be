#include "solver/state/FrameFile.h"

#include "TestRun.h"

#include "solver/Errors.h"
#include "solver/mesh/shapes/GeodesicSphere.h"

#include <gtest/gtest.h>
#include <hdf5.h>

#include <fstream>

using namespace vesicle;
using namespace vesicle::testing_support;

namespace
{

class FrameFile : public testing::Test
{
protected:
  ~FrameFile() override { std::filesystem::remove_all(folder); }

  /// All numbers of a dataset, read as anybody would.
  template<class Number>
  std::vector<Number> numbers_in(const std::string& dataset, hid_t type) const
  {
    const hid_t f = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    const hid_t d = H5Dopen2(f, dataset.c_str(), H5P_DEFAULT);
    const hid_t s = H5Dget_space(d);
    std::vector<Number> numbers(static_cast<std::size_t>(H5Sget_simple_extent_npoints(s)));
    H5Dread(d, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data());
    H5Sclose(s);
    H5Dclose(d);
    H5Fclose(f);
    return numbers;
  }

  void write(const Frame& frame) const
  {
    std::ofstream(file, std::ios::binary) << frame_file_image(frame);
  }

  const std::filesystem::path folder = empty_folder("frame-file");
  const std::filesystem::path file = folder / "frame.h5";
};

Frame frame()
{
  Frame frame{ 0.3, geodesic_sphere(2), {}, {}, {} };
  FrameArray::Values pairs(frame.mesh.triangles.rows(), 2);
  pairs.col(0).setLinSpaced(0, 1);
  pairs.col(1).setLinSpaced(-3, 7);
  frame.point_data = { { "Velocity", frame.mesh.points }, { "Height", frame.mesh.points.col(2) } };
  frame.cell_data = { { "Pairs", pairs } };
  frame.field_data = { { "TimeValue", FrameArray::Values::Constant(1, 1, 0.3) } };
  return frame;
}

template<class Matrix>
std::vector<typename Matrix::Scalar> numbers_of(const Matrix& matrix)
{
  return { matrix.data(), matrix.data() + matrix.size() };
}

}

TEST_F(FrameFile, HoldsEverythingBitForBit)
{
  const Frame written = frame();
  write(written);
  const auto doubles = [&](const char* dataset)
  { return numbers_in<double>(dataset, H5T_NATIVE_DOUBLE); };
  EXPECT_EQ(doubles("/points"), numbers_of(written.mesh.points));
  EXPECT_EQ(numbers_in<int>("/triangles", H5T_NATIVE_INT), numbers_of(written.mesh.triangles));
  for (const FrameArray& array : written.point_data)
  {
    EXPECT_EQ(doubles(("/point_data/" + array.name).c_str()), numbers_of(array.values));
  }
  EXPECT_EQ(doubles("/cell_data/Pairs"), numbers_of(written.cell_data[0].values));
  EXPECT_EQ(doubles("/field_data/TimeValue"), std::vector<double>{ 0.3 });
}

TEST_F(FrameFile, TheLayoutReadIsTheOneWritten)
{
  write(frame());
  const FrameLayout written = layout_of(frame()), read = read_frame_layout(file);
  EXPECT_EQ(read.points, 42);
  EXPECT_EQ(read.triangles, 80);
  const auto expect_same = [](const auto& a, const auto& b)
  {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i)
    {
      EXPECT_EQ(a[i].name, b[i].name);
      EXPECT_EQ(a[i].components, b[i].components);
    }
  };
  expect_same(read.point_data, written.point_data);
  expect_same(read.cell_data, written.cell_data);
  ASSERT_EQ(read.point_data.size(), 2u);
  EXPECT_EQ(read.point_data[0].name, "Height"); // alphabetical
  EXPECT_EQ(read.point_data[0].components, 1);
  EXPECT_EQ(read.cell_data[0].components, 2);
}

TEST_F(FrameFile, EqualFramesGiveEqualBytesAndLittleMoreThanTheirNumbers)
{
  EXPECT_TRUE(frame_file_image(frame()) == frame_file_image(frame()));
  Frame large{ 0, geodesic_sphere(8), {}, {}, {} };
  for (const char* name : { "a", "b", "c", "d", "e", "f", "g", "h" })
  {
    large.point_data.push_back({ name, FrameArray::Values::Random(large.mesh.points.rows(), 3) });
  }
  const std::size_t numbers = 9 * 8 * static_cast<std::size_t>(large.mesh.points.size());
  EXPECT_LT(frame_file_image(large).size(), numbers + numbers / 10);
}

TEST_F(FrameFile, AnEmptySurfaceIsAFrameToo)
{
  write(Frame{ 0, { Points(0, 3), Triangles(0, 3) }, { { "Height", {} } }, {}, {} });
  EXPECT_EQ(read_frame_layout(file).points, 0);
}

TEST_F(FrameFile, SomethingElseIsNamed)
{
  std::ofstream(file) << "not HDF5";
  try
  {
    read_frame_layout(file);
    FAIL();
  }
  catch (const IoError& error)
  {
    EXPECT_TRUE(std::string(error.what()).starts_with(file.string())) << error.what();
  }
}
