#pragma once
// The curvatures of a surface in a few numbers.

#include "apps/AreaStatistics.h"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

class vtkPolyData;

namespace vesicle
{

/// Of each array by name. A vertex counts with a third of its triangles' areas, where
/// Curvature_Valid is 1.
using CurvatureSummary = std::vector<std::pair<std::string, AreaStatistics>>;

/// Of vtkVesicleCurvatureFilter's output: mean and Gaussian curvature, and those that were asked
/// for besides.
CurvatureSummary curvature_summary(vtkPolyData* surface, int bins);

/// Tables for people.
std::string to_text(const CurvatureSummary& summary);

/// As .json, or as .csv: a row a number (array, what, from, to, value). require_summary_ending()
/// throws InputError for other endings. Throws IoError.
void write_summary(const CurvatureSummary& summary, const std::filesystem::path& file);
void require_summary_ending(const std::filesystem::path& file);

}
