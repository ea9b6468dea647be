// Other programs read what a run leaves behind.

#include "Command.h"

#include <gtest/gtest.h>

namespace vesicle::test
{
namespace
{

constexpr int module_missing = 77;

/// Runs the script beside a finished run.
Outcome read_with_python(const std::string& script)
{
  const TemporaryFolder folder;
  write_scene_file(folder.path());
  const auto run = vesicle_command(
    folder.path(), { "run", "pear.toml", "--no-movie", "--quiet", "--set", "time.end=0.2" });
  EXPECT_EQ(run.code, 0) << run.errors;
  EXPECT_EQ(run.output, "");
  return python(folder.path(), script);
}

}

TEST(Meshio, ReadsEveryFrame)
{
  const auto outcome = read_with_python(R"(
import sys, glob
try:
    import meshio
except ImportError:
    sys.exit(77)
files = sorted(glob.glob('pear/frames/*.vtu'))
assert len(files) == 3, files
for i, file in enumerate(files):
    mesh = meshio.read(file)
    assert mesh.points.dtype == 'float64' and len(mesh.points) == 42
    assert len(mesh.cells_dict['triangle']) == 80
    assert mesh.point_data['Velocity'].shape == (42, 3)
    assert abs(mesh.field_data['TimeValue'][0] - 0.1 * i) < 1e-12 if 'TimeValue' in mesh.field_data else True
)");
  if (outcome.code == module_missing)
  {
    GTEST_SKIP() << "no meshio";
  }
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
}

TEST(H5py, ReadsTheRunFile)
{
  const auto outcome = read_with_python(R"(
import sys, csv
try:
    import h5py
except ImportError:
    sys.exit(77)
rows = list(csv.DictReader(open('pear/pear.csv')))
with h5py.File('pear/pear.h5', 'r') as run:
    assert run['triangles'].shape == (80, 3)
    time = run['series/time'][:]
    assert len(time) == len(rows), (len(time), len(rows))
    assert all(float(row['time']) == t for row, t in zip(rows, time))
    assert run.attrs['length_scale'] > 0
)");
  if (outcome.code == module_missing)
  {
    GTEST_SKIP() << "no h5py";
  }
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
}

}
