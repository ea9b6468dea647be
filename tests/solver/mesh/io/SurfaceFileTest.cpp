// What holds for the files of all formats.

#include "solver/Errors.h"
#include "solver/mesh/MeshIntegrals.h"
#include "solver/mesh/Topology.h"
#include "tests/solver/mesh/io/SampleFiles.h"
#include "tests/support/Damage.h"

#include <gtest/gtest.h>

#include <clocale>
#include <random>

namespace vesicle::test
{
namespace
{

class SurfaceFiles : public testing::TestWithParam<SampleFile>
{
};

/// What is left of an outcome: the number of triangles, −1 if the file was refused or has none,
/// which MeshFiles refuses.
Eigen::Index triangles_of(const SampleFile& sample, std::string_view bytes)
{
  try
  {
    const TriangleMesh mesh = mesh_of(sample.read(bytes, sample.name), sample.name);
    EXPECT_TRUE(mesh.points.allFinite());
    EXPECT_TRUE((mesh.triangles.array() >= 0).all());
    EXPECT_TRUE((mesh.triangles.array() < mesh.points.rows()).all());
    return mesh.triangles.rows() > 0 ? mesh.triangles.rows() : -1;
  }
  catch (const InputError& error)
  {
    EXPECT_NE(std::string(error.what()).find(sample.name), std::string::npos) << error.what();
    return -1;
  }
}

void expect_l_prism(const SampleFile& sample)
{
  const TriangleMesh mesh = mesh_of(sample.read(sample.bytes, sample.name));
  EXPECT_NEAR(flat_area(mesh), 14, 1e-14);
  EXPECT_NEAR(flat_volume(mesh), 3, 1e-14);
  EXPECT_TRUE(topology(mesh).closed);
}

}

TEST_P(SurfaceFiles, ConcavePolygonsKeepTheirArea)
{
  expect_l_prism(GetParam());
}

TEST_P(SurfaceFiles, AreTheSameWhereTheLocaleHasADecimalComma)
{
  const std::string before = std::setlocale(LC_ALL, nullptr);
  const bool there = std::setlocale(LC_ALL, "de_DE.UTF-8") ||
    std::setlocale(LC_ALL, "de_DE.utf8") || std::setlocale(LC_ALL, "fr_FR.UTF-8");
  if (!there)
    GTEST_SKIP() << "no locale with a decimal comma is installed";
  expect_l_prism(GetParam());
  std::setlocale(LC_ALL, before.c_str());
}

// OBJ files have neither counts nor an end, so that a part of one may be a file.
TEST_P(SurfaceFiles, ThatEndEarlyAreNeverASmallerMesh)
{
  const SampleFile& sample = GetParam();
  const Eigen::Index all = triangles_of(sample, sample.bytes);
  for (std::size_t bytes = 0; bytes < sample.bytes.size(); ++bytes)
  {
    const Eigen::Index part = triangles_of(sample, sample.bytes.substr(0, bytes));
    EXPECT_TRUE(part == -1 || part == all || sample.name.ends_with(".obj"))
      << bytes << " of " << sample.bytes.size() << " bytes";
  }
}

TEST_P(SurfaceFiles, DamagedAreRefusedOrAMesh)
{
  const SampleFile& sample = GetParam();
  std::mt19937 random(1);
  for (int round = 0; round < 4000; ++round)
  {
    triangles_of(sample, damaged(sample.bytes, 1 + round % 4, random));
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, SurfaceFiles, testing::ValuesIn(sample_files()),
  [](const auto& sample)
  {
    std::string name = sample.param.name;
    name[name.find('.')] = '_';
    return name;
  });

}
