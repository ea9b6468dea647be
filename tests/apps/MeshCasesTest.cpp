// Files as other programs and accidents make them, and what `vesicle` has to say of each.

#include "Command.h"

#include "solver/mesh/MeshIntegrals.h"
#include "tests/solver/mesh/io/SampleFiles.h"
#include "vtkfilters/Filters/MeshFiles.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <fstream>
#include <functional>
#include <map>
#include <numbers>
#include <ostream>
#include <random>

namespace vesicle::test
{
namespace
{

using Json = nlohmann::json;
using std::filesystem::path;
using Check = std::function<void(const path& folder, const std::string& file)>;

struct MeshCase
{
  std::string name;
  std::string bytes;
  Check check;
};

void PrintTo(const MeshCase& mesh_case, std::ostream* out)
{
  *out << mesh_case.name;
}

struct Mesh
{
  Points points;
  Faces faces;

  TriangleMesh triangles() const
  {
    TriangleMesh mesh{ points, Triangles(static_cast<Eigen::Index>(faces.size()), 3) };
    for (std::size_t i = 0; i < faces.size(); ++i)
      for (int k = 0; k < 3; ++k)
        mesh.triangles(static_cast<Eigen::Index>(i), k) = static_cast<int>(faces[i][k]);
    return mesh;
  }
};

/// The unit sphere by longitude and latitude, outward, the poles the first and the last point.
Mesh sphere(int around, int down)
{
  using std::numbers::pi;
  Mesh mesh{ Points(2 + around * (down - 1), 3), {} };
  const auto last = mesh.points.rows() - 1;
  mesh.points.row(0) << 0, 0, 1;
  mesh.points.row(last) << 0, 0, -1;
  const auto at = [&](int i, int j) {
    return j == 0 ? 0 : j == down ? last : Eigen::Index(1 + (j - 1) * around + i % around);
  };
  for (int j = 1; j < down; ++j)
    for (int i = 0; i < around; ++i)
    {
      const double theta = pi * j / down, phi = 2 * pi * i / around;
      mesh.points.row(at(i, j)) << std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
        std::cos(theta);
    }
  for (int j = 0; j < down; ++j)
    for (int i = 0; i < around; ++i)
    {
      if (j > 0)
        mesh.faces.push_back({ at(i, j), at(i, j + 1), at(i + 1, j) });
      if (j < down - 1)
        mesh.faces.push_back({ at(i, j + 1), at(i + 1, j + 1), at(i + 1, j) });
    }
  return mesh;
}

Mesh small_sphere()
{
  return sphere(24, 12);
}

Faces turned(Faces faces)
{
  for (auto& face : faces)
    std::reverse(face.begin(), face.end());
  return faces;
}

Mesh together(const Mesh& a, const Mesh& b)
{
  Mesh both{ Points(a.points.rows() + b.points.rows(), 3), a.faces };
  both.points << a.points, b.points;
  for (auto face : b.faces)
  {
    for (auto& corner : face)
      corner += a.points.rows();
    both.faces.push_back(face);
  }
  return both;
}

void write(const path& file, const std::string& bytes)
{
  std::ofstream(file, std::ios::binary) << bytes;
}

Json info(const path& folder, const std::string& file)
{
  const auto outcome = vesicle_command(folder, { "info", file, "--json" });
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  return outcome.code == 0 ? Json::parse(outcome.output) : Json::object();
}

/// Of the file's points, by `vesicle curvature`, with what that says.
struct Curvatures
{
  Eigen::VectorXd mean; ///< in ascending order: an STL file numbers points in its own
  std::string messages;
};

Curvatures curvature(const path& folder, const std::string& file)
{
  const auto outcome = vesicle_command(folder, { "curvature", file, "-o", "curvature.vtp" });
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  if (outcome.code != 0)
    return {};
  const auto surface = read_mesh(folder / "curvature.vtp");
  vtkDataArray* mean = surface->GetPointData()->GetArray("Mean_Curvature");
  Curvatures result{ Eigen::VectorXd(mean->GetNumberOfTuples()), outcome.errors };
  for (Eigen::Index i = 0; i < result.mean.size(); ++i)
    result.mean[i] = mean->GetComponent(i, 0);
  std::sort(result.mean.begin(), result.mean.end());
  return result;
}

/// Exact, but for the rounding of coordinates to `precision` of the size.
Check gives(double area, double volume, double precision = 1e-12)
{
  return [=](const path& folder, const std::string& file)
  {
    const Json report = info(folder, file);
    ASSERT_FALSE(report.empty());
    EXPECT_NEAR(report["area"], area, precision * area);
    EXPECT_NEAR(report["volume"], volume, precision * volume);
    EXPECT_EQ(report["closed"], true);
  };
}

Check gives(const Mesh& mesh, double precision = 1e-12)
{
  return gives(flat_area(mesh.triangles()), flat_volume(mesh.triangles()), precision);
}

/// With exit code 2 and a message that has the file's name and these words.
Check refused(const std::vector<std::string>& words)
{
  return [=](const path& folder, const std::string& file)
  {
    const auto outcome = vesicle_command(folder, { "info", file });
    EXPECT_EQ(outcome.code, 2) << outcome.output << outcome.errors;
    EXPECT_NE(outcome.errors.find(file), std::string::npos) << outcome.errors;
    for (const auto& word : words)
      EXPECT_NE(outcome.errors.find(word), std::string::npos) << outcome.errors;
  };
}

/// A run of a step from the file.
Outcome run_from(
  const path& folder, const std::string& file, const std::vector<std::string>& more = {})
{
  write(folder / "scene.toml",
    "name = \"run\"\n[vesicle]\nfile = \"" + file +
      "\"\n[membrane]\nbending_rigidity = 1.0\n[time]\nend = 1e-5\noutput_every = 1e-5\n"
      "[accuracy]\npreset = \"fast\"\n");
  std::vector<std::string> arguments{ "run", "scene.toml", "--no-movie", "--no-plots", "-o",
    "run" };
  arguments.insert(arguments.end(), more.begin(), more.end());
  return vesicle_command(folder, arguments);
}

/// As `gives`, and a run begins from it.
Check gives_and_runs(const Mesh& mesh)
{
  return [=](const path& folder, const std::string& file)
  {
    gives(mesh)(folder, file);
    const auto outcome = run_from(folder, file);
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
  };
}

/// A sphere 10⁶ away whose shape is as near the origin, where coordinates have 10 digits less; in
/// another format it is, too, or what is lost is said.
Check is_far_sphere()
{
  return [](const path& folder, const std::string& file)
  {
    const Mesh mesh = small_sphere();
    gives(mesh, 1e-9)(folder, file);
    write(folder / "near.obj", obj_sample(mesh.points, mesh.faces));
    const auto near = curvature(folder, "near.obj"), far = curvature(folder, file);
    ASSERT_EQ(near.mean.size(), far.mean.size());
    // Second derivatives over edges of 0.07.
    EXPECT_LT((near.mean - far.mean).cwiseAbs().maxCoeff(), 1e-6);
    for (const std::string again :
      { "again.vtp", "again.vtu", "again.vtk", "again.stl", "again.ply", "again.obj", "again.off" })
    {
      const auto outcome = vesicle_command(folder, { "curvature", file, "-o", again });
      EXPECT_EQ(outcome.code, 0) << outcome.errors;
      if (outcome.errors.find("single precision") == std::string::npos)
        gives(mesh, 1e-9)(folder, again);
      else
        EXPECT_EQ(again, "again.stl");
    }
  };
}

bool is_told(const Json& report, const std::string& key, const Json& value)
{
  return report.contains(key) && report[key] == value;
}

/// Of `info --json`.
Check says(const std::map<std::string, Json>& values)
{
  return [=](const path& folder, const std::string& file)
  {
    const Json report = info(folder, file);
    for (const auto& [key, value] : values)
      EXPECT_TRUE(is_told(report, key, value)) << key << ": " << report[key];
  };
}

void expect_both_outward(const path& folder, const std::string& file)
{
  const auto [mean, messages] = curvature(folder, file);
  EXPECT_NEAR(mean.minCoeff(), 1, 0.05);
  EXPECT_NEAR(mean.maxCoeff(), 1, 0.05);
  EXPECT_NE(messages.find("inside out"), std::string::npos) << messages;
}

void expect_shell(const path& folder, const std::string& file)
{
  const auto [mean, messages] = curvature(folder, file);
  const Eigen::Index half = mean.size() / 2;
  EXPECT_LT((mean.head(half).array() + 1).abs().maxCoeff(), 0.05);
  EXPECT_LT((mean.tail(half).array() - 0.5).abs().maxCoeff(), 0.05);
  EXPECT_NE(messages.find("the inner side of a shell"), std::string::npos) << messages;
}

void expect_crossing_told(const path& folder, const std::string& file)
{
  EXPECT_EQ(info(folder, file)["self_crossing"].size(), 2u);
  const auto outcome = run_from(folder, file);
  EXPECT_EQ(outcome.code, 2);
  for (const std::string word : { file.c_str(), "the surface crosses itself: triangles " })
    EXPECT_NE(outcome.errors.find(word), std::string::npos) << outcome.errors;
  EXPECT_FALSE(std::filesystem::exists(folder / "run"));
}

void expect_merged_when_asked(const path& folder, const std::string& file)
{
  const auto open = run_from(folder, file);
  EXPECT_EQ(open.code, 2);
  EXPECT_NE(open.errors.find("--merge"), std::string::npos) << open.errors;
  const auto closed = run_from(folder, file, { "--merge", "1e-5" });
  EXPECT_EQ(closed.code, 0) << closed.errors;
  const auto gone_on =
    run_from(folder, file, { "--merge", "1e-5", "--resume", "--set", "time.end=2e-5" });
  EXPECT_EQ(gone_on.code, 0) << gone_on.errors;
  const auto another = run_from(folder, file, { "--merge", "2e-5", "--resume" });
  EXPECT_EQ(another.code, 2);
  EXPECT_NE(another.errors.find("merge"), std::string::npos) << another.errors;
}

/// Bytes changed in any three places: a mesh or a refusal, whatever the place.
void expect_no_crash(const path& folder, const std::string& file)
{
  const std::string whole = bytes_of(folder / file);
  std::mt19937 random(5);
  for (int round = 0; round < 10; ++round)
  {
    std::string bytes = whole;
    for (int k = 0; k < 3; ++k)
      bytes[random() % bytes.size()] = static_cast<char>(random());
    write(folder / file, bytes);
    const auto outcome = vesicle_command(folder, { "info", file });
    EXPECT_TRUE(outcome.code == 0 || outcome.code == 2) << outcome.code << outcome.errors;
  }
}

std::string with_joined_lines(const Mesh& mesh)
{
  std::string text;
  for (const char c : obj_sample(mesh.points, mesh.faces))
    text += c == ' ' ? " \\\n " : std::string(1, c);
  return text;
}

std::string free_form(const std::string& off)
{
  std::string text = off;
  std::replace(text.begin() + 4, text.end(), ' ', '\n');
  return text;
}

/// Each 7th cell marked as another piece's.
std::string ghost_cells(std::size_t cells)
{
  std::string text = "CELL_DATA " + std::to_string(cells) +
    "\nSCALARS vtkGhostType unsigned_char 1\nLOOKUP_TABLE default\n";
  for (std::size_t i = 0; i < cells; ++i)
    text += i % 7 == 0 ? "1\n" : "0\n";
  return text;
}

using Cases = std::vector<MeshCase>;

void add_dialects(Cases& cases)
{
  const Points l = l_prism_points();
  const Faces faces = l_prism_faces();
  cases.push_back({ "concave.obj", obj_sample(l, faces), gives(14, 3) });
  cases.push_back({ "concave.off", off_sample(l, faces), gives(14, 3) });
  cases.push_back({ "concave.ply", ply_sample(l, faces, "float"), gives(14, 3) });
  cases.push_back({ "concave.vtk", vtk_sample(l, faces), gives(14, 3) });
  const Mesh mesh = small_sphere();
  const std::string obj = obj_sample(mesh.points, mesh.faces);
  const std::string off = off_sample(mesh.points, mesh.faces);
  const auto off_of = [&](const char* keyword, const char* after)
  { return off_sample(mesh.points, mesh.faces, keyword, after); };
  cases.push_back({ "plain.obj", obj, gives(mesh) });
  cases.push_back({ "bom.obj", "\xef\xbb\xbf" + obj, gives(mesh) });
  cases.push_back({ "continued.obj", with_joined_lines(mesh), gives(mesh) });
  cases.push_back({ "coff.off", off_of("COFF", " 255 0 0 255"), gives(mesh) });
  cases.push_back({ "noff.off", off_of("NOFF", " 0 0 1"), gives(mesh) });
  cases.push_back({ "freeform.off", free_form(off), gives(mesh) });
}

void add_far(Cases& cases)
{
  const auto [points, faces] = small_sphere();
  const Points far = points.array() + 1e6;
  cases.push_back({ "far.ply", ply_sample(far, faces, "double"), is_far_sphere() });
  cases.push_back({ "far.stl", stl_sample(far, faces), is_far_sphere() });
  cases.push_back({ "far.obj", obj_sample(far, faces), is_far_sphere() });
  cases.push_back({ "far.vtk", vtk_sample(far, faces), is_far_sphere() });
  for (const auto order : { std::endian::little, std::endian::big })
    cases.push_back({ order == std::endian::little ? "far-le.ply" : "far-be.ply",
      binary_ply_sample(far, faces, order, true), is_far_sphere() });
}

void add_bodies(Cases& cases)
{
  const Mesh mesh = small_sphere();
  Mesh second = mesh;
  second.points.col(0).array() += 4;
  second.faces = turned(second.faces);
  const Mesh inside_out = together(mesh, second);
  cases.push_back(
    { "inside-out.vtk", vtk_sample(inside_out.points, inside_out.faces), expect_both_outward });
  const Mesh outer{ 2 * mesh.points, mesh.faces };
  const Mesh shell = together(outer, { mesh.points, turned(mesh.faces) });
  cases.push_back({ "shell.vtk", vtk_sample(shell.points, shell.faces), expect_shell });
}

void add_corners(Cases& cases)
{
  const Mesh mesh = small_sphere();
  const auto& [points, faces] = mesh;
  const std::map<std::string, std::int64_t> wrong{ { "huge", 900000000 }, { "negative", -7 },
    { "one-past", points.rows() } };
  for (const auto& [name, corner] : wrong)
  {
    Faces bad = faces;
    bad.back()[2] = corner;
    const auto told = refused(
      { "face " + std::to_string(faces.size() - 1) + " uses point " + std::to_string(corner) });
    const std::string file = "index-" + name;
    cases.push_back({ file + ".ply", ply_sample(points, bad, "float"), told });
    cases.push_back(
      { file + "-le.ply", binary_ply_sample(points, bad, std::endian::little, false), told });
    cases.push_back({ file + ".vtk", vtk_sample(points, bad), told });
    cases.push_back({ file + ".off", off_sample(points, bad), told });
  }
  Faces repeated = faces;
  repeated[0].insert(repeated[0].begin() + 1, repeated[0][1]);
  cases.push_back({ "repeated.obj", obj_sample(points, repeated), gives_and_runs(mesh) });
  cases.push_back({ "repeated.off", off_sample(points, repeated), gives_and_runs(mesh) });
  cases.push_back({ "repeated.ply", ply_sample(points, repeated, "double"), gives_and_runs(mesh) });
  cases.push_back({ "repeated.vtk", vtk_sample(points, repeated), gives_and_runs(mesh) });
}

void add_damage(Cases& cases)
{
  const auto [points, faces] = small_sphere();
  const std::string stl = binary_stl_sample(points, faces);
  cases.push_back({ "cut.stl", stl.substr(0, stl.size() * 6 / 10), refused({ "ends too early" }) });
  std::mt19937 random(3);
  std::string noise(20000, '\0');
  std::generate(noise.begin(), noise.end(), [&] { return static_cast<char>(random()); });
  cases.push_back({ "random.stl", noise, refused({ "not an STL file" }) });
  const std::map<std::string, std::string> whole{ { "whole.ply",
                                                    ply_sample(points, faces, "float") },
    { "whole-le.ply", binary_ply_sample(points, faces, std::endian::little, false) },
    { "whole.vtk", vtk_sample(points, faces) },
    { "whole-binary.vtk", binary_vtk_sample(points, faces, true) },
    { "whole-binary-3.vtk", binary_vtk_sample(points, faces, false) } };
  for (const auto& [name, bytes] : whole)
  {
    for (const int percent : { 30, 60, 90, 99 })
      cases.push_back({ "cut" + std::to_string(percent) + "-" + name,
        bytes.substr(0, bytes.size() * percent / 100), refused({ "ends too early" }) });
    cases.push_back({ "damaged-" + name, bytes, expect_no_crash });
  }
}

void add_topology(Cases& cases)
{
  const Mesh mesh = small_sphere();
  const auto& [points, faces] = mesh;
  Mesh own{ points, {} };
  for (std::size_t i = 0; i < faces.size(); ++i)
    if (i % 7 != 0)
      own.faces.push_back(faces[i]);
  cases.push_back({ "ghosts.vtk", vtk_sample(points, faces, ghost_cells(faces.size())),
    [area = flat_area(own.triangles())](const path& folder, const std::string& file)
    { EXPECT_NEAR(info(folder, file)["area"], area, 1e-12 * area); } });

  Mesh crossing = sphere(48, 24);
  for (auto x : crossing.points.rowwise())
    x[2] -= 2.6 * std::exp(-(x - Eigen::RowVector3d(0, 0, 1)).squaredNorm() / 0.15);
  cases.push_back(
    { "crossing.obj", obj_sample(crossing.points, crossing.faces), expect_crossing_told });

  Mesh apart{ Points(3 * faces.size(), 3), {} }; // the corners of each triangle are its own
  std::vector<int> copies(points.rows(), 0);
  for (std::size_t i = 0; i < faces.size(); ++i)
    for (int k = 0; k < 3; ++k)
      apart.points.row(3 * i + k) = (1 + 1e-7 * copies[faces[i][k]]++) * points.row(faces[i][k]);
  for (std::int64_t i = 0; i < apart.points.rows(); i += 3)
    apart.faces.push_back({ i, i + 1, i + 2 });
  cases.push_back({ "seams.obj", obj_sample(apart.points, apart.faces), expect_merged_when_asked });

  const Faces torn(faces.begin() + 1, faces.end());
  cases.push_back(
    { "torn.obj", obj_sample(points, torn), says({ { "closed", false }, { "genus", nullptr } }) });

  Mesh fin = together(mesh, { Points::Zero(1, 3), {} });
  fin.faces.push_back({ faces[0][0], faces[0][1], points.rows() });
  cases.push_back({ "fin.obj", obj_sample(fin.points, fin.faces),
    says({ { "manifold", false }, { "genus", nullptr } }) });

  Mesh above = mesh;
  above.points.col(2).array() += 2;
  Mesh touching = together(mesh, above);
  for (auto& face : touching.faces)
    std::replace(face.begin(), face.end(), touching.points.rows() - 1, Eigen::Index(0));
  cases.push_back({ "touching.obj", obj_sample(touching.points, touching.faces),
    says({ { "manifold", false }, { "genus", nullptr } }) });
}

Cases all_cases()
{
  Cases cases;
  for (const auto add :
    { add_dialects, add_far, add_bodies, add_corners, add_damage, add_topology })
    add(cases);
  return cases;
}

class MeshCases : public testing::TestWithParam<MeshCase>
{
};

}

TEST_P(MeshCases, AreWhatTheyAre)
{
  const TemporaryFolder folder;
  write(folder / GetParam().name, GetParam().bytes);
  GetParam().check(folder.path(), GetParam().name);
}

INSTANTIATE_TEST_SUITE_P(Files, MeshCases, testing::ValuesIn(all_cases()),
  [](const auto& mesh_case)
  {
    std::string name = mesh_case.param.name;
    std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '.' || c == '-'; }, '_');
    return name;
  });

}
