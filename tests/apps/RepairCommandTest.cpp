#include "Command.h"

#include "solver/mesh/TriangleMesh.h"
#include "vtkfilters/Filters/MeshConversion.h"
#include "vtkfilters/Filters/MeshFiles.h"

#include "vtkAppendPolyData.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkReverseSense.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

namespace vesicle::test
{
namespace
{

using Json = nlohmann::json;

constexpr double pi = std::numbers::pi;

/// The isosurface of a ball's binary mask, in voxels: a staircase.
vtkSmartPointer<vtkPolyData> voxel_ball(double radius, const Vector3& centre)
{
  const int half = static_cast<int>(radius) + 3, size = 2 * half + 1;
  vtkNew<vtkImageData> mask;
  mask->SetDimensions(size, size, size);
  mask->SetOrigin(centre.x() - half, centre.y() - half, centre.z() - half);
  mask->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  for (int k = 0; k < size; ++k)
    for (int j = 0; j < size; ++j)
      for (int i = 0; i < size; ++i)
      {
        const Vector3 x(i - half, j - half, k - half);
        *static_cast<unsigned char*>(mask->GetScalarPointer(i, j, k)) = x.norm() < radius;
      }
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(mask);
  contour->SetValue(0, 0.5);
  contour->ComputeNormalsOff();
  contour->ComputeScalarsOff();
  contour->Update();
  return contour->GetOutput();
}

/// What a segmentation can be like: a ball whose halves z < 0 and z > 0 have points of their own
/// along the seam and of which a window is missing, a speck, and a second body inside out.
void write_segmentation(const std::filesystem::path& file, bool with_second_body)
{
  const TriangleMesh ball = to_mesh(voxel_ball(20, { 0, 0, 0 }));
  TriangleMesh halves[2]{ { ball.points, {} }, { ball.points, {} } };
  for (int t = 0; t < ball.triangles.rows(); ++t)
  {
    const auto [a, b, c] = corners(ball, t);
    const Vector3 middle = (a + b + c) / 3;
    if (middle.x() > 0 && std::hypot(middle.y(), middle.z() - 6) < 3)
      continue; // the window
    Triangles& half = halves[middle.z() > 0].triangles;
    half.conservativeResize(half.rows() + 1, 3);
    half.row(half.rows() - 1) = ball.triangles.row(t);
  }
  vtkNew<vtkAppendPolyData> all;
  for (const TriangleMesh& half : halves)
    all->AddInputData(to_polydata(half));
  all->AddInputData(voxel_ball(1.5, { 30, 0, 0 }));
  vtkNew<vtkReverseSense> turned;
  turned->SetInputData(voxel_ball(12, { 0, 40, 0 }));
  turned->Update();
  if (with_second_body)
    all->AddInputData(turned->GetOutput());
  all->Update();
  write_mesh(all->GetOutput(), file);
}

Json info(const TemporaryFolder& folder, const std::string& file)
{
  const auto outcome = vesicle_command(folder.path(), { "info", file, "--json" });
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  return Json::parse(outcome.output);
}

void expect_start_mesh(const Json& report)
{
  EXPECT_EQ(report["closed"], true);
  EXPECT_EQ(report["oriented"], true);
  EXPECT_EQ(report["manifold"], true);
  EXPECT_EQ(report["genus"], 0);
  EXPECT_TRUE(report["self_crossing"].is_null());
}

}

TEST(Repair, MakesAStartMeshOfASegmentation)
{
  const TemporaryFolder folder;
  write_segmentation(folder / "mask.vtp", true);
  EXPECT_EQ(info(folder, "mask.vtp")["closed"], false);
  auto outcome = vesicle_command(folder.path(),
    { "repair", "mask.vtp", "--smooth", "20", "--triangles", "1280", "--json", "-o", "both.vtu" });
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  const Json report = Json::parse(outcome.output);
  EXPECT_EQ(report["changed"], true);
  EXPECT_GT(report["merged_points"], 0);
  EXPECT_EQ(report["filled_holes"], 1);
  EXPECT_EQ(report["scraps"], 1);
  EXPECT_GT(report["turned_triangles"], 0);
  EXPECT_EQ(report["open_holes"], 0);
  const Json two = info(folder, "both.vtu");
  expect_start_mesh(two);
  EXPECT_EQ(two["components"], 2);
  EXPECT_GT(two["volume"].get<double>(), 0);

  outcome = vesicle_command(folder.path(),
    { "repair", "mask.vtp", "--smooth", "20", "--triangles", "1280", "--largest", "-o",
      "start.vtu" });
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_NE(outcome.output.find("1 hole filled"), std::string::npos) << outcome.output;
  EXPECT_NE(outcome.output.find("before"), std::string::npos);
  const Json one = info(folder, "start.vtu");
  expect_start_mesh(one);
  EXPECT_EQ(one["components"], 1);
  EXPECT_EQ(one["triangles"], 1280);
  // A mask's surface is off by half a voxel at most, of 20, that is 7.5% of the volume and 5% of
  // the area, if it were all on one side; what smoothing leaves of the staircase adds to the area.
  EXPECT_NEAR(one["volume"].get<double>() / (4. / 3 * pi * 8000), 1, 0.075);
  EXPECT_NEAR(one["area"].get<double>() / (4 * pi * 400), 1, 0.05);
  // And it starts a simulation.
  std::ofstream(folder / "cell.toml") << R"(
[vesicle]
file = "start.vtu"
radius = 1
[membrane]
bending_rigidity = 1
[time]
end = 1
output_every = 1
)";
  outcome = vesicle_command(folder.path(), { "check", "cell.toml" });
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
}

TEST(Repair, ACleanMeshPassesThroughUnchanged)
{
  const TemporaryFolder folder;
  ASSERT_EQ(vesicle_command(folder.path(), { "shape", "sphere", "-o", "clean.vtp" }).code, 0);
  ASSERT_EQ(
    vesicle_command(folder.path(), { "curvature", "clean.vtp", "-o", "arrays.vtp" }).code, 0);
  // What is read of a file knows no units any more.
  ASSERT_EQ(vesicle_command(folder.path(), { "convert", "arrays.vtp", "-o", "read.vtp" }).code, 0);
  const auto outcome =
    vesicle_command(folder.path(), { "repair", "read.vtp", "-o", "repaired.vtp" });
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_NE(outcome.output.find("nothing to repair"), std::string::npos) << outcome.output;
  EXPECT_TRUE(bytes_of(folder / "repaired.vtp") == bytes_of(folder / "read.vtp"));
}

TEST(Repair, TellsWhatCantBeRepaired)
{
  const TemporaryFolder folder;
  std::ofstream(folder / "dot.off") << "OFF\n3 1 0\n0 0 0\n0 0 0\n0 0 0\n3 0 1 2\n";
  const auto outcome = vesicle_command(folder.path(), { "repair", "dot.off", "-o", "out.off" });
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.errors.find("dot.off: all points coincide"), std::string::npos)
    << outcome.errors;
  expect_usage_errors(folder.path(),
    { { "repair", "dot.off" }, { "repair", "dot.off", "-o", "out.xyz" },
      { "repair", "none.off", "-o", "out.off" },
      { "repair", "dot.off", "-o", "out.off", "--holes", "-1" } });
}

}
