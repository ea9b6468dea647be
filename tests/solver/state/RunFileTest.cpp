#include "TestRun.h"

#include "solver/Errors.h"
#include "solver/files/FileBytes.h"
#include "tests/solver/support/FullDisk.h"

#include <gtest/gtest.h>
#include <hdf5.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <random>

using namespace vesicle;
using namespace vesicle::testing_support;

namespace
{

class RunFileTest : public testing::Test
{
protected:
  void TearDown() override { std::filesystem::remove_all(folder); }

  std::filesystem::path folder =
    empty_folder(testing::UnitTest::GetInstance()->current_test_info()->name());
  std::filesystem::path file = folder / "run.h5";
};

template<class Work>
std::string io_error_of(const Work& work)
{
  try
  {
    work();
  }
  catch (const IoError& error)
  {
    return error.what();
  }
  return "no error";
}

bool has(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

/// All numbers of a dataset, read as anybody would; of a table those of a column, as `type` says.
std::vector<double> numbers_in(
  const std::filesystem::path& file, const std::string& dataset, hid_t type = H5T_NATIVE_DOUBLE)
{
  const hid_t f = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t d = H5Dopen2(f, dataset.c_str(), H5P_DEFAULT);
  const hid_t s = H5Dget_space(d);
  std::vector<double> numbers(static_cast<std::size_t>(H5Sget_simple_extent_npoints(s)));
  H5Dread(d, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data());
  H5Sclose(s);
  H5Dclose(d);
  H5Fclose(f);
  return numbers;
}

std::vector<double> column_in(const std::filesystem::path& file, const std::string& column)
{
  const hid_t field = H5Tcreate(H5T_COMPOUND, sizeof(double));
  H5Tinsert(field, column.c_str(), 0, H5T_NATIVE_DOUBLE);
  const auto numbers = numbers_in(file, "/series", field);
  H5Tclose(field);
  return numbers;
}

void expect_run(const RunFile& run, std::int64_t steps)
{
  const auto rows = run.series();
  ASSERT_EQ(rows.size(), static_cast<std::size_t>(steps));
  for (std::int64_t i = 0; i < steps; ++i)
  {
    EXPECT_EQ(rows[static_cast<std::size_t>(i)], row(i));
  }
  EXPECT_TRUE(same_bits(run.state(), state(steps - 1)));
}

}

TEST_F(RunFileTest, NewFileHasTheHeaderAndNothingElse)
{
  RunFile::create(file, header());
  const RunFile run = RunFile::open(file);
  EXPECT_EQ(run.header().scene, header().scene);
  EXPECT_EQ(run.header().triangles, header().triangles);
  EXPECT_EQ(run.header().length_scale, 1e-6);
  EXPECT_EQ(run.header().time_scale, 0.1);
  EXPECT_EQ(run.header().energy_scale, 1e-19);
  EXPECT_EQ(run.header().viscosity, 1e-3);
  EXPECT_EQ(run.header().columns, header().columns);
  EXPECT_TRUE(run.series().empty());
  EXPECT_TRUE(has(io_error_of([&] { run.state(); }), "holds no state yet"));
}

TEST_F(RunFileTest, StateAndSeriesComeBackBitForBit)
{
  {
    RunFile run = RunFile::create(file, header());
    for (int i = 0; i < 700; ++i) // beyond two enlargements
    {
      run.append(state(i), row(i));
    }
    expect_run(run, 700);
    run.close();
  }
  expect_run(RunFile::open(file), 700);
}

TEST_F(RunFileTest, GoesOnAfterReopening)
{
  RunFile::create(file, header());
  for (int i = 0; i < 5; ++i)
  {
    RunFile run = RunFile::open(file);
    run.append(state(2 * i), row(2 * i));
    run.append(state(2 * i + 1), row(2 * i + 1));
  }
  expect_run(RunFile::open(file), 10);
}

TEST_F(RunFileTest, EmptyArraysAndSpecialNumbers)
{
  State special = state(1);
  special.vesicles[0].tension.resize(0);
  special.vesicles[0].stiff_force.resize(0);
  special.preconditioner.points[0].resize(0, 3);
  special.vesicles[0].points(0, 0) = -0.0;
  special.vesicles[0].points(1, 0) = std::numeric_limits<double>::denorm_min();
  special.vesicles[0].points(2, 0) = std::numeric_limits<double>::max();
  special.controller.free_step = std::numeric_limits<double>::infinity();
  {
    RunFile run = RunFile::create(file, header());
    run.append(special, row(0));
  }
  EXPECT_TRUE(same_bits(RunFile::open(file).state(), special));
}

TEST_F(RunFileTest, StateMayChangeItsSize)
{
  State small = state(3, 12);
  small.vesicles[0].tension.resize(0);
  {
    RunFile run = RunFile::create(file, header());
    run.append(state(0), row(0));
    run.append(state(1), row(1));
    run.append(small, row(2));
    EXPECT_TRUE(same_bits(run.state(), small));
  }
  RunFile run = RunFile::open(file);
  EXPECT_TRUE(same_bits(run.state(), small));
  run.append(state(3), row(3));
  expect_run(run, 4);
}

TEST_F(RunFileTest, RefusesWhatIsNotFinite)
{
  RunFile run = RunFile::create(file, header());
  run.append(state(0), row(0));
  auto bad_row = row(1);
  bad_row[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(run.append(state(1), bad_row), NumericalError);
  State bad_state = state(1);
  bad_state.vesicles[1].velocity(3, 1) = std::numeric_limits<double>::infinity();
  EXPECT_THROW(run.append(bad_state, row(1)), NumericalError);
  EXPECT_THROW(run.append(state(1), { 1.0 }), IoError);
  expect_run(run, 1);
}

TEST_F(RunFileTest, OthersFindPlainDatasetsWithoutNaN)
{
  {
    RunFile run = RunFile::create(file, header());
    for (int i = 0; i < 4; ++i)
    {
      run.append(state(i), row(i));
    }
    run.close();
  }
  // A record a step and vesicle.
  EXPECT_EQ(column_in(file, "area"), (std::vector<double>{ -0., 0, -1, 2, -2, 4, -3, 6 }));
  const double missing = std::numeric_limits<double>::lowest();
  EXPECT_EQ(column_in(file, "inclination_deg"),
    (std::vector<double>{ missing, 0, 0.1, 0.2, 0.1 * 2, 0.2 * 2, missing, 0.2 * 3 }));
  EXPECT_EQ(numbers_in(file, "/committed"), std::vector<double>{ 4 });
  EXPECT_EQ(numbers_in(file, "/state/0/vesicle_1/points").size(), 42u * 3);
  EXPECT_EQ(numbers_in(file, "/triangles/vesicle_0").size(), 9u);
  for (const double number : numbers_in(file, "/state/1/vesicle_0/points"))
  {
    EXPECT_TRUE(std::isfinite(number));
  }
}

TEST_F(RunFileTest, EqualRunsGiveEqualFiles)
{
  for (const char* name : { "a.h5", "b.h5" })
  {
    RunFile run = RunFile::create(folder / name, header());
    run.append(state(0), row(0));
    run.close();
  }
  const auto bytes = [&](const char* name)
  {
    std::ifstream stream(folder / name, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(stream), {});
  };
  EXPECT_EQ(bytes("a.h5"), bytes("b.h5"));
}

TEST_F(RunFileTest, CreateReplacesAsAWhole)
{
  RunFile old = RunFile::create(file, header());
  old.append(state(0), row(0));
  RunFile::create(file, header());
  EXPECT_EQ(RunFile::open(file).rows(), 0u);
}

TEST_F(RunFileTest, CreateInPlacesThatCannotBeWritten)
{
  const auto error = [](const std::filesystem::path& path)
  { return io_error_of([&] { RunFile::create(path, header()); }); };
  EXPECT_TRUE(
    has(error(folder / "none/run.h5"), "run.h5: can't be written: No such file or directory"));
  std::ofstream(folder / "file") << "x";
  EXPECT_TRUE(has(error(folder / "file/run.h5"), "can't be written: Not a directory"));
  EXPECT_TRUE(has(error("/proc/run.h5"), "/proc/run.h5: can't be written: "));
  std::filesystem::permissions(
    folder, std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
  if (::geteuid() != 0) // root may write anywhere
  {
    EXPECT_TRUE(has(error(file), "can't be written: Permission denied"));
  }
  std::filesystem::permissions(folder, std::filesystem::perms::owner_all);
}

TEST_F(RunFileTest, OpenOfSomethingElse)
{
  const auto error = [](const std::filesystem::path& path)
  { return io_error_of([&] { RunFile::open(path); }); };
  EXPECT_THROW(RunFile::open(file), InputError);
  EXPECT_THROW(RunFile::open(folder), InputError);

  std::ofstream(file) << "not HDF5 at all, but long enough to hold a signature";
  EXPECT_EQ(error(file), file.string() + ": is not a run file");
  std::ofstream(file, std::ios::trunc) << "";
  EXPECT_EQ(error(file), file.string() + ": is not a run file");

  const hid_t foreign =
    H5Fcreate((folder / "foreign.h5").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  H5Fclose(foreign);
  EXPECT_TRUE(has(error(folder / "foreign.h5"),
    (folder / "foreign.h5").string() + ": is an HDF5 file but not a run file of this version"));
}

TEST_F(RunFileTest, OpenOfATruncatedFile)
{
  {
    RunFile run = RunFile::create(file, header());
    run.append(state(0), row(0));
  }
  const auto size = std::filesystem::file_size(file);
  for (const auto kept : { size - 1, size / 2, size / 10, std::uintmax_t{ 100 } })
  {
    std::filesystem::resize_file(file, kept);
    EXPECT_TRUE(has(io_error_of([&] { RunFile::open(file); }), file.string() + ": ")) << kept;
  }
}

TEST_F(RunFileTest, OpenLeavesTheFileAlone)
{
  RunFile::create(file, header()).append(state(0), row(0));
  const std::string before = read_file(file);
  RunFile run = RunFile::open(file);
  EXPECT_EQ(read_file(file), before);
  run.append(state(1), row(1));
  EXPECT_NE(read_file(file), before);
}

// As left by a killed program: with room for more rows, both commits, an older and a newer state.
class DamagedRunFile : public RunFileTest
{
protected:
  DamagedRunFile()
  {
    RunFile run = RunFile::create(file, header());
    for (int i = 0; i < static_cast<int>(rows); ++i)
    {
      run.append(state(i, 12), row(i));
    }
    bytes = read_file(file);
  }

  /// Refused, or read as what was committed last, or before.
  bool is_refused(const std::string& damaged) const
  {
    std::ofstream(file, std::ios::binary) << damaged; // not to the disk, which takes its time
    std::size_t rows_read = 0;
    try
    {
      const RunFile run = RunFile::open(file);
      rows_read = run.rows();
      EXPECT_TRUE(same_bits(run.state(), state(static_cast<int>(rows_read) - 1, 12)));
      EXPECT_EQ(run.series().back(), row(static_cast<int>(rows_read) - 1));
      EXPECT_EQ(run.header().scene, header().scene);
      EXPECT_EQ(run.header().triangles, header().triangles);
    }
    catch (const IoError& error)
    {
      EXPECT_TRUE(has(error.what(), file.string() + ": ")) << error.what();
      return true;
    }
    EXPECT_TRUE(rows_read == rows || rows_read == rows - 1) << rows_read;
    return false;
  }

  static constexpr std::size_t rows = 5;
  std::string bytes;
};

TEST_F(DamagedRunFile, NoFlippedBitIsReadAsAnotherNumber)
{
  constexpr std::size_t stride = 211; // bits; each place in a byte in turn
  std::size_t refused = 0, tried = 0;
  for (std::size_t bit = 0; bit < 8 * bytes.size(); bit += stride)
  {
    std::string damaged = bytes;
    damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << bit % 8));
    refused += is_refused(damaged);
    ++tried;
  }
  EXPECT_GT(refused, tried / 20);
}

TEST_F(DamagedRunFile, CutsZerosAndGarbageAreRefused)
{
  std::mt19937_64 random(1);
  for (std::size_t length = 0; length < bytes.size(); length += 997)
  {
    EXPECT_TRUE(is_refused(bytes.substr(0, length))) << length;
  }
  EXPECT_TRUE(is_refused(bytes + '\0'));
  for (std::size_t at = 0; at + 512 < bytes.size(); at += 1009)
  {
    std::string damaged = bytes;
    std::fill_n(damaged.begin() + static_cast<long>(at), 512, '\0');
    is_refused(damaged);
    std::generate_n(
      damaged.begin() + static_cast<long>(at), 512, [&] { return static_cast<char>(random()); });
    is_refused(damaged);
  }
}

TEST_F(RunFileTest, AFileRemovedMeanwhileIsAnError)
{
  RunFile run = RunFile::create(file, header());
  run.append(state(0), row(0));
  std::filesystem::remove(file);
  EXPECT_TRUE(has(io_error_of([&] { run.append(state(1), row(1)); }), "it was removed"));
}

TEST_F(RunFileTest, FullDiskHurtsNothingThatWasSaved)
{
  RunFile run = RunFile::create(file, header());
  for (int i = 0; i < 256; ++i)
  {
    run.append(state(i), row(i));
  }
  // The next row needs a larger file.
  std::string error;
  {
    const test::FullDisk full(std::filesystem::file_size(file));
    error = io_error_of([&] { run.append(state(256), row(256)); });
  }

  EXPECT_TRUE(has(error, "can't be written: ")) << error;
  EXPECT_FALSE(std::filesystem::exists(unfinished_name(file)));
  expect_run(run, 256);
  run.append(state(256), row(256));
  expect_run(run, 257);
}

TEST_F(RunFileTest, LinksStayLinks)
{
  std::filesystem::create_directory(folder / "disk");
  RunFile::create(folder / "disk/run.h5", header());
  std::filesystem::create_symlink("disk/run.h5", file);
  {
    RunFile run = RunFile::open(file);
    run.append(state(0), row(0));
  }
  EXPECT_TRUE(std::filesystem::is_symlink(file));
  expect_run(RunFile::open(folder / "disk/run.h5"), 1);
}

TEST_F(RunFileTest, MovesLikeAValue)
{
  RunFile run = RunFile::create(file, header());
  run.append(state(0), row(0));
  RunFile moved = std::move(run);
  moved.append(state(1), row(1));
  RunFile other = RunFile::create(folder / "other.h5", header());
  other = std::move(moved);
  expect_run(other, 2);
}
