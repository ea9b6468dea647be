#pragma once
// Two runs, or two meshes, side by side.

#include "apps/MeshReport.h"

#include "solver/mesh/SurfaceDistance.h"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace vesicle
{

struct CompareSettings
{
  std::vector<std::string> columns; ///< of the tables of diagnostics; empty: the usual ones
  bool centred = false;             ///< shapes about their volume's centroids
};

struct ComparedValue
{
  std::optional<double> a, b;
};

struct RunComparison
{
  /// Lines of the scenes, all spelled out, that only one has: "a: time.step = 0.1".
  std::vector<std::string> settings;
  std::vector<std::string> columns;
  struct Moment
  {
    double time = 0;
    SurfaceDistance distance;
    std::vector<ComparedValue> values; ///< by column
  };
  std::vector<Moment> moments; ///< times of frames that both have
};

/// A run's folder, or its series. Throws InputError where there is no common time, or for a column
/// that a table doesn't have.
RunComparison compare_runs(
  const std::filesystem::path& a, const std::filesystem::path& b, const CompareSettings& settings);

struct MeshComparison
{
  MeshReport a, b;
  SurfaceDistance distance;
};
MeshComparison compare_meshes(
  const std::filesystem::path& a, const std::filesystem::path& b, bool centred);

std::string to_text(const RunComparison& comparison);
std::string to_text(const MeshComparison& comparison);
nlohmann::ordered_json to_json(const RunComparison& comparison);
nlohmann::ordered_json to_json(const MeshComparison& comparison);

}
