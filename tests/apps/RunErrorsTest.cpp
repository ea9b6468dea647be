#include "Command.h"
#include "RunFiles.h"

#include "vtkfilters/Filters/MeshConversion.h"
#include "vtkfilters/Filters/MeshFiles.h"
#include "vtkfilters/Filters/SeriesFile.h"
#include "solver/mesh/shapes/GeodesicSphere.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <fstream>

#include <unistd.h>

namespace vesicle::test
{
namespace
{

class RunErrors : public testing::Test
{
protected:
  RunErrors() { write_scene_file(folder.path()); }

  Outcome run(std::vector<std::string> extra) const
  {
    extra.insert(extra.begin(), { "run", "pear.toml", "--no-movie", "--no-plots" });
    return vesicle_command(folder.path(), extra);
  }
  Outcome run_with_mesh(const TriangleMesh& mesh) const
  {
    write_mesh(to_polydata(mesh), folder / "mesh.off");
    std::ofstream(folder / "mesh.toml") << "name = \"mesh\"\n[vesicle]\nfile = \"mesh.off\"\n"
                                           "[membrane]\nbending_rigidity = 1.0\n"
                                           "[time]\nend = 0.02\noutput_every = 0.01\n";
    return vesicle_command(folder.path(), { "run", "mesh.toml", "--no-movie", "--no-plots" });
  }
  bool nothing_written(const std::string& name = "pear") const
  {
    return !std::filesystem::exists(folder / name);
  }

  TemporaryFolder folder;
};

void expect_mentions(const Outcome& outcome, const std::string& text)
{
  EXPECT_NE(outcome.errors.find(text), std::string::npos) << outcome.errors;
}

}

TEST_F(RunErrors, MissingScene)
{
  const auto outcome = vesicle_command(folder.path(), { "run", "none.toml" });
  EXPECT_EQ(outcome.code, 2);
  expect_mentions(outcome, "none.toml");
}

TEST_F(RunErrors, NamesThatTheSystemDoesNotTakeAreMissingFiles)
{
  std::filesystem::create_symlink("round.toml", folder / "round.toml");
  std::filesystem::create_symlink("round.vtu", folder / "round.vtu");
  std::ofstream(folder / "round.pvtu")
    << "<VTKFile type=\"PUnstructuredGrid\"><PUnstructuredGrid>"
       "<Piece Source=\"round.vtu\"/></PUnstructuredGrid></VTKFile>";
  const std::string too_long(300, 'a');
  const std::vector<std::vector<std::string>> commands{ { "run", too_long + ".toml" },
    { "run", "round.toml" }, { "info", too_long + ".vtu" }, { "info", "round.vtu" },
    { "info", "round.pvtu" } };
  for (const auto& arguments : commands)
  {
    const auto outcome = vesicle_command(folder.path(), arguments);
    EXPECT_EQ(outcome.code, 2) << outcome.errors;
    EXPECT_EQ(outcome.errors.find("filesystem"), std::string::npos) << outcome.errors;
  }
}

TEST_F(RunErrors, UnknownKeyNamesTheNearest)
{
  const auto outcome = run({ "--set", "fluid.viscocity=2" });
  EXPECT_EQ(outcome.code, 2);
  expect_mentions(outcome, "viscosity");
  EXPECT_TRUE(nothing_written());
}

TEST_F(RunErrors, UnknownCommandNamesTheNearest)
{
  const auto outcome = vesicle_command(folder.path(), { "rum", "pear.toml" });
  EXPECT_EQ(outcome.code, 2);
  expect_mentions(outcome, "no command 'rum', did you mean 'run'?");
}

TEST_F(RunErrors, UnknownMovieColourIsToldBeforeTheRun)
{
  const auto outcome =
    vesicle_command(folder.path(), { "run", "pear.toml", "--set", "movie.color=Beauty" });
  EXPECT_EQ(outcome.code, 2);
  EXPECT_TRUE(nothing_written());
}

TEST_F(RunErrors, WhatTheMovieNeedsIsToldBeforeTheRun)
{
  for (const auto& [key, array] : { std::pair("movie.flow_lines=true", "Membrane_Force"),
         std::pair("movie.markers=20", "Velocity"), std::pair("movie.arrows=true", "Velocity") })
  {
    const auto outcome = vesicle_command(folder.path(),
      { "run", "pear.toml", "--set", key, "--set", "output.fields=['Mean_Curvature']" });
    EXPECT_EQ(outcome.code, 2);
    expect_mentions(outcome, array);
    EXPECT_TRUE(nothing_written());
  }
}

TEST_F(RunErrors, MissingMesh)
{
  std::ofstream(folder / "mesh.toml")
    << "name = \"mesh\"\n[vesicle]\nfile = \"none.off\"\n"
       "[membrane]\nbending_rigidity = 1.0\n[time]\nend = 0.02\noutput_every = 0.01\n";
  const auto outcome = vesicle_command(folder.path(), { "run", "mesh.toml" });
  EXPECT_EQ(outcome.code, 2);
  expect_mentions(outcome, "none.off");
}

TEST_F(RunErrors, GoodMeshRuns)
{
  const auto outcome = run_with_mesh(geodesic_sphere(2));
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
}

TEST_F(RunErrors, OpenMesh)
{
  TriangleMesh mesh = geodesic_sphere(2);
  mesh.triangles.conservativeResize(mesh.triangles.rows() - 1, 3);
  const auto outcome = run_with_mesh(mesh);
  EXPECT_EQ(outcome.code, 2);
  expect_mentions(outcome, "mesh.off");
  EXPECT_TRUE(nothing_written("mesh"));
}

TEST_F(RunErrors, TornMesh)
{
  // Every triangle has points of its own.
  const TriangleMesh whole = geodesic_sphere(2);
  TriangleMesh torn{ Points(3 * whole.triangles.rows(), 3), whole.triangles };
  for (Eigen::Index t = 0; t < whole.triangles.rows(); ++t)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      torn.points.row(3 * t + corner) = whole.points.row(whole.triangles(t, corner));
      torn.triangles(t, corner) = static_cast<int>(3 * t + corner);
    }
  }
  const auto outcome = run_with_mesh(torn);
  EXPECT_EQ(outcome.code, 2);
  expect_mentions(outcome, "mesh.off");
}

TEST_F(RunErrors, FolderThatCantBeWritten)
{
  std::ofstream(folder / "file") << "in the way";
  for (const char* output : { "file/run", "/proc/vesicle" })
  {
    const auto outcome = run({ "-o", output });
    EXPECT_EQ(outcome.code, 4) << output;
    expect_mentions(outcome, output);
  }
}

TEST_F(RunErrors, FailedRunKeepsItsLastGoodState)
{
  const auto outcome = run({ "--set", "time.step=50.0", "--set", "time.output_every=50.0", "--set",
    "time.end=100.0", "--set", "flow.rate=30.0" });
  EXPECT_EQ(outcome.code, 3) << outcome.output;
  expect_mentions(outcome, "saved in");
  EXPECT_GE(read_series(folder / "pear/pear.pvd").size(), 1u);
  EXPECT_NE(bytes_of(folder / "pear/summary.json").find("\"failed\""), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(folder / "pear/pear.h5"));
  expect_mentions(outcome, "last frame of pear/pear.pvd");
}

TEST_F(RunErrors, FailedRunLeavesWhatTellsWhy)
{
  const std::vector<std::string> too_long{ "--set", "time.step=50.0", "--set",
    "time.output_every=50.0", "--set", "time.end=100.0", "--set", "flow.rate=30.0" };
  const auto outcome = run(too_long);
  EXPECT_EQ(outcome.code, 3) << outcome.output;
  const auto stopped = folder / "pear" / "stopped";
  expect_mentions(outcome, "Take time.step = \"auto\"");
  EXPECT_NE(bytes_of(stopped / "advice.txt").find("Take time.step = \"auto\""), std::string::npos);
  EXPECT_EQ(read_mesh(stopped / "good.vtu")->GetNumberOfPolys(), 80);
  const auto failing = read_mesh(stopped / "failing.vtu");
  ASSERT_EQ(failing->GetNumberOfPolys(), 80);
  auto* guilty = failing->GetCellData()->GetArray("Guilty");
  ASSERT_NE(guilty, nullptr);
  EXPECT_EQ(guilty->GetRange()[1], 1);
  EXPECT_NE(bytes_of(stopped / "diagnostics.csv").find("energy_over_8pi"), std::string::npos);
  // The scene stops again where it is run.
  EXPECT_EQ(vesicle_command(stopped, { "run", "scene.toml", "--no-movie", "--no-plots" }).code, 3);

  // Another run takes it away.
  std::filesystem::remove_all(stopped / "pear");
  for (const char* file : { "stdout.txt", "stderr.txt" })
    std::filesystem::remove(stopped / file);
  EXPECT_EQ(run({ "--overwrite", "--set", "time.end=0.1" }).code, 0);
  EXPECT_FALSE(std::filesystem::exists(stopped));
}

// A tether that 80 triangles can't hold: told once, while the run goes on.
TEST_F(RunErrors, TellsThatTheMeshNoLongerHoldsTheShape)
{
  const auto outcome =
    run({ "--set", "vesicle.axis=[0, 0, 1]", "--set", "vesicle.reduced_volume=0.8", "--set",
      "gravity.bond_number=500", "--set", "time.end=0.03", "--set", "time.output_every=0.01" });
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  const std::string told = "80 triangles don't hold the shape, and a smaller step can't help";
  const auto first = outcome.errors.find(told);
  ASSERT_NE(first, std::string::npos) << outcome.errors;
  EXPECT_EQ(outcome.errors.find(told, first + 1), std::string::npos) << outcome.errors;
}

TEST_F(RunErrors, WithoutAGoodStateTheStartShapeIsLeftToLookAt)
{
  // Starts that can't be solved, or told in numbers.
  for (const char* rigidity : { "1e200", "1e300" })
  {
    const std::string setting = std::string("membrane.bending_rigidity=") + rigidity;
    for (const char* way : { "--overwrite", "--resume" })
    {
      const auto outcome = run({ "--set", setting, way });
      EXPECT_EQ(outcome.code, 3) << outcome.errors;
      expect_mentions(outcome, "t = 0: ");
      expect_mentions(outcome, "the start shape is in pear/pear.pvd");
      const auto frames = read_series(folder / "pear/pear.pvd");
      ASSERT_EQ(frames.size(), 1u);
      EXPECT_EQ(read_mesh(frames[0].file)->GetNumberOfPolys(), 80);
      const auto summary = bytes_of(folder / "pear/summary.json");
      EXPECT_NE(summary.find("\"failed\""), std::string::npos);
      EXPECT_EQ(summary.find("nan"), std::string::npos);
    }
    // There is nothing to go on from: it begins at the beginning.
    const auto again =
      run({ "--resume", "--set", "accuracy.preset=fast", "--set", "time.end=0.1" });
    EXPECT_EQ(again.code, 0) << again.errors;
    EXPECT_EQ(read_series(folder / "pear/pear.pvd").size(), 2u);
  }
}

TEST_F(RunErrors, AFolderThatGoesWhileARunIsUnderWayIsAnError)
{
  for (const char* way : { "moved", "removed" })
  {
    Command run(VESICLE_COMMAND, folder.path(),
      { "run", "pear.toml", "-o", "gone", "--no-movie", "--no-plots", "--set", "time.end=5.0" });
    while (run.running() && !std::filesystem::exists(folder / "gone/frames/pear_000001.h5"))
    {
      usleep(1000);
    }
    run.signal(SIGSTOP);
    std::filesystem::rename(folder / "gone", folder / "moved");
    if (std::string(way) == "removed")
    {
      std::filesystem::remove_all(folder / "moved");
    }
    run.signal(SIGCONT);
    EXPECT_EQ(run.wait(), 4) << way;
    EXPECT_NE(bytes_of(folder / "stderr.txt").find("gone/"), std::string::npos) << way;
    EXPECT_FALSE(std::filesystem::exists(folder / "gone")) << way;
    std::filesystem::remove_all(folder / "moved");
  }
}

// A picture that can't be written is told, and loses none of the others.
TEST_F(RunErrors, AFileInThePlaceOfThePlotsLosesNoMovie)
{
  std::filesystem::create_directory(folder / "pear");
  std::ofstream(folder / "pear/plots") << "in the way";
  const auto outcome = vesicle_command(folder.path(),
    { "run", "pear.toml", "--set", "accuracy.preset=fast", "--set", "time.end=0.1" });
  if (!draws(folder / "pear"))
  {
    GTEST_SKIP() << "nothing can draw here";
  }
  EXPECT_EQ(outcome.code, 4);
  expect_mentions(outcome, "pear/plots");
  EXPECT_TRUE(std::filesystem::exists(folder / "pear/movie/frame_000001.png"));
}

TEST_F(RunErrors, APlotThatCannotBeWrittenLosesNoOther)
{
  ASSERT_EQ(run({ "--set", "accuracy.preset=fast", "--set", "time.end=0.1" }).code, 0);
  std::filesystem::create_directories(folder / "pear/plots/energy.png/in the way");
  const auto outcome = vesicle_command(folder.path(),
    { "run", "pear.toml", "--resume", "--set", "accuracy.preset=fast", "--set", "time.end=0.2" });
  if (!draws(folder / "pear"))
  {
    GTEST_SKIP() << "nothing can draw here";
  }
  EXPECT_EQ(outcome.code, 4);
  expect_mentions(outcome, "pear/plots/energy.png");
  for (const char* file : { "plots/axes.png", "plots/step.png", "movie/frame_000002.png" })
  {
    EXPECT_TRUE(std::filesystem::exists(folder / "pear" / file)) << file;
  }
}

TEST_F(RunErrors, NamesThatAreNotUtf8AreNoReasonToFail)
{
  const auto odd = folder / "\xe9t\xe9";
  std::filesystem::create_directory(odd);
  std::filesystem::copy(folder / "pear.toml", odd / "pear.toml");
  const auto outcome = vesicle_command(folder.path(),
    { "run", (odd / "pear.toml").string(), "-o", "\xe9", "--no-movie", "--no-plots", "--set",
      "accuracy.preset=fast", "--set", "time.end=0.1" });
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_TRUE(std::filesystem::exists(folder / "\xe9/summary.json"));
  EXPECT_EQ(vesicle_command(folder.path(), { "info", "\xe9/pear.pvd", "--json" }).code, 0);
}

TEST_F(RunErrors, WithNothingToDrawWithARunIsDone)
{
  const char* const before = std::getenv("VESICLE_RENDER_BACKEND");
  const std::string kept = before ? before : "";
  setenv("VESICLE_RENDER_BACKEND", "none", 1);
  const auto outcome = vesicle_command(folder.path(),
    { "run", "pear.toml", "--set", "accuracy.preset=fast", "--set", "time.end=0.1" });
  before ? setenv("VESICLE_RENDER_BACKEND", kept.c_str(), 1) : unsetenv("VESICLE_RENDER_BACKEND");
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_NE(outcome.output.find("no plots: nothing to draw"), std::string::npos) << outcome.output;
  EXPECT_NE(outcome.output.find("no movie: nothing to draw"), std::string::npos) << outcome.output;
}

}
